// SPDX-License-Identifier: MIT
/// Energies of a chain.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/chain.hpp>
#include <numeric>
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
        sum += stencil[i] * static_cast<double>(first[i]);
    }
    return sum;
}

/// Sums over a range of nodes without their common factors, one for each node of a block: compilers
/// vectorise over the nodes, and many short sums round less than a long one.
struct EnergySums {
    static constexpr std::size_t nodes = 64;
    using Sum = std::array<double, nodes>;
    Sum kinetic{};
    Sum strain{};         ///< (now + before)^2 of its squares
    Sum stabilisation{};  ///< likewise
    Sum staggered{};      ///< now * before of all squares
};

/// Adds the terms of one square at `nodes` nodes: (now + before)^2 and now * before, where now and
/// before are the stencil at u^{k+1} and at u^k, times the root of the weight. u and v begin where
/// the first node's stencil does. Stencils of horizons to 6 have loops of their own, in which the
/// compiler knows their size.
template <std::size_t Size = 1, class Real>
void add_square(std::span<const double> stencil, double root, double dt, const Real* u,
                const Real* v, std::size_t nodes, EnergySums::Sum& middle,
                EnergySums::Sum& staggered) {
    const auto add = [&](auto apply_to) {
        double* __restrict middle_sums = middle.data();
        double* __restrict staggered_sums = staggered.data();
        for (std::size_t node = 0; node < nodes; ++node) {
            const double now = apply_to(u + node);
            const double before = now - dt * apply_to(v + node);
            middle_sums[node] += (now + before) * (now + before);
            staggered_sums[node] += now * before;
        }
    };
    if constexpr (Size > widest_fixed_reach + 1) {
        add([=](const Real* first) { return root * detail::apply(stencil, first); });
    } else if (stencil.size() == Size) {
        std::array<double, Size> entries{};
        std::ranges::transform(stencil, entries.begin(),
                               [=](double entry) { return root * entry; });
        add([=](const Real* first) { return detail::apply(entries, first); });
    } else {
        add_square<Size + 1>(stencil, root, dt, u, v, nodes, middle, staggered);
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

    detail::EnergySums sums;
    detail::EnergySums below_0;  // of bonds that are
    for (std::size_t node = begin; node < end; node += detail::EnergySums::nodes) {
        const std::size_t nodes = std::min(end - node, detail::EnergySums::nodes);
        for (std::size_t i = 0; i < nodes; ++i) {
            const double velocity = v[node + i];
            sums.kinetic[i] += velocity * velocity;
        }
        for (const auto& [part, weight, stencil] : chain.lattice().energy) {
            const std::size_t start = node - stencil.size() / 2;  // at most ghosts() before it
            detail::EnergySums& to = weight < 0 ? below_0 : sums;
            detail::add_square(
                std::span(stencil), std::sqrt(std::abs(weight)), dt, &u[start], &v[start], nodes,
                part == EnergyPart::strain ? to.strain : to.stabilisation, to.staggered);
        }
    }
    Energies result;
    for (std::size_t i = 0; i < detail::EnergySums::nodes; ++i) {
        result.kinetic += sums.kinetic[i];
        result.strain += sums.strain[i] - below_0.strain[i];
        result.stabilisation += sums.stabilisation[i];
        result.staggered += sums.staggered[i] - below_0.staggered[i];
    }
    const double stiffness = p.youngs_modulus / p.spacing / 2;
    result.kinetic *= p.spacing * p.density / 2;
    result.strain *= stiffness / 4;
    result.stabilisation *= stiffness / 4;
    result.staggered = result.kinetic + stiffness * result.staggered;
    if (!chain.damped().empty()) {
        const auto damped = chain.damped().subspan(begin, end - begin);
        result.damped = std::reduce(damped.begin(), damped.end());
    }
    return result;
}

/// The energies of the whole interior.
template <class Real>
Energies energies(const BasicChain<Real>& chain) {
    return energies(chain, 0, chain.parameters().nodes);
}

}  // namespace nmbc
