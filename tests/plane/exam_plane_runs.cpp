// SPDX-License-Identifier: MIT
/// Boxes of the runtime between sides of (81) grow as their eigenvalues say, and with tau as well.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <numbers>

#include "generator/exact/rational.hpp"
#include "generator/passive/edge.hpp"
#include "generator/plane/box.hpp"
#include "generator/plane/strip.hpp"
#include "tests/runtime/plane_bodies.hpp"
#include "tests/support/nopd2d.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

constexpr std::size_t box_nodes = 12;

PlaneLattice damped_at_no_G(unsigned radius_squared, const Rational& tau) {
    return plane_lattice(nmbcgen::nopd2d(of_paper(radius_squared)), 0, tau);
}

/// At G = 0.
double predicted_rate(unsigned radius_squared, const Rational& tau, double time_step = 0) {
    const PlaneLattice lattice = damped_at_no_G(radius_squared, tau);
    const SideCondition published = published_condition(lattice);
    return growth_in_box(lattice, {.across_x = published, .across_y = published}, box_nodes,
                         time_step);
}

nmbc::MatchingSide side_of_81(const nmbc::CorrespondenceModel& model) {
    const nmbc::BoundaryCoefficients of_81{.c = {1, 1}, .b = {-2, 2}};
    return {.coefficients = {of_81, of_81}, .speeds = {model.speed_P(), model.speed_P()}};
}

nmbc::Plane started(const nmbc::PlaneModel& model, const nmbc::PlaneSides& sides, std::size_t nx,
                    std::size_t ny, double of_longest) {
    nmbc::PlaneParameters p{.nx = nx, .ny = ny};
    p.time_step = of_longest * nmbc::longest_step(model, sides, p.nx, p.ny);
    nmbc::Plane plane(model, sides, p);
    fill_at_random(plane, 3);
    plane.start();
    return plane;
}

nmbc::Plane box_of_runtime(unsigned radius_squared, const Rational& tau, double of_longest = 0.1) {
    const nmbc::CorrespondenceModel model =
        nmbc::nopd2d(radius_squared, 0.25, 0, nmbc::StressState::plane_stress, nearest_double(tau));
    return started(model, nmbc::PlaneSides::all(side_of_81(model)), box_nodes, box_nodes,
                   of_longest);
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

namespace {

/// Of what has grown most, when nothing else is seen.
double measured_rate(nmbc::Plane& plane, double about) {
    run_to(plane, 30 / about);
    const double before = amplitude(plane);
    const double from = plane.time();
    run_to(plane, 40 / about);
    return std::log(amplitude(plane) / before) / (plane.time() - from);
}

}  // namespace

TEST_CASE("in the runtime's own steps its rate is that of leapfrog with ghosts at midpoints") {
    for (const Rational& tau : {Rational(0), Rational(1, 400)}) {
        nmbc::Plane plane = box_of_runtime(1, tau, 0.9);
        const double rate = predicted_rate(1, tau, plane.parameters().time_step);
        CAPTURE(rate);
        // Steps change it by more than is told here.
        CHECK(std::abs(rate / predicted_rate(1, tau) - 1) > 0.05);
        // Motions whose rates are some per cent apart grow together.
        CHECK(measured_rate(plane, rate) == doctest::Approx(rate).epsilon(0.05).scale(0));
    }
}

namespace {

/// A strip of nopd2d between a side of (81) and another one.
class StripOf81 {
  public:
    StripOf81(unsigned radius_squared, double G)
        : model_(nmbc::nopd2d(radius_squared, 0.25, G, nmbc::StressState::plane_stress)),
          lattice_(lattice_of_paper(radius_squared, G)),
          published_(published_condition(lattice_)),
          node_(Eigen::Index(std::sqrt(radius_squared))),
          squares_(
              [radius_squared](unsigned layer, const Rational& beta) {
                  return nopd2d_at_edge(of_paper(radius_squared), layer, beta);
              },
              node_, g_of(G), 0) {}

    void check_opposite_like(double of_longest) const {
        check(
            side_of_81(model_), [this](double) { return StripSide(published_); }, of_longest);
    }

    void check_opposite_fixed(double of_longest) const {
        check(
            nmbc::FixedSide{}, [](double) { return StripSide(fixed_condition()); }, of_longest);
    }

    void check_opposite_free(double of_longest) const {
        check(
            nmbc::FreeSide{},
            [this](double wave_number) {
                return StripSide(free_side(squares_, node_, 2 * node_, wave_number));
            },
            of_longest);
    }

  private:
    template <class SideAt>
    void check(const nmbc::PlaneSide& right, SideAt side_at, double of_longest) const {
        constexpr std::size_t across = 8;
        constexpr std::size_t along = 24;
        const nmbc::PlaneSides sides{.left = side_of_81(model_),
                                     .right = right,
                                     .bottom = nmbc::PeriodicSide{},
                                     .top = nmbc::PeriodicSide{}};
        nmbc::Plane plane = started(model_, sides, across, along, of_longest);
        double rate = 0;
        for (std::size_t i = 0; i <= along / 2; ++i) {
            const double wave_number = 2 * std::numbers::pi * double(i) / double(along);
            rate = std::max(rate, growth_in_strip(lateral_chain(lattice_, wave_number),
                                                  {.left = published_,
                                                   .right = side_at(wave_number),
                                                   .layers = across,
                                                   .time_step = plane.parameters().time_step}));
        }
        CAPTURE(rate);
        REQUIRE(rate > 1e-3);
        CHECK(measured_rate(plane, rate) == doctest::Approx(rate).epsilon(0.05).scale(0));
    }

    nmbc::CorrespondenceModel model_;
    PlaneLattice lattice_;
    SideCondition published_;
    Eigen::Index node_;
    EdgeSquares squares_;
};

}  // namespace

TEST_CASE("strips of the runtime between unlike sides grow at the rate of their eigenvalues") {
    const StripOf81 smallest(1, 0);
    smallest.check_opposite_like(0.9);
    for (const double of_longest : {0.2, 0.9}) {
        smallest.check_opposite_fixed(of_longest);
        smallest.check_opposite_free(of_longest);
    }
}

// Stabilised nodes have a free side whose forces reach farther; delta = 2 has layers that no node
// of the outermost one knows.
TEST_CASE("so do stabilised strips beside a free side, and those of a larger radius") {
    StripOf81(1, 0.1).check_opposite_free(0.9);
    const StripOf81 larger(4, 0);
    larger.check_opposite_like(0.9);
    larger.check_opposite_free(0.9);
    StripOf81(4, 0.5).check_opposite_free(0.9);
}

TEST_CASE("with the tau that ends its growth in boxes (81) does not grow" *
          doctest::test_suite("long")) {
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
