// SPDX-License-Identifier: MIT
/// Energies of a chain.
#pragma once

#include <cstddef>
#include <nmbc/chain.hpp>
#include <span>
#include <stdexcept>

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
        sum += stencil[i] * first[i];
    }
    return sum;
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
        for (std::size_t node = begin; node < end; ++node) {
            const double now = detail::apply(square.stencil, &u[node - half_width]);
            const double rate = detail::apply(square.stencil, &v[node - half_width]);
            const double middle = now - dt / 2 * rate;
            energy += factor * middle * middle;
            result.staggered += factor * now * (now - dt * rate);
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
