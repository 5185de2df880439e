// SPDX-License-Identifier: MIT
/// The damping of a lattice's stabilisation next to an edge that has an energy of its own.
#pragma once

#include <cmath>
#include <cstddef>
#include <nmbc/edge_energy.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/mirror_images.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// A damped lattice's damping as if it were an energy: what it takes in so long [dX/c] is twice
/// that of these squares at the velocities.
struct EdgeDamping {
    Lattice lattice;  ///< its symbol is tau sigma, its squares those of the stabilisation
    EdgeEnergy edge;  ///< what these squares are next to an edge
};

/// The lattice at G = 1, whose stabilisation is what is damped. Throws std::invalid_argument where
/// the lattice was made by hand.
inline Lattice stabilised_at_1(const Lattice& damped) {
    if (damped.table == nullptr) {
        throw std::invalid_argument(
            "this end of a damped lattice needs the squares that are damped, and a lattice made by "
            "hand has none");
    }
    return with_mirror_images(make_lattice(*damped.table, 1));
}

/// tau > 0, of a damping that is tau times the symbol of these squares. Throws
/// std::invalid_argument for any other.
inline double tau_of(const Lattice& damped, const std::vector<Lattice::Square>& squares) {
    const std::vector<double>& damping = damped.damping;
    std::vector<double> sigma(damped.symbol.size());
    for (const Lattice::Square& square : squares) {
        for (std::size_t i = 0; i < square.stencil.size(); ++i) {
            for (std::size_t j = i; j < square.stencil.size() && j - i < sigma.size(); ++j) {
                sigma[j - i] += square.weight * square.stencil[i] * square.stencil[j];
            }
        }
    }
    const double tau = damping[0] / sigma[0];
    bool is_known = tau > 0 && damping.size() == sigma.size();
    for (std::size_t m = 0; is_known && m < sigma.size(); ++m) {
        constexpr double roundings = 1e-12;  // of sums of some ten entries
        is_known = std::abs(damping[m] - tau * sigma[m]) <= roundings * damping[0];
    }
    if (!is_known) {
        throw std::invalid_argument(
            "this end knows a damping that is tau > 0 times the symbol of the stabilisation at "
            "G = 1, no other");
    }
    return tau;
}

/// edge_at_1: of stabilised_at_1(). Throws as tau_of().
inline EdgeDamping edge_damping(const Lattice& damped, Lattice at_1, EdgeEnergy edge_at_1) {
    const auto is_strain = [](const auto& square) { return square.part == EnergyPart::strain; };
    std::erase_if(at_1.energy, is_strain);
    const double tau = tau_of(damped, at_1.energy);
    const auto keep_damped = [&](auto& squares) {
        std::erase_if(squares, is_strain);
        for (auto& square : squares) {
            square.weight *= tau;
        }
    };
    keep_damped(at_1.energy);
    keep_damped(edge_at_1.squares);
    at_1.symbol = damped.damping;
    at_1.table = nullptr;
    return {std::move(at_1), std::move(edge_at_1)};
}

}  // namespace nmbc::detail
