// SPDX-License-Identifier: MIT
#include "generator/plane/sampled_growth.hpp"

#include <algorithm>
#include <cmath>

#include "generator/plane/box.hpp"
#include "generator/plane/side_growth.hpp"

namespace nmbcgen {
namespace {

constexpr std::size_t band_steps = 16;  // of wave numbers in each direction

/// 0 where it is roundings of the eigenvalues of some hundred states.
double told(double growth, double highest_frequency) {
    constexpr double roundings = 1e-9;
    return growth > roundings * highest_frequency ? growth : 0;
}

/// How many layers inwards its ghost layers look.
std::size_t width_of(const SideCondition& condition) {
    std::size_t width = 0;
    for (const ShiftPolynomial& residual : condition.residual) {
        for (const std::vector<double>& shifts : residual) {
            width = std::max(width, shifts.size() - 1);
        }
    }
    return width;
}

std::size_t needed_by(const StripSide& side, std::size_t reach) {
    const auto* const condition = std::get_if<SideCondition>(&side);
    return condition != nullptr ? width_of(*condition) : 2 * reach;
}

/// Rates of the samples, one after the other, until `enough` of one.
template <class Enough>
double largest_in_strips(const PlaneLattice& lattice, const SideCondition& condition,
                         const OppositeSide& opposite, std::span<const std::size_t> layers,
                         double time_step, Enough enough) {
    const double highest = std::sqrt(highest_eigenvalue(lattice, band_steps));
    double largest = 0;
    for (const std::size_t asked : layers) {
        for (const double wave_number : strip_wave_numbers(side_samples.wave_numbers)) {
            const LateralChain chain = lateral_chain(lattice, wave_number);
            const Strip strip{.left = condition,
                              .right = opposite(wave_number),
                              .layers = asked,
                              .time_step = time_step};
            Strip wide = strip;
            wide.layers =
                std::max({asked, width_of(condition), needed_by(strip.right, chain.reach())});
            largest = std::max(largest, told(growth_in_strip(chain, wide), highest));
            if (enough(largest)) {
                return largest;
            }
        }
    }
    return largest;
}

}  // namespace

double longest_step(const PlaneLattice& lattice) {
    constexpr std::size_t steps = 64;
    PlaneLattice damped = lattice;
    for (PlaneBond& bond : damped.bonds) {
        bond.stiffness = bond.damping;
    }
    const double damping = highest_eigenvalue(damped, steps);
    return 4 / (damping + std::sqrt(damping * damping + 4 * highest_eigenvalue(lattice, steps)));
}

double growth_in_strips(const PlaneLattice& lattice, const SideCondition& condition,
                        const OppositeSide& opposite, std::span<const std::size_t> layers,
                        double time_step) {
    return largest_in_strips(lattice, condition, opposite, layers, time_step,
                             [](double) { return false; });
}

bool strips_grow(const PlaneLattice& lattice, const SideCondition& condition,
                 const OppositeSide& opposite, std::span<const std::size_t> layers,
                 double time_step) {
    return largest_in_strips(lattice, condition, opposite, layers, time_step,
                             [](double rate) { return rate > 0; }) > 0;
}

double growth_of_modes(const PlaneLattice& lattice, const SideCondition& condition) {
    double largest = 0;
    for (const double wave_number : strip_wave_numbers(side_samples.wave_numbers)) {
        largest = growth_of_side(lateral_chain(lattice, wave_number), condition, largest)
                      .value_or(largest);
    }
    return largest;
}

OppositeSide always(const SideCondition& condition) {
    return [condition](double) { return StripSide(condition); };
}

double growth_with_corners(const PlaneLattice& lattice, const SideCondition& condition,
                           double time_step) {
    const std::size_t even = 2 * ((width_of(condition) + 1) / 2);
    return told(growth_in_box(lattice, {.across_x = condition, .across_y = condition},
                              std::max(side_samples.nodes, even), time_step),
                std::sqrt(highest_eigenvalue(lattice, band_steps)));
}

}  // namespace nmbcgen
