// SPDX-License-Identifier: MIT
/// Energies of a chain.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/chain.hpp>
#include <nmbc/folded_energy.hpp>
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
    /// keeps it exactly in a chain without ends, or between two free ones, or mirrors on which
    /// nothing is given (beside a fixed end, the strain of the ghost nodes is missing); `total` is
    /// above it by O(dt^2), and swings.
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

/// Sums over a range of nodes without their common factors.
struct EnergySums {
    FoldedBlock::Sum kinetic{};
    FoldedBlock::Sum strain{};         ///< (now + before)^2 of its squares
    FoldedBlock::Sum stabilisation{};  ///< likewise
    FoldedBlock::Sum change{};         ///< (now - before)^2 of all squares
};

/// Adds what the edge at an end has at its nodes first .. last-1, if it has an energy of its own,
/// to the sums of node 0. Returns how many of these nodes there are.
template <class Real>
std::size_t add_edge(const BasicChain<Real>& chain, End end, std::size_t first, std::size_t last,
                     EnergySums& sums) {
    const EdgeEnergy* const edge = chain.edge_energy(end);
    const std::size_t own = edge == nullptr ? 0 : std::min(edge->mass.size(), last);
    if (first >= own) {
        return 0;
    }
    const std::size_t outermost =
        chain.first_interior() + (end == End::left ? 0 : chain.parameters().nodes - 1);
    const std::ptrdiff_t inwards = end == End::left ? 1 : -1;
    const NodeLine<const Real> u(&chain.displacement()[outermost], inwards);
    const NodeLine<const Real> v(&chain.velocity()[outermost], inwards);
    for (std::size_t node = first; node < own; ++node) {
        const auto velocity = static_cast<double>(v[node]);
        sums.kinetic[0] += edge->mass[node] * velocity * velocity;
    }
    for (const auto& [node, part, weight, stencil] : edge->squares) {
        if (node < first || node >= own) {
            continue;
        }
        double now = 0;
        double rate = 0;
        for (std::size_t i = 0; i < stencil.size(); ++i) {
            now += stencil[i] * static_cast<double>(u[i]);
            rate += stencil[i] * static_cast<double>(v[i]);
        }
        const double before = now - chain.parameters().time_step * rate;
        (part == EnergyPart::strain ? sums.strain : sums.stabilisation)[0] +=
            weight * (now + before) * (now + before);
        sums.change[0] += weight * (now - before) * (now - before);
    }
    return own - first;
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
    detail::FoldedBlock block(detail::reach_of(chain.folded_energy()));
    const std::size_t begin_inside = begin + detail::add_edge(chain, End::left, first, last, sums);
    const std::size_t end_inside =
        end - detail::add_edge(chain, End::right, p.nodes - last, p.nodes - first, sums);
    for (std::size_t node = begin_inside; node < end_inside; node += detail::FoldedBlock::nodes) {
        const std::size_t nodes = std::min(end_inside - node, detail::FoldedBlock::nodes);
        for (std::size_t i = 0; i < nodes; ++i) {
            const double velocity = v[node + i];
            sums.kinetic[i] += velocity * velocity;
        }
        block.read(u, v, dt, node, nodes);
        for (const detail::FoldedSquare& square : chain.folded_energy()) {
            detail::EnergySums& to = square.is_below_0 ? below_0 : sums;
            block.add(square, square.part == EnergyPart::strain ? to.strain : to.stabilisation,
                      to.change);
        }
    }
    Energies result;
    double change = 0;
    for (std::size_t i = 0; i < detail::FoldedBlock::nodes; ++i) {
        result.kinetic += sums.kinetic[i];
        result.strain += sums.strain[i] - below_0.strain[i];
        result.stabilisation += sums.stabilisation[i];
        change += sums.change[i] - below_0.change[i];
    }
    const double stiffness = p.youngs_modulus / p.spacing / 2;
    result.kinetic *= p.spacing * p.density / 2;
    result.strain *= stiffness / 4;
    result.stabilisation *= stiffness / 4;
    // now * before = ((now + before)^2 - (now - before)^2) / 4
    result.staggered = result.total() - stiffness / 4 * change;
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
