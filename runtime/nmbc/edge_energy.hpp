// SPDX-License-Identifier: MIT
/// The energy of a chain next to an end: where it ends on a node, the outermost nodes have masses,
/// and squares of energy, of their own; beside a mirror they have half of the whole chain's.
#pragma once

#include <cstddef>
#include <nmbc/lattice.hpp>
#include <utility>
#include <vector>

namespace nmbc {

/// What is given on the surface.
enum class OnSurface {
    displacement,  ///< Dirichlet: u [length]
    traction,      ///< Neumann: the force on the body per area [stress], along X as u is
};

/// In units dX = E = density = 1. Nodes are counted inwards from the outermost one, 0. Whatever the
/// numbers are, the energy of the chain is a sum of squares while masses and weights are positive.
struct EdgeEnergy {
    /// weight * (sum_i stencil[i] u_i)^2 / 2.
    struct Square {
        std::size_t node;  ///< whose energy it is
        EnergyPart part;
        double weight;
        std::vector<double> stencil;
    };
    std::vector<double> mass{};     ///< of the nodes whose squares these are; further in it is 1
    std::vector<Square> squares{};  ///< all that these nodes have, in the place of the lattice's
};

namespace detail {

/// What the node on a mirror has of the whole chain's energy, which is twice the body's while
/// nothing is given. The lattice's squares have mirror images.
inline EdgeEnergy node_mirror_energy(const Lattice& lattice, OnSurface given) {
    EdgeEnergy energy{.mass = {0.5}};
    for (const auto& [part, weight, stencil] : lattice.energy) {
        const std::size_t half = stencil.size() / 2;
        std::vector<double> folded(stencil.begin() + std::ptrdiff_t(half), stencil.end());
        for (std::size_t k = 1; k <= half; ++k) {
            folded[k] += given == OnSurface::traction ? stencil[half - k] : -stencil[half - k];
        }
        energy.squares.push_back({0, part, weight / 2, std::move(folded)});
    }
    return energy;
}

}  // namespace detail
}  // namespace nmbc
