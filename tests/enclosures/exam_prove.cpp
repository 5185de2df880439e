// SPDX-License-Identifier: GPL-2.0-or-later
/// What is proved of conditions whose windows and steps are known.
#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "generator/enclosures/prove.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/certify.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"

namespace {

using nmbcgen::Grade;
using nmbcgen::Prover;
using nmbcgen::Undecided;

Prover prover(unsigned horizon, unsigned order, unsigned stride) {
    return Prover(nmbcgen::derive(
        {.horizon = horizon, .order = order, .stride = stride, .stabilisation = {}}));
}

/// At one G, from continuous time on.
double proved_cfl(const Prover& proof, double G, Grade grade) {
    return proof.proved_steps({G, G}, grade, 0, [](double) {}).cfl;
}

/// Of a window, paired, in every step up to this cfl.
std::vector<nmbc::Window> proved_parts(const Prover& proof, const nmbc::Window& window, double cfl,
                                       double finest) {
    const auto holds = [&](const nmbc::Window& piece) {
        return proof.holds(piece, cfl, Grade::paired);
    };
    return nmbcgen::parts_where(holds, window, finest, [](double) {});
}

TEST_CASE("at one G every step is proved as far as sampling finds them stable") {
    struct Case {
        unsigned horizon, order, stride;
        double G;
        double paired;       ///< cfl, as nmbcgen's sampled certificate has it
        double contractive;  ///< -1: not even in continuous time
    };
    for (const Case& each : {Case{1, 2, 1, 0.5, 0.70, 0.70}, Case{2, 2, 2, 1, 0.75, 0.75},
                             Case{2, 3, 2, 1, 0.37, 0.37}, Case{2, 1, 1, 1, 0.82, -1}}) {
        CAPTURE(each.horizon);
        CAPTURE(each.order);
        const Prover proof = prover(each.horizon, each.order, each.stride);
        CHECK(proved_cfl(proof, each.G, Grade::paired) == each.paired);
        CHECK(proved_cfl(proof, each.G, Grade::contractive) == each.contractive);
    }
}

TEST_CASE("at horizon 4, too, in seconds" * doctest::test_suite("long")) {
    CHECK(proved_cfl(prover(4, 1, 1), 1, Grade::paired) == 0.66);
    const Prover proof = prover(4, 2, 4);
    CHECK(proved_cfl(proof, 3, Grade::paired) == 0.72);
    CHECK(proved_cfl(proof, 3, Grade::contractive) == 0.72);
}

TEST_CASE("what is undecided where the proof ends is named") {
    const Prover proof = prover(1, 2, 1);
    const auto beyond = [&](double G, double cfl) {
        return proof.undecided({G, G}, cfl, Grade::paired);
    };
    CHECK(beyond(0.5, 0.7) == Undecided::nothing);
    CHECK(beyond(0.5, 0.72) == Undecided::modes);  // one grows from cfl 0.7071 on
    CHECK(prover(2, 1, 1).undecided({1, 1}, 0, Grade::contractive) == Undecided::waves);
}

TEST_CASE("in one step at one G what is sampled stable is mostly proved" *
          doctest::test_suite("long")) {
    struct Case {
        unsigned horizon, order, stride;
        double low, high;
        int stable, proved;
    };
    for (const Case& each : {
             Case{1, 2, 1, 0.26, 0.99, 30, 30},
             Case{2, 1, 1, 0.1, 3.4, 28, 28},
             Case{2, 2, 2, 0.75, 2.9, 30, 30},
             Case{3, 1, 1, 0.1, 5.5, 28, 28},
             Case{3, 2, 3, 1.3, 4.5, 29, 29},
             Case{3, 3, 3, 1.9, 2.9, 15, 15},
             Case{4, 1, 1, 0.1, 7.5, 28, 25},
             Case{4, 2, 4, 1.9, 5.5, 28, 28},
             Case{5, 1, 1, 0.1, 10, 28, 28},
             Case{5, 2, 5, 2.5, 6, 26, 9},
             Case{6, 1, 1, 0.1, 12, 28, 28},
         }) {
        CAPTURE(each.horizon);
        CAPTURE(each.order);
        const auto table = nmbcgen::derive({.horizon = each.horizon,
                                            .order = each.order,
                                            .stride = each.stride,
                                            .stabilisation = {}});
        const Prover proof(table);
        int stable = 0;
        int proved = 0;
        for (int i = 0; i < 10; ++i) {
            const double G = each.low + (each.high - each.low) * (i + 0.37) / 10;
            const auto h = make_half_space(table, nmbcgen::Rational(G));
            for (const double cfl : {0.1, 0.3, 0.5}) {
                const double step = 2 * cfl / maximum_frequency(h);
                const bool is_stable = stability_grade(stepped(h, step)) != Grade::none;
                const bool is_proved = proof.holds_in_step({G, G}, step, Grade::paired);
                CHECK(is_proved <= is_stable);
                stable += int(is_stable);
                proved += int(is_proved);
            }
        }
        CHECK(stable == each.stable);
        CHECK(proved >= each.proved);
    }
}

TEST_CASE("sup rho = 1 exactly is proved, where NMBC1 has several waves") {
    const auto parts = proved_parts(prover(2, 1, 1), {1.3, 1.7}, 0.75, 0.01);
    REQUIRE(parts.size() == 1);
    CHECK(parts.front().low == 1.3);
    CHECK(parts.front().high == 1.7);
    CHECK(prover(3, 1, 1).holds({1, 1}, 0.6, Grade::paired));
}

TEST_CASE("an interval of G is proved next to extrema of the band, too") {
    // Two waves meet there.
    CHECK(prover(3, 3, 3).holds({2.2, 2.2001}, 0, Grade::contractive));
    CHECK(prover(2, 2, 2).holds({2.8, 2.801}, 0, Grade::contractive));
    // The coefficients of omega^2 are larger than it, and have to vary with G together.
    CHECK(prover(5, 1, 1).holds({4, 4.001}, 0, Grade::paired));
}

TEST_CASE("a certificate at one G is proved or sampled") {
    const auto certified = [](unsigned order, const nmbcgen::Rational& G,
                              const nmbcgen::Rational& time_step) {
        const auto table = nmbcgen::derive(
            {.horizon = 1, .order = order, .stabilisation = G, .time_step = time_step});
        auto certificate = nmbcgen::certify(table);
        prove_certificate(table, certificate);
        return certificate;
    };
    const auto evidence = [&](unsigned order, const nmbcgen::Rational& G,
                              const nmbcgen::Rational& time_step = 0) {
        const auto certificate = certified(order, G, time_step);
        return std::pair(certificate.paired, certificate.with_any);
    };
    using nmbcgen::Evidence;
    CHECK(evidence(2, {1, 2}) == std::pair(Evidence::proved, Evidence::proved));
    CHECK(evidence(2, {1, 3}) == std::pair(Evidence::proved, Evidence::proved));  // no double
    // the edge is at cfl 0.5
    CHECK(evidence(3, {1, 2}) == std::pair(Evidence::proved, Evidence::proved));
    CHECK(certified(3, {1, 2}, 0).max_cfl.front().cfl == 0.49);
    CHECK(certified(3, {1, 2}, 0).max_cfl_contractive.front().cfl == 0.49);
    CHECK(evidence(3, {1, 2}, {1, 2}) == std::pair(Evidence::proved, Evidence::proved));
    CHECK(evidence(2, 2) ==
          std::pair(Evidence::sampled, Evidence::sampled));  // nothing is certified
}

TEST_CASE("nothing is proved that does not hold") {
    // below the window, above it, and in it with a growing mode in longer steps
    CHECK(!prover(2, 2, 2).holds({0.7, 0.7}, 0, Grade::paired));
    CHECK(!prover(2, 2, 2).holds({3, 3}, 0, Grade::paired));
    CHECK(!prover(2, 2, 2).holds({1, 1}, 0.77, Grade::paired));
    // paired alone: contractive ends at 4.0265
    CHECK(!prover(3, 2, 3).holds({4.1, 4.1}, 0, Grade::contractive));
    // a growing boundary mode, Re s = 18.1, although |R| <= 1
    CHECK(!prover(2, 2, 1).holds({1, 1}, 0, Grade::paired));
    // amplified by 1.7e-10 in a band 4e-17 wide
    CHECK(!prover(5, 1, 5).holds({2.28, 2.28}, 0, Grade::contractive));
    // C(1) = 0 and a pole
    CHECK(!prover(1, 3, 1).holds({0.9, 1.1}, 0, Grade::paired));
    CHECK(!prover(2, 2, 1).holds({1.5, 1.52}, 0, Grade::paired));
}

TEST_CASE("windows of G are proved but for their ends") {
    const auto parts = proved_parts(prover(2, 2, 2), {1, 1.6}, 0, 1e-3);
    REQUIRE(parts.size() == 1);
    CHECK(parts.front().low == 1);
    CHECK(parts.front().high == 1.6);
    // n = 1, N = 4 has two, [1/4, 2 - sqrt 2] and [1, 2 + sqrt 2]: nothing between them
    const auto two = proved_parts(prover(1, 4, 1), {0.2, 4}, 0, 1e-3);
    const double one_end = 2 - std::sqrt(2);
    const double other_end = 2 + std::sqrt(2);
    double covered = 0;
    for (const nmbc::Window& part : two) {
        CHECK(((part.low >= 0.25 && part.high <= one_end) ||
               (part.low >= 1 && part.high <= other_end)));
        covered += part.high - part.low;
    }
    CHECK(covered > 0.95 * (one_end - 0.25 + other_end - 1));
}

Prover damped_prover(unsigned horizon, unsigned order, unsigned stride, int inverse_tau) {
    return Prover(nmbcgen::derive({.horizon = horizon,
                                   .order = order,
                                   .stride = stride,
                                   .stabilisation = {},
                                   .damping = nmbcgen::Rational(1, inverse_tau)}));
}

TEST_CASE("half spaces of damped lattices are proved as far as chains of 100 are sampled stable") {
    struct Case {
        unsigned horizon, order, stride;
        int inverse_tau;
        double G, cfl;
    };
    for (const Case& each :
         {Case{1, 1, 1, 10, 0.5, 0.81}, Case{1, 2, 1, 10, 0.5, 0.03}, Case{2, 2, 2, 10, 1, 0.75},
          Case{2, 3, 2, 10, 1, 0.37}, Case{3, 2, 3, 20, 2, 0.78}}) {
        CAPTURE(each.horizon);
        CAPTURE(each.order);
        CHECK(proved_cfl(damped_prover(each.horizon, each.order, each.stride, each.inverse_tau),
                         each.G, Grade::paired) == each.cfl);
    }
}

TEST_CASE("of a damped lattice nothing is proved that does not hold") {
    // stable in continuous time and from cfl 0.047 on; below, a mode grows
    const Prover gap = damped_prover(1, 2, 1, 50);
    CHECK(gap.holds({0.045, 0.045}, 0, Grade::paired));
    CHECK(!gap.holds({0.045, 0.045}, 0.02, Grade::paired));
    CHECK(gap.holds({0.045, 0.045}, 0.15, Grade::paired, 0.047));
    // a growing mode at every step
    CHECK(!damped_prover(2, 2, 1, 10).holds({1, 1}, 0, Grade::paired));
    // waves that do not fade: omega = 0 at xi = pi
    CHECK(!damped_prover(1, 1, 1, 10).holds({0, 0}, 0, Grade::paired));
    // grades of waves that keep their energy are not told of
    CHECK(!damped_prover(1, 1, 1, 10).holds({0.5, 0.5}, 0, Grade::contractive));
    // the lattice's own limit, dt^2 omega^2/4 + dt tau sigma/2 = 1
    CHECK(!damped_prover(1, 1, 1, 1).holds({0.5, 0.5}, 0.9, Grade::paired));
}

TEST_CASE("a condition that does not let a constant displacement rest has no proof") {
    auto table = nmbcgen::derive({.horizon = 1,
                                  .order = 1,
                                  .stride = 1,
                                  .stabilisation = {},
                                  .damping = nmbcgen::Rational(1, 10)});
    table.b.front() = nmbcgen::to_rational_function(nmbcgen::constant(nmbcgen::Rational(-19, 10)));
    CHECK_THROWS_AS(Prover{table}, std::invalid_argument);
    CHECK_THROWS_AS(damped_prover(1, 1, 1, 10).holds({1, 1}, 0.1, Grade::paired, 0.5),
                    std::invalid_argument);
}

TEST_CASE("windows of G of a damped lattice are proved but for their ends") {
    const auto parts = proved_parts(damped_prover(1, 2, 1, 10), {1.01, 3}, 0, 1e-3);
    REQUIRE(parts.size() == 1);
    CHECK(parts.front().low == 1.01);
    CHECK(parts.front().high == 3);
    // Matched in a step, in which long waves cancel: that of 1/2 dX/c.
    const Prover matched(nmbcgen::derive({.horizon = 2,
                                          .order = 2,
                                          .stride = 2,
                                          .stabilisation = {},
                                          .damping = nmbcgen::Rational(1, 10),
                                          .time_step = nmbcgen::Rational(1, 2)}));
    const auto in_step = nmbcgen::parts_where(
        [&](const nmbc::Window& piece) { return matched.holds_in_step(piece, 0.5, Grade::paired); },
        {0.1, 2}, 1e-3, [](double) {});
    REQUIRE(in_step.size() == 1);
    CHECK(in_step.front().low == 0.1);
    CHECK(in_step.front().high == 2);
}

TEST_CASE("a window is searched in pieces that grow, and left where nothing holds") {
    std::size_t asked = 0;
    const auto parts_of = [&](double from, double to, const nmbc::Window& window) {
        asked = 0;
        return nmbcgen::parts_where(
            [&](const nmbc::Window& piece) {
                ++asked;
                return piece.high - piece.low < 0.01 && piece.low >= from && piece.high <= to;
            },
            window, 1e-4, [](double) {});
    };
    const auto parts = parts_of(0.2, 0.8, {0, 1});
    REQUIRE(parts.size() == 1);
    CHECK(parts.front().low >= 0.2);
    CHECK(parts.front().low < 0.2 + 1.0 / 200);  // what is left out after failures
    CHECK(parts.front().high > 0.8 - 1e-4);
    CHECK(parts.front().high <= 0.8);
    CHECK(parts_of(2, 3, {0, 1}).empty());
    CHECK(asked < 250);
    CHECK(parts_of(0, 1, {0.5, 0.5}).size() == 1);  // one G
    CHECK(parts_of(2, 3, {0.5, 0.5}).empty());
}

}  // namespace
