// SPDX-License-Identifier: GPL-2.0-or-later
/// The modal verdict on both sides of every window edge that is known.
#include <doctest/doctest.h>

#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/modal.hpp"

namespace {

using nmbcgen::Failure;
using nmbcgen::Rational;

struct Windows {
    unsigned horizon;
    unsigned order;
    unsigned stride;
    std::vector<double> inside;
    std::vector<double> outside;
};

// The edges found by two independent prototypes (computer algebra and eigenvalues of assembled
// chains up to 300 nodes), approached to about the digits they are known to. Exact ones:
// 1/4, 1, 2/3, 2, 2 -+ sqrt 2, 208/85 = 2.44706, 1032/1445 = 0.714187.
const std::vector<Windows> known_windows{
    {1, 1, 1, {0, 0.1, 0.25, 1, 5}, {}},
    {1, 2, 1, {0.2501, 0.5, 0.9999}, {0.1, 0.2499, 1.0001, 2}},
    {1, 3, 1, {0.2501, 0.6666, 2.0001, 5}, {0.2499, 0.6668, 0.8, 1.9999}},
    {1, 4, 1, {0.2501, 0.5857, 1.0001, 3.4142}, {0.2499, 0.5859, 0.9999, 3.4143}},
    {2, 1, 1, {0, 0.5, 1, 3.49}, {3.51, 4}},
    {2, 2, 1, {2.4471, 3, 3.774}, {0.5, 1, 2.447, 3.775}},
    {2, 3, 1, {1.775, 1.85, 1.923}, {1.2, 1.774, 1.924, 3, 4.43}},
    {2, 4, 1, {}, {0.5, 1, 2, 3}},
    {2, 2, 2, {0.7142, 1, 2.9699}, {0.7, 0.71418, 2.971}},
    {2, 3, 2, {0.861, 1, 1.5, 2.0635}, {0.860, 2.065}},
    {2, 4, 2, {1.134, 1.5, 1.842, 3.462}, {1.133, 1.844, 3.461}},
    {3, 2, 3, {1.26255, 2, 4.552}, {1.26254, 4.554}},
    {3, 3, 3, {1.854, 2.5, 2.929}, {1.853, 2.932}},
};

TEST_CASE("modal windows") {
    for (const Windows& windows : known_windows) {
        const auto table = nmbcgen::derive(
            {"nopd1d", windows.horizon, windows.order, windows.stride, std::nullopt});
        CAPTURE(windows.horizon);
        CAPTURE(windows.order);
        CAPTURE(windows.stride);
        for (const double G : windows.inside) {
            CAPTURE(G);
            CHECK(nmbcgen::modal_verdict(nmbcgen::make_half_space(table, Rational(G))).failure ==
                  Failure::none);
        }
        for (const double G : windows.outside) {
            CAPTURE(G);
            CHECK(nmbcgen::modal_verdict(nmbcgen::make_half_space(table, Rational(G))).failure !=
                  Failure::none);
        }
    }
}

TEST_CASE("the kind of failure") {
    const auto verdict = [](unsigned horizon, unsigned order, const Rational& G) {
        const auto table = nmbcgen::derive({"nopd1d", horizon, order, 1, std::nullopt});
        return nmbcgen::modal_verdict(nmbcgen::make_half_space(table, G));
    };
    // The paper's scalar criterion holds at n = 2, N = 2, G = 1, and yet a boundary mode grows.
    CHECK(verdict(2, 2, 1).failure == Failure::growing_mode);
    CHECK(verdict(2, 2, 1).growth.real() > 0.1);
    // Below the threshold 1/4 there are backward waves; the amplified one is among them.
    const auto backward = verdict(1, 2, Rational(248) / 1000);
    CHECK(backward.failure == Failure::amplified_wave);
    // Theory: every single-wave flux is below 1 here, and sup rho is 1.00196.
    CHECK(backward.supremum == doctest::Approx(1.0024).epsilon(5e-4));
    // NMBC1, G = 0, n = 1: sigma_max is 1.43, sup rho 1 exactly: paired, not contractive.
    const auto paired = verdict(1, 1, 0);
    CHECK(paired.failure == Failure::none);
    CHECK(paired.supremum == doctest::Approx(1).epsilon(1e-8));
    CHECK_FALSE(paired.contractive);
}

// At G = n^4/A_n the stencil reaches n nodes, not 2n, and n modes decay at once, k = 0. The double
// next to 8/5 is not 8/5: those modes are there, with k of about 1e-8.
TEST_CASE("next to a G where the stencil is shorter") {
    const auto verdict = [](const Windows& boundary, const Rational& G) {
        return nmbcgen::modal_verdict(
            nmbcgen::make_half_space(nmbcgen::derive({"nopd1d", boundary.horizon, boundary.order,
                                                      boundary.stride, std::nullopt}),
                                     G));
    };
    struct Case {
        Windows boundary;
        Rational shorter;
        bool stable;
    };
    const std::vector<Case> cases{
        {{1, 2, 1, {}, {}}, Rational(1) / 2, true},
        {{2, 2, 1, {}, {}}, Rational(8) / 5, false},
        {{3, 3, 3, {}, {}}, Rational(81) / 28, true},
        {{4, 2, 4, {}, {}}, Rational(64) / 15, true},
    };
    for (const Case& each : cases) {
        CAPTURE(each.boundary.horizon);
        const auto exact = verdict(each.boundary, each.shorter);
        CHECK((exact.failure == Failure::none) == each.stable);
        for (const double relative : {0.0, 1e-14, -1e-12, 1e-10}) {
            CAPTURE(relative);
            const auto near = verdict(
                each.boundary, Rational(nmbcgen::nearest_double(each.shorter) * (1 + relative)));
            CHECK(near.failure == exact.failure);
            // The supremum is sampled where modes put it, and moves by less than G does.
            CHECK(near.supremum == doctest::Approx(exact.supremum).epsilon(1e-6));
        }
    }
}

}  // namespace
