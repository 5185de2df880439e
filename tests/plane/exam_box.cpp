// SPDX-License-Identifier: MIT
/// Growth in boxes of 12 x 12 nodes, whose corners strips have not. Another program found .066 at
/// radius 1 and G = 0, no growth there from G = .25 on, and none at radius 3 from tau = .2 on, with
/// E = 100; the other rates are of this one.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "generator/plane/box.hpp"
#include "tests/support/nopd2d.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

constexpr double box_roundings = 1e-11;  // rates of some hundred states

double box_growth(const PlaneLattice& lattice) {
    const SideCondition published = published_condition(lattice);
    return paper_time_unit *
           growth_in_box(lattice, {.across_x = published, .across_y = published}, 12);
}

/// Within half a unit of the last digit that was given.
doctest::Approx about(double rate, double last_digit) {
    return doctest::Approx(rate).epsilon(last_digit / 2 / rate).scale(0);
}

}  // namespace

TEST_CASE("(81) with corners, smallest family") {
    const auto at = [](double G) { return box_growth(lattice_of_paper(1, G)); };
    CHECK(at(0) == about(.0661, 1e-4));
    CHECK(at(.1) == about(.0021, 1e-4));
    for (const double G : {.2, .25, 1.0}) {
        CAPTURE(G);
        CHECK(at(G) < box_roundings);
    }
    CHECK(box_growth(damped_lattice(1, 0, .01)) < box_roundings);
}

TEST_CASE("(81) across x between fixed sides across y grows as well") {
    const PlaneLattice lattice = lattice_of_paper(1, 0);
    const BoxSides sides{.across_x = published_condition(lattice), .across_y = fixed_condition()};
    CHECK(paper_time_unit * growth_in_box(lattice, sides, 12) == about(.068, 1e-3));
}

TEST_CASE("damping that ends the growth of strips does not always end that of boxes" *
          doctest::test_suite("long")) {
    CHECK(box_growth(damped_lattice(4, 0, .03)) < box_roundings);
    CHECK(box_growth(damped_lattice(9, 0, .1)) == about(.099, 1e-3));
    CHECK(box_growth(damped_lattice(9, 0, .15)) == about(.013, 1e-3));
    CHECK(box_growth(damped_lattice(9, 0, .2)) < box_roundings);
}
