// SPDX-License-Identifier: MIT
#include "generator/plane/sampled_side.hpp"

#include <algorithm>
#include <iterator>
#include <string>

namespace nmbcgen {
namespace {

/// Samples reach 1 at the edges of bands, where waves stand, up to the roundings of a double root.
constexpr double sampled_limit = 1 + 1e-6;

std::string grade_of_amplification(const LargestAmplification& seen) {
    if (2 * seen.examined < seen.samples) {
        return "unknown";
    }
    if (seen.value.alone <= sampled_limit) {
        return "contractive";
    }
    return seen.value.paired <= sampled_limit ? "paired" : "amplifies";
}

/// Strips first, which tell most and take least time; boxes from the longest of the steps down.
double steps_of_grade(const PlaneLattice& lattice, const SideCondition& condition,
                      const std::string& grade) {
    const double longest = longest_step(lattice);
    const auto& shares = side_samples.steps;
    const auto* const end = std::ranges::find_if(shares, [&](double share) {
        const double dt = share * longest;
        return strips_grow(lattice, condition, always(condition), side_samples.layers, dt) ||
               grade_of_amplification(
                   largest_amplification(lattice, condition, side_samples.waves, dt)) != grade;
    });
    const auto held =
        std::find_if(std::make_reverse_iterator(end), shares.rend(), [&](double share) {
            return growth_with_corners(lattice, condition, share * longest) == 0;
        });
    return held == shares.rend() ? 0 : *held;
}

}  // namespace

bool GhostSide::is_stable_in_continuous_time() const {
    const std::string grade = grade_of(*this);
    return grade == "contractive" || grade == "paired";
}

bool GhostSide::is_stable() const {
    return is_stable_in_continuous_time() && steps > 0;
}

std::string grade_of(const GhostSide& side) {
    return side.grows() ? "grows" : grade_of_amplification(side.amplification);
}

void sample_side(GhostSide& side, const PlaneLattice& lattice) {
    side.amplification = largest_amplification(lattice, side.condition, side_samples.waves);
    side.growth_of_modes = growth_of_modes(lattice, side.condition);
    side.growth_in_strips =
        growth_in_strips(lattice, side.condition, always(side.condition), side_samples.layers, 0);
    side.growth_with_corners = growth_with_corners(lattice, side.condition, 0);
    if (side.is_stable_in_continuous_time()) {
        side.steps = steps_of_grade(lattice, side.condition, grade_of(side));
    }
}

bool grows_in_lattice(const PlaneLattice& lattice, const SideCondition& condition) {
    return strips_grow(lattice, condition, always(condition), side_samples.layers, 0) ||
           growth_with_corners(lattice, condition, 0) > 0 ||
           growth_of_modes(lattice, condition) > 0;
}

bool grows_opposite(const GhostSide& side, const PlaneLattice& lattice, const OppositeSide& other) {
    return strips_grow(lattice, side.condition, other, side_samples.layers, 0) ||
           (side.steps > 0 && strips_grow(lattice, side.condition, other, side_samples.layers,
                                          side.steps * longest_step(lattice)));
}

}  // namespace nmbcgen
