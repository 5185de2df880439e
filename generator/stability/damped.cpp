// SPDX-License-Identifier: MIT
#include "generator/stability/damped.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "generator/stability/boundary_modes.hpp"
#include "generator/stability/polynomial_roots.hpp"
#include "generator/stability/reflection.hpp"

namespace nmbcgen {
namespace {

/// Where to look closely: what the undamped band and the zeros of C and B suggest, and as far above
/// the band as there are waves in time steps, or else four times its top.
std::vector<double> all_frequencies(std::vector<double> frequencies, double time_step) {
    const double top = frequencies.back();
    constexpr double lowest = 1e-5;
    constexpr double highest = 4;
    const double end = time_step > 0 ? (1 - 1e-9) * 2 / time_step : highest * top;
    for (const double part : {0.05, 0.25, 0.5, 0.75, 1.05, 1.25, 2.0}) {
        frequencies.push_back(part * top);
    }
    std::erase_if(frequencies, [&](double omega) { return omega < lowest * top || omega >= end; });
    frequencies.insert(frequencies.end(), {lowest * top, end});
    std::ranges::sort(frequencies);
    return frequencies;
}

}  // namespace

bool interior_is_stable(const HalfSpace& h) {
    if (h.time_step == 0) {
        return true;  // sigma >= 0: it is a sum of squares
    }
    const std::vector<double>& square = h.symbol_in_cosine;
    const std::vector<double>& damping = h.damping_in_cosine;
    const double half_step = h.time_step / 2;
    std::vector<double> load;
    for (std::size_t i = 0; i < square.size(); ++i) {
        load.push_back(half_step * (half_step * square[i] + damping[i]));
    }
    std::vector<double> extrema{-1, 1};
    for (const std::complex<double> x : polynomial_roots(derivative(load))) {
        extrema.push_back(std::clamp(x.real(), -1.0, 1.0));
    }
    return std::ranges::all_of(extrema,
                               [&](double x) { return evaluate_with_slope(load, x).value <= 1; });
}

Peak damped_amplification(const HalfSpace& left, const HalfSpace& right,
                          const std::vector<double>& critical, std::size_t nodes, double enough) {
    // Where only `enough` counts, what is far below it is told by a bound.
    const double coarse = std::isfinite(enough) ? enough / 16 : 0;
    OutgoingModes waves(left);
    const auto round_trip = [&](double omega) {
        const std::vector<Mode> modes = waves.at(omega);
        const Reflection one = reflection(left, omega, modes);
        return damped_round_trip_supremum(
            one, &right == &left ? one : reflection(right, omega, modes), nodes, coarse);
    };
    return largest_over_band(all_frequencies(critical, left.time_step), round_trip, enough,
                             Sampling::smooth);
}

Peak damped_amplification(const HalfSpace& both, std::size_t nodes) {
    return damped_amplification(both, both, critical_frequencies(both), nodes);
}

}  // namespace nmbcgen
