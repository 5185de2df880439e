// SPDX-License-Identifier: MIT
/// Boxes of the runtime between sides of (81) grow as their eigenvalues say, and with tau as well.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <numbers>

#include "generator/exact/rational.hpp"
#include "generator/plane/box.hpp"
#include "tests/runtime/plane_bodies.hpp"
#include "tests/support/nopd2d.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

constexpr std::size_t box_nodes = 12;

/// At G = 0.
double predicted_rate(unsigned radius_squared, const Rational& tau) {
    const PlaneLattice lattice = plane_lattice(nmbcgen::nopd2d(of_paper(radius_squared)), 0, tau);
    const SideCondition published = published_condition(lattice);
    return growth_in_box(lattice, {.across_x = published, .across_y = published}, box_nodes);
}

nmbc::Plane box_of_runtime(unsigned radius_squared, const Rational& tau) {
    const nmbc::CorrespondenceModel model =
        nmbc::nopd2d(radius_squared, 0.25, 0, nmbc::StressState::plane_stress, nearest_double(tau));
    const nmbc::BoundaryCoefficients of_81{.c = {1, 1}, .b = {-2, 2}};
    const nmbc::PlaneSides sides = nmbc::PlaneSides::all(nmbc::MatchingSide{
        .coefficients = {of_81, of_81}, .speeds = {model.speed_P(), model.speed_P()}});
    nmbc::PlaneParameters p{.nx = box_nodes, .ny = box_nodes};
    p.time_step = 0.1 * nmbc::longest_step(model, sides, p.nx, p.ny);
    nmbc::Plane plane(model, sides, p);
    fill_at_random(plane, 3);
    plane.start();
    return plane;
}

double amplitude(const nmbc::Plane& plane) {
    double sum = 0;
    for (const std::size_t a : {0U, 1U}) {
        for (const double v : plane.velocity(a)) {
            sum += v * v;
        }
    }
    return std::sqrt(sum);
}

void run_to(nmbc::Plane& plane, double time) {
    plane.advance(std::size_t((time - plane.time()) / plane.parameters().time_step));
}

}  // namespace

TEST_CASE("(81) grows at the predicted rate, with too little tau as well") {
    const auto check = [](unsigned radius_squared, const Rational& tau) {
        CAPTURE(radius_squared);
        const double rate = predicted_rate(radius_squared, tau);
        CAPTURE(rate);
        nmbc::Plane plane = box_of_runtime(radius_squared, tau);
        run_to(plane, 12 / rate);  // by then nothing else is seen
        const double before = amplitude(plane);
        const double from = plane.time();
        run_to(plane, 20 / rate);
        // Steps are a tenth of the longest: in them rates differ by some per cent.
        CHECK(std::log(amplitude(plane) / before) / (plane.time() - from) ==
              doctest::Approx(rate).epsilon(0.1).scale(0));
    };
    check(1, 0);
    check(4, 0);
    check(9, 0);
    check(9, Rational(1, 4));
}

TEST_CASE("with the tau that ends its growth in boxes (81) does not grow") {
    const auto check = [](unsigned radius_squared, const Rational& tau) {
        CAPTURE(radius_squared);
        REQUIRE(predicted_rate(radius_squared, tau) < 1e-11);
        nmbc::Plane plane = box_of_runtime(radius_squared, tau);
        run_to(plane, 500);
        const double before = amplitude(plane);
        run_to(plane, 4000);
        CHECK(amplitude(plane) < before);
    };
    check(1, Rational(1, 20));
    check(9, Rational(2, 3));
}
