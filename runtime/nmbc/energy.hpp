// SPDX-License-Identifier: MIT
/// Energies of a chain.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/chain.hpp>
#include <span>
#include <stdexcept>
#include <utility>

namespace nmbc {

/// Energies per cross-section area at t - dt/2, where the velocity is known; the displacement
/// there is the mean of its two neighbours in time.
struct Energies {
    double kinetic = 0;        ///< dX sum rho v^2 / 2
    double strain = 0;         ///< dX sum E eps^2 / 2, eps the nodal strain (16)
    double stabilisation = 0;  ///< dX sum (E G / n^4) |z|^2 / 2 over the bonds, z of (34)
    /// Kinetic energy plus the potential one with u^k and u^{k+1} in its two places. Leapfrog
    /// keeps it exactly in a chain without ends, or between two free ones (beside a fixed end, the
    /// strain of the ghost nodes is missing); `total` is above it by O(dt^2), and swings.
    double staggered = 0;
    /// Taken out at these nodes by the damping force since the start, with the scheme's own
    /// velocities: between free ends, `staggered` falls by exactly as much as `damped` rises. Other
    /// ends and prescribed velocities do work of their own.
    double damped = 0;

    /// Of the chain, so that `damped` is not in it.
    double total() const { return kinetic + strain + stabilisation; }
};

namespace detail {

template <class Real>
double apply(std::span<const double> stencil, const Real* first) {
    double sum = 0;
    for (std::size_t i = 0; i < stencil.size(); ++i) {
        sum += stencil[i] * static_cast<double>(first[i]);
    }
    return sum;
}

/// What one square of the energy has at each node of a block, before it is added up.
struct SquareTerms {
    static constexpr std::size_t nodes = 64;
    std::array<double, nodes> middle;     ///< of u half-way between its two levels
    std::array<double, nodes> staggered;  ///< of u^k and u^{k+1}
};

/// Finds the terms of `nodes` nodes; u and v begin where the first node's stencil does. The size of
/// the stencil is known to the compiler, which vectorises over the nodes.
template <class Real, std::size_t... J>
void find_terms(const double* stencil, std::index_sequence<J...> /*size*/, double factor, double dt,
                const Real* u, const Real* v, std::size_t nodes, SquareTerms& terms) {
    double* __restrict middle = terms.middle.data();
    double* __restrict staggered = terms.staggered.data();
    for (std::size_t node = 0; node < nodes; ++node) {
        double now = 0;
        ((now += stencil[J] * static_cast<double>(u[node + J])), ...);
        double rate = 0;
        ((rate += stencil[J] * static_cast<double>(v[node + J])), ...);
        const double half_way = now - dt / 2 * rate;
        middle[node] = factor * half_way * half_way;
        staggered[node] = factor * now * (now - dt * rate);
    }
}

/// The same for a stencil of any size; those of horizons to 6 have loops of their own.
template <std::size_t Size = 1, class Real>
void find_terms(std::span<const double> stencil, double factor, double dt, const Real* u,
                const Real* v, std::size_t nodes, SquareTerms& terms) {
    if constexpr (Size > widest_fixed_reach + 1) {
        for (std::size_t node = 0; node < nodes; ++node) {
            const double now = apply(stencil, u + node);
            const double rate = apply(stencil, v + node);
            const double half_way = now - dt / 2 * rate;
            terms.middle[node] = factor * half_way * half_way;
            terms.staggered[node] = factor * now * (now - dt * rate);
        }
    } else if (stencil.size() == Size) {
        find_terms(stencil.data(), std::make_index_sequence<Size>{}, factor, dt, u, v, nodes,
                   terms);
    } else {
        find_terms<Size + 1>(stencil, factor, dt, u, v, nodes, terms);
    }
}

}  // namespace detail

/// The energies of the interior nodes first .. last-1 (counted from 0, ghosts and layers left out):
/// each node's own kinetic energy, strain energy and bond energies, as Nicely 2018 sums them.
/// Counting also the squares of ghost nodes that an interior node takes part in would balance the
/// power of the ghosts exactly, but lets the sum rise for a moment where a wave passes an end.
/// Throws std::invalid_argument unless first < last <= interior nodes.
template <class Real>
Energies energies(const BasicChain<Real>& chain, std::size_t first, std::size_t last) {
    const ChainParameters& p = chain.parameters();
    if (first >= last || last > p.nodes) {
        throw std::invalid_argument("energies: the nodes must be a range within the interior");
    }
    const auto u = chain.displacement();
    const auto v = chain.velocity();
    const double dt = p.time_step;
    const std::size_t begin = first + chain.first_interior();
    const std::size_t end = last + chain.first_interior();

    Energies result;
    for (std::size_t node = begin; node < end; ++node) {
        const double velocity = v[node];
        result.kinetic += p.spacing * p.density * velocity * velocity / 2;
    }
    result.staggered = result.kinetic;
    if (!chain.damped().empty()) {
        for (const double damped : chain.damped().subspan(begin, end - begin)) {
            result.damped += damped;
        }
    }
    for (const Lattice::Square& square : chain.lattice().energy) {
        const std::size_t half_width = square.stencil.size() / 2;  // at most ghosts() / 2
        const double factor = square.weight * p.youngs_modulus / p.spacing / 2;
        double energy = 0;
        detail::SquareTerms terms{};
        for (std::size_t node = begin; node < end; node += detail::SquareTerms::nodes) {
            const std::size_t nodes = std::min(end - node, detail::SquareTerms::nodes);
            detail::find_terms(square.stencil, factor, dt, &u[node - half_width],
                               &v[node - half_width], nodes, terms);
            for (std::size_t i = 0; i < nodes; ++i) {
                energy += terms.middle[i];
                result.staggered += terms.staggered[i];
            }
        }
        (square.part == EnergyPart::strain ? result.strain : result.stabilisation) += energy;
    }
    return result;
}

/// The energies of the whole interior.
template <class Real>
Energies energies(const BasicChain<Real>& chain) {
    return energies(chain, 0, chain.parameters().nodes);
}

}  // namespace nmbc
