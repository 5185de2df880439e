// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen optimise: never worse than a standard condition, where the optimum is known, and that
/// what it says a condition reflects is what `nmbcgen reflect` says.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "generator/commands/optimise.hpp"
#include "generator/commands/reflect.hpp"
#include "generator/commands/require_stable.hpp"
#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/band_reflection.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"

using namespace nmbcgen;

namespace {

const Progress silent = [](std::size_t, std::size_t) {};

Aim aim_at(unsigned order, unsigned horizon, const Rational& G, const WaveNumberRange& band) {
    return {.what = {.horizon = horizon, .order = order, .stabilisation = G},
            .stride = std::nullopt,
            .band = band};
}

double mean_of(const Specification& what, const WaveNumberRange& band) {
    return mean_reflected_energy(make_half_space(derive(what), *what.stabilisation), band.low,
                                 band.high);
}

}  // namespace

TEST_CASE("never worse than the certified standard conditions, and certified itself" *
          doctest::test_suite("long")) {
    int improved = 0;
    for (const Aim& aim : {aim_at(1, 1, 1, {0.05, 0.3}), aim_at(2, 1, Rational(1, 2), {0.3, 0.8}),
                           aim_at(2, 2, 1, {0.05, 0.3}), aim_at(3, 2, Rational(3, 2), {0.3, 0.8}),
                           aim_at(2, 3, 2, {0.3, 0.8})}) {
        const std::vector<Contender> all = contenders(aim, silent);
        const Contender* best = best_of(all);
        REQUIRE(best != nullptr);
        std::size_t standards = 0;
        for (const Contender& one : all) {
            CHECK(one.what.order == aim.what.order);
            if (one.what.points.empty()) {
                ++standards;
                CHECK(one.what.stride == standards);
                CHECK((one.certified.largest == 0 || best->mean <= one.mean));
                improved += one.certified.largest > 0 && best->mean < one.mean / 2 ? 1 : 0;
            }
        }
        CHECK(standards == std::max(2 * aim.what.horizon, 4U));
        const HalfSpace half_space = make_half_space(derive(best->what), *best->what.stabilisation);
        CHECK(stability_grade(half_space) != Grade::none);
        CHECK(stable_range(half_space).largest == best->certified.largest);
        CHECK(mean_of(best->what, aim.band) == best->mean);
        CHECK(best->largest >= best->mean);
    }
    CHECK(improved >= 4);  // NMBC1 of n = 1, G = 1, exact to one order more, has less to win
}

TEST_CASE("one point in a narrow band is in its middle") {
    // The reflected energy is a parabola about the point, up to the band's width squared. A unit of
    // the grid, 1e-4 here, is a hundredth of the width w: from d to d - 1 units the mean,
    // w^2/12 + d^2, falls by more than the thousandth that is asked for where d > 0.92 units.
    for (const unsigned stride : {1U, 2U}) {
        for (const double middle : {0.5, 1.0, 1.2}) {
            Aim aim = aim_at(1, 1, Rational(1, 2), {middle - 0.005, middle + 0.005});
            aim.stride = stride;
            const std::vector<Contender> all = contenders(aim, silent);
            REQUIRE(all.size() == 2);
            REQUIRE(all[1].what.points.size() == 1);
            CHECK(std::abs(nearest_double(all[1].what.points[0].wave_number) - middle) < 1.5e-4);
        }
    }
}

TEST_CASE("one point: no other one of the band is better") {
    Aim aim = aim_at(1, 2, 1, {0.3, 0.8});
    aim.stride = 1;
    const std::vector<Contender> all = contenders(aim, silent);
    REQUIRE(best_of(all) == &all.back());
    for (int hundredth = 30; hundredth <= 80; ++hundredth) {
        Specification other = aim.what;
        other.points = {{.wave_number = Rational(hundredth, 100)}};
        // But for the thousandth that a step has to win, once from either side.
        CHECK(all.back().mean <= 1.002 * mean_of(other, aim.band));
    }
}

TEST_CASE("what it reflects is what reflect prints") {
    // Of 256 samples in (0, pi) those from the 33rd to the 96th are the 64 of this band.
    constexpr double unit = std::numbers::pi / 256;
    Aim aim = aim_at(2, 2, 2, {32 * unit, 96 * unit});
    aim.stride = 2;
    const std::vector<Contender> all = contenders(aim, silent);
    const Contender* best = best_of(all);
    REQUIRE(best != nullptr);
    REQUIRE(!best->what.points.empty());
    std::istringstream csv(reflection_csv(derive(best->what), 256));
    std::map<long, double> flux;  // by number of the sample
    std::string line;
    for (std::getline(csv, line); std::getline(csv, line);) {
        const std::size_t comma = line.find(',');
        const double xi = std::abs(std::strtod(line.c_str() + comma + 1, nullptr));
        flux[std::lround(xi / unit + 0.5)] +=
            std::strtod(line.c_str() + line.rfind(',') + 1, nullptr);
    }
    double sum = 0;
    for (long sample = 33; sample <= 96; ++sample) {
        REQUIRE(flux.count(sample) == 1);
        sum += flux[sample];
    }
    // Twelve digits are printed.
    CHECK(sum / 64 == doctest::Approx(best->mean).epsilon(1e-9).scale(0));
}

TEST_CASE("NMBC1 in time steps is made without, and one with points is matched in them") {
    Aim aim = aim_at(1, 1, 1, {0.3, 0.8});
    aim.what.time_step = Rational(1, 2);
    aim.stride = 1;
    const std::vector<Contender> all = contenders(aim, silent);
    REQUIRE(all.size() == 2);
    CHECK(all[0].what.time_step == 0);
    CHECK(all[1].what.time_step == Rational(1, 2));
    for (const Contender& one : all) {
        const HalfSpace half_space = make_half_space(derive(one.what), 1);
        CHECK(one.mean == mean_reflected_energy(stepped(half_space, 0.5), 0.3, 0.8));
    }
    CHECK(all[1].mean < all[0].mean);
}

TEST_CASE("where nothing is certified nothing is recommended") {
    // NMBC3 of n = 1 and stride 1, the standard one and those with points alike.
    Aim aim = aim_at(3, 1, Rational(1, 10), {0.3, 0.8});
    aim.stride = 1;
    CHECK(best_of(contenders(aim, silent)) == nullptr);
    CHECK_THROWS_AS(optimisation(aim, silent), NotStable);
}
