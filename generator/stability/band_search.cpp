// SPDX-License-Identifier: MIT
#include "generator/stability/band_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace nmbcgen {
namespace {

/// Where in (0, 1) a piece is sampled, ascending: to a ten-millionth of its ends where they are
/// sharp, else to a ten-thousandth.
std::vector<double> sample_places(Sampling sampling) {
    const bool sharp = sampling == Sampling::sharp;
    std::vector<double> places;
    for (double distance = sharp ? 1e-7 : 1e-4; distance < 0.002; distance *= 4) {
        places.push_back(distance);
        places.push_back(1 - distance);
    }
    const int count = sharp ? 40 : 16;
    for (int i = 1; i < count; ++i) {
        places.push_back((1 - std::cos(std::numbers::pi * i / count)) / 2);
    }
    std::ranges::sort(places);
    return places;
}

/// Golden-section search for a maximum near `peak`, between the samples beside it. It stops early
/// where the maximum comes out no higher than `counts`. Not Boost's brent_find_minima, which cannot
/// stop so, and whose parabolas know no infinite values; committed certificates hang on the bits of
/// what is found.
Peak refined(const std::function<double(double)>& function, Peak peak, Peak left, Peak right,
             double counts) {
    const auto at = [&function](double omega) { return Peak{function(omega), omega}; };
    const auto inset = [&left, &right] {
        return (right.omega - left.omega) * (1 - 1 / std::numbers::phi);
    };
    Peak one = at(left.omega + inset());
    Peak other = at(right.omega - inset());
    constexpr int most = 20;
    for (int i = 0; i < most; ++i) {
        const bool left_is_higher = one.value > other.value;
        const Peak& higher = left_is_higher ? one : other;
        if (higher.value > peak.value) {
            peak = higher;
        }
        if (left_is_higher) {
            right = std::exchange(other, one);
            one = at(left.omega + inset());
        } else {
            left = std::exchange(one, other);
            other = at(right.omega - inset());
        }
        // A parabola through the ends and the peak rises by less than 4 times their difference. A
        // resonance between the samples is no parabola before the search is a fiftieth as wide.
        constexpr int resolved = 8;
        const double difference = peak.value - std::min(left.value, right.value);
        if (i >= resolved && peak.value + 4 * difference <= counts) {
            break;
        }
    }
    return peak;
}

Peak largest_in_piece(double low, double high, const std::function<double(double)>& function,
                      double enough, const std::vector<double>& places) {
    // Roundings that send a value astray, where two wave numbers are hard to tell apart, do not do
    // so at the next frequency, too: a value above `enough` has to be so there as well.
    const auto confirmed = [&](double place, double value) {
        const double next = place + 1e-3 * (place < 0.5 ? place : place - 1);
        return std::min(value, function(low + (high - low) * next));
    };
    // Nearer to an end frequencies are not told apart by doubles well enough.
    const double nearest = 1e-13 * high;
    std::vector<Peak> samples;
    samples.reserve(places.size());
    for (const double place : places) {
        const double omega = low + (high - low) * place;
        if (omega - low < nearest || high - omega < nearest) {
            continue;
        }
        const double value = function(omega);
        samples.push_back({value > enough ? confirmed(place, value) : value, omega});
        if (samples.back().value > enough) {
            return samples.back();
        }
    }
    if (samples.empty()) {
        return {};
    }
    std::size_t best = 0;
    for (bool settled = false; !settled;) {
        best = std::size_t(std::ranges::max_element(samples, {}, &Peak::value) - samples.begin());
        const double place = (samples[best].omega - low) / (high - low);
        const double value = confirmed(place, samples[best].value);
        settled = value >= 0.99 * samples[best].value;  // the function's own change is less
        samples[best].value = settled ? samples[best].value : value;
    }
    // Of the samples the best need not stand beside the highest summit. Those at the ends are near
    // enough.
    Peak highest = samples[best];
    for (std::size_t i = 1; i + 1 < samples.size() && highest.value <= enough; ++i) {
        const Peak& before = samples[i - 1];
        const Peak& after = samples[i + 1];
        // A plateau, such as the exact 1 of NMBC1, has no summit to look for.
        constexpr double roundings = 1e-12;
        const double lower = std::min(before.value, after.value);
        if (samples[i].value >= std::max(before.value, after.value) &&
            samples[i].value - lower > roundings * samples[i].value) {
            const double counts = std::isfinite(enough) ? enough : highest.value;
            const Peak summit = refined(function, samples[i], before, after, counts);
            if (summit.value > highest.value) {
                highest = summit;
            }
        }
    }
    return highest;
}

}  // namespace

Peak largest_over_band(const std::vector<double>& frequencies,
                       const std::function<double(double)>& function, double enough,
                       Sampling sampling) {
    static const std::vector<double> sharp = sample_places(Sampling::sharp);
    static const std::vector<double> smooth = sample_places(Sampling::smooth);
    const std::vector<double>& places = sampling == Sampling::sharp ? sharp : smooth;
    // What cannot be told counts as amplified.
    const auto closed = [&function](double omega) {
        const double value = function(omega);
        return std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
    };
    const double narrowest = narrowest_piece * frequencies.back();
    Peak highest;
    for (std::size_t i = 0; i + 1 < frequencies.size() && highest.value <= enough; ++i) {
        if (frequencies[i + 1] - frequencies[i] > narrowest) {
            const Peak peak =
                largest_in_piece(frequencies[i], frequencies[i + 1], closed, enough, places);
            if (peak.value > highest.value) {
                highest = peak;
            }
        }
    }
    return highest;
}

}  // namespace nmbcgen
