// SPDX-License-Identifier: MIT
/// What is found of a side on samples: strips, a box, and waves that are reflected, in continuous
/// time and in leapfrog steps.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>

#include "generator/plane/side_condition.hpp"
#include "generator/plane/strip.hpp"

namespace nmbcgen {

/// How finely sides are sampled. Strips and boxes are wider where a condition reaches across them.
struct SideSamples {
    std::array<std::size_t, 4> layers{5, 9, 20, 31};  ///< of the strips
    std::size_t wave_numbers = 40;  ///< steps of those along them, the first of them halved, too
    std::size_t nodes = 12;         ///< of the box between four, along an edge
    std::size_t waves = 24;         ///< in each direction
    /// Of time steps, over the longest one that is stable in the lattice.
    std::array<double, 9> steps{.1, .2, .3, .4, .5, .6, .7, .8, .9};
};
inline constexpr SideSamples side_samples;

/// Leapfrog is stable in shorter steps, without sides: dt^2 l + 2 dt d = 4, with l and d the
/// highest eigenvalues of stiffness and damping that are found on wave vectors.
double longest_step(const PlaneLattice& lattice);

/// What is opposite in a strip, at a wave number along it.
using OppositeSide = std::function<StripSide(double wave_number)>;

/// The largest rate [sqrt(E/rho)/dX] in the strips between a side and the opposite one; 0 where it
/// is roundings. layers: fewer than the strips need are made as many.
double growth_in_strips(const PlaneLattice& lattice, const SideCondition& condition,
                        const OppositeSide& opposite, std::span<const std::size_t> layers,
                        double time_step);

/// Whether it is above 0, found sooner where it is.
bool strips_grow(const PlaneLattice& lattice, const SideCondition& condition,
                 const OppositeSide& opposite, std::span<const std::size_t> layers,
                 double time_step);

/// The largest rate of a mode of the side alone (side_growth.hpp) at the wave numbers of the
/// strips, where modes can be told, in continuous time; 0: none.
double growth_of_modes(const PlaneLattice& lattice, const SideCondition& condition);

/// Opposite its like.
OppositeSide always(const SideCondition& condition);

/// In the box between four like sides, likewise.
double growth_with_corners(const PlaneLattice& lattice, const SideCondition& condition,
                           double time_step);

}  // namespace nmbcgen
