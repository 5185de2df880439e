// SPDX-License-Identifier: GPL-2.0-or-later
/// Conditions matched in leapfrog steps, against those matched in continuous time, in these steps.
#include <doctest/doctest.h>

#include <cmath>

#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/band_reflection.hpp"
#include "generator/stability/discrete.hpp"
#include "tests/stability/boundary.hpp"

using namespace nmbcgen;
using nmbcgen::test::relative;

namespace {

struct Case {
    unsigned horizon, order, stride;
    Rational G;
    Rational damping;
    Rational time_step;
};

/// In steps of the case's time step; matched in them, or in continuous time.
HalfSpace in_steps(const Case& one, bool matched) {
    const Table table = derive({.family = "nopd1d",
                                .horizon = one.horizon,
                                .order = one.order,
                                .stride = one.stride,
                                .stabilisation = {},
                                .damping = one.damping,
                                .time_step = matched ? one.time_step : Rational(0)});
    return stepped(make_half_space(table, one.G), nearest_double(one.time_step));
}

/// d log / d log xi of the reflected energy at long waves.
double slope(const HalfSpace& half_space, double xi) {
    return std::log2(reflected_energy(half_space, xi) / reflected_energy(half_space, xi / 2));
}

}  // namespace

TEST_CASE("long waves: an order of 4N in place of 4") {
    // The amplitude is the residual of (49), of order xi^(2N+1), over 2 xi. In continuous time the
    // residual is met, but for the steps' own dt^2/8 xi^3. Damping leaves a factor of 1 + O(xi^3)
    // to what is sent back.
    for (const Case& one : {Case{1, 2, 1, Rational(1, 2), 0, Rational(3, 5)},
                            Case{2, 2, 2, 1, 0, 1}, Case{3, 2, 3, 2, 0, Rational(3, 2)},
                            Case{2, 2, 4, 0, Rational(1, 20), 1}, Case{2, 3, 2, 1, 0, 1}}) {
        CAPTURE(one.horizon);
        CAPTURE(one.order);
        CAPTURE(to_string(one.G));
        // Where no more than roundings come back, there is no slope: 1e-17 in amplitude.
        const double xi = one.order == 2 ? 0.02 : 0.1;
        // A correction of relative size q xi^2 in the amplitude changes the slope by 2.2 q xi^2.
        CHECK(slope(in_steps(one, true), xi) == doctest::Approx(4.0 * one.order).epsilon(0.05));
        CHECK(slope(in_steps(one, false), xi) == doctest::Approx(4).epsilon(0.05));
    }
}

TEST_CASE("at cfl 0.6 the energy reflected over 0.05 .. 0.3/dX drops by orders of magnitude") {
    struct Drop {
        Case one;
        double factor = 0;  // at least
    };
    // Measured: 4.4e4, 4.7e9, 5100, 83.
    for (const auto& [one, factor] : {Drop{{1, 2, 1, Rational(1, 2), 0, Rational(3, 5)}, 4e4},
                                      Drop{{1, 3, 1, Rational(1, 2), 0, Rational(3, 5)}, 4e9},
                                      Drop{{2, 2, 2, 1, 0, Rational(34, 25)}, 5000},
                                      Drop{{3, 2, 3, 2, 0, Rational(3, 2)}, 80}}) {
        const HalfSpace matched = in_steps(one, true);
        const HalfSpace before = in_steps(one, false);
        const double cfl = matched.time_step * maximum_frequency(matched) / 2;
        const double least = mean_reflected_energy(matched, 0.05, 0.3);
        const double most = mean_reflected_energy(before, 0.05, 0.3);
        CHECK(cfl == doctest::Approx(one.horizon < 3 ? 0.6 : 0.49).epsilon(0.01));
        CHECK(most > factor * least);
    }
}

TEST_CASE("steps of length 0 are continuous time") {
    const Case one{1, 3, 1, Rational(1, 2), Rational(1, 10), 0};
    CHECK(mean_reflected_energy(in_steps(one, true), 0.05, 0.3) ==
          mean_reflected_energy(in_steps(one, false), 0.05, 0.3));
}
