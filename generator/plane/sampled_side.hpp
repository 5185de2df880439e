// SPDX-License-Identifier: MIT
/// Conditions on the ghost layers of a side of a plane lattice, and what is found of them on
/// samples (sampled_growth.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/plane/sampled_growth.hpp"
#include "generator/plane/side_condition.hpp"
#include "generator/plane/side_reflection.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// A boundary of ghost layers and what was found of it.
struct GhostSide {
    std::string name;
    SideCondition condition;
    LargestAmplification amplification{};
    double growth_of_modes = 0;         ///< rate of one side alone [sqrt(E/rho)/dX]; 0: none
    double growth_in_strips = 0;        ///< 0 where it is roundings
    double growth_with_corners = 0;     ///< in a box; likewise
    std::optional<Rational> damping{};  ///< the smallest tau tried with which nothing grows
    /// The largest leapfrog step, over the longest one, in which the grade is what it is in
    /// continuous time, as in all shorter ones that are looked at; 0: none, or not sought.
    double steps = 0;
    /// Opposite which sides strips grow: "fixed", "free".
    std::vector<std::string> grows_opposite{};

    bool grows() const {
        return growth_of_modes > 0 || growth_in_strips > 0 || growth_with_corners > 0;
    }
    bool is_stable_in_continuous_time() const;  ///< contractive or paired
    bool is_stable() const;                     ///< in steps too
};

/// "grows", "amplifies", "paired", "contractive", or "unknown" where most waves cannot be told.
std::string grade_of(const GhostSide& side);

/// Finds how the side amplifies waves and whether a half plane grows at one of them, strips of the
/// lattice between two or a box between four, in continuous time; where none does, in which steps.
void sample_side(GhostSide& side, const PlaneLattice& lattice);

/// Whether a half plane of this lattice grows at such a side, strips between two or a box between
/// four, in continuous time.
bool grows_in_lattice(const PlaneLattice& lattice, const SideCondition& condition);

/// Whether strips between a side that has been sampled and another one grow, in continuous time or
/// in the largest steps of its grade. Strips so narrow that a free side changes all of their layers
/// are not looked at.
bool grows_opposite(const GhostSide& side, const PlaneLattice& lattice, const OppositeSide& other);

}  // namespace nmbcgen
