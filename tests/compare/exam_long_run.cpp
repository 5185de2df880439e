// SPDX-License-Identifier: GPL-2.0-or-later
/// Long-time stability, and why Higdon's conditions grow.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <nmbc/tables/tables.hpp>
#include <numbers>
#include <vector>

#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"
#include "generator/stability/reflection.hpp"
#include "tools/nmbcrun/certification/half_space.hpp"
#include "tools/nmbcrun/chart/boundaries.hpp"
#include "tools/nmbcrun/chart/long_run.hpp"
#include "tools/nmbcrun/chart/trial.hpp"

namespace {

using nmbcrun::BoundaryKind;
using nmbcrun::LongRun;
using nmbcrun::LongTimeStability;
using nmbcrun::Scene;
using nmbcrun::stability_shown_by;

/// E = rho = dX = 1.
Scene chain_of(int horizon, double G, std::size_t nodes, double cfl) {
    Scene scene;
    scene.horizon = horizon;
    scene.G = G;
    scene.nodes = nodes;
    scene.end = 2 * double(nodes);
    return in_steps_of(scene, cfl);
}

LongTimeStability stability(const Scene& scene, const nmbcrun::Boundary& boundary,
                            std::size_t steps) {
    double done = 0;
    const LongTimeStability found = long_time_stability(with_ends(scene, boundary), steps,
                                                        [&done](double part) { done += part; });
    CHECK(std::abs(done - 1) < 1e-9);  // whether or not it ended early
    return found;
}

template <class Function>
std::vector<double> sampled(Function function) {
    std::vector<double> values;
    for (int i = 0; i <= 1000; ++i) {
        values.push_back(function(0.001 * i));
    }
    return values;
}

/// The fastest growth [c/dX] of a wave that runs to and fro between two Higdon conditions, as
/// itself alone: v ln|R| / L. All layers carry the same condition, Delta(k) its residual, that of
/// order 1 to the power `order`; order 1 is NMBC1. So R of the latter and the ratio of residuals to
/// the power order - 1 make R.
double growth_of_one_wave(const Scene& scene, int order) {
    const nmbcgen::HalfSpace half_space = stepped(
        nmbcrun::half_space_of(nmbc::generated::nopd1d_n2_order1, scene.G), scene.step.value());
    double fastest = 0;
    constexpr int samples = 2000;
    for (int i = 1; i < samples; ++i) {
        const double omega = std::sqrt(omega_squared(half_space, std::numbers::pi * i / samples));
        const auto residual = [&](std::complex<double> k) {
            const auto [C, B] = evaluate_condition(half_space, k);
            return std::abs(boundary_rate(half_space, omega) * C - B);
        };
        const nmbcgen::Reflection first = reflection(half_space, omega);
        for (Eigen::Index wave = 0; wave < first.matrix.rows(); ++wave) {
            const nmbcgen::Mode& mode = first.outgoing[std::size_t(wave)];
            const double size = std::abs(first.matrix(wave, wave)) *
                                std::pow(residual(1.0 / mode.k) / residual(mode.k), order - 1);
            // Leapfrog's frequency is (2/dt) asin(omega dt/2).
            const double half_step = omega * scene.step.value() / 2;
            const double speed =
                std::abs(mode.group_velocity) / std::sqrt(1 - half_step * half_step);
            fastest = std::max(fastest, speed * std::log(size) / double(scene.nodes + 1));
        }
    }
    return fastest;
}

TEST_CASE("powers and exponential functions of time are told apart, also from what was there") {
    for (const double start : {0.0, 1.0}) {
        for (const int power : {1, 2, 3}) {
            CAPTURE(power);
            const LongTimeStability shown = stability_shown_by(
                sampled([=](double t) { return start + 1e4 * std::pow(t, power); }), 1);
            CHECK(shown.outcome == LongRun::drifts);
            // The start is 8e-4 to 1e-4 of what has come by the half of the time.
            CHECK(shown.rate == doctest::Approx(power).scale(0).epsilon(2e-3));
        }
        const LongTimeStability shown = stability_shown_by(
            sampled([=](double t) { return start + 0.01 * std::exp(25 * t); }), 1);
        CHECK(shown.outcome == LongRun::unstable);
        // By the half of the time e^12.5/100 has come, 2700; in the half that is 3e-5 of the rate.
        CHECK(shown.rate == doctest::Approx(25).scale(0).epsilon(1e-4));
    }
    CHECK(stability_shown_by(sampled([](double t) { return 1 + 3 * t; }), 1).outcome ==
          LongRun::grows);
    CHECK(stability_shown_by(sampled([](double t) { return 2 + std::sin(300 * t); }), 1).outcome ==
          LongRun::steady);
    CHECK(stability_shown_by(sampled([](double t) { return std::exp(-t); }), 1).outcome ==
          LongRun::steady);
    CHECK(stability_shown_by({1, 1}, 1).outcome == LongRun::steady);
}

TEST_CASE("a growing mode has the rate of the analysis") {
    // nmbcgen --order 3 --horizon 1 --G 1/2 is not stable in such steps.
    const Scene scene = with_ends(chain_of(1, 0.5, 200, 0.8), {.order = 3});
    const auto verdict = modal_verdict(stepped(
        nmbcrun::half_space_of(nmbc::generated::nopd1d_n1_order3, scene.G), scene.step.value()));
    REQUIRE(verdict.failure == nmbcgen::Failure::growing_mode);
    const std::complex<double> half = verdict.growth * scene.step.value() / 2.0;
    const double rate = std::log(std::abs((1.0 + half) / (1.0 - half))) / scene.step.value();
    const LongTimeStability shown = stability(scene, scene.left, 4000);
    CHECK(shown.outcome == LongRun::unstable);
    // It is seen for 100 steps, and its phase may differ at both ends of them.
    CHECK(shown.rate == doctest::Approx(rate).scale(0).epsilon(0.02));
}

TEST_CASE("NMBC of order 2 and perfectly matched layers are steady") {
    const Scene scene = chain_of(2, 1.5, 100, 0.4);
    CHECK(stability(scene, {.order = 2, .stride = 2}, 100'000).outcome == LongRun::steady);
    CHECK(stability(scene, {.kind = BoundaryKind::pml, .layer = 10}, 100'000).outcome ==
          LongRun::steady);
}

TEST_CASE("passive ends are steady where no NMBC is certified") {
    // NMBC2 and NMBC3 of any stride have no certificate at G = 0.
    for (const int horizon : {1, 2, 3}) {
        CAPTURE(horizon);
        CHECK(stability(chain_of(horizon, 0, 100, 0.4), {.kind = BoundaryKind::passive}, 100'000)
                  .outcome == LongRun::steady);
    }
}

TEST_CASE("where there are backward waves Higdon's conditions grow by reflecting them") {
    for (const int order : {3, 4}) {
        CAPTURE(order);
        const Scene scene = chain_of(2, 1.85, 500, 0.8);
        const LongTimeStability shown =
            stability(scene, {.kind = BoundaryKind::higdon, .order = order}, 1'000'000);
        CHECK(shown.outcome == LongRun::unstable);
        // A little more, as the two waves of a frequency make each other, too.
        CHECK(shown.rate > 0.99 * growth_of_one_wave(scene, order));
        CHECK(shown.rate < 1.02 * growth_of_one_wave(scene, order));
    }
}

TEST_CASE("without backward waves they grow by roundings at a rate for each step and any length") {
    // 1, t, .. t^(order - 1) are solutions: a factor 1 of a step of this multiplicity, which
    // roundings of relative size eps split by about the root of eps of this order.
    const double root = std::pow(std::numeric_limits<double>::epsilon() / 2, 1.0 / 4);
    for (const std::size_t nodes : {50U, 200U}) {
        const Scene scene = chain_of(1, 0.5, nodes, 0.4);
        const LongTimeStability shown =
            stability(scene, {.kind = BoundaryKind::higdon, .order = 4}, 500'000);
        CHECK(shown.outcome == LongRun::unstable);
        // Their size is known but for a factor: its fourth root is within 0.5 and 1.
        CHECK(shown.rate * scene.step.value() > 0.4 * root);
        CHECK(shown.rate * scene.step.value() < root);
        CHECK(stability(scene, {.kind = BoundaryKind::higdon, .order = 2}, 500'000).outcome ==
              LongRun::steady);
    }
}

}  // namespace
