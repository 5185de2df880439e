// SPDX-License-Identifier: GPL-2.0-or-later
/// Where the certified steps at one G end, against numbers worked out by hand and chains as
/// matrices.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <variant>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/step_edges.hpp"

namespace {

using nmbcgen::AlgebraicNumber;
using nmbcgen::CflBracket;
using nmbcgen::Failure;
using nmbcgen::Grade;
using nmbcgen::HalfSpace;
using nmbcgen::StepEdge;

HalfSpace half_space_of(unsigned horizon, unsigned order, unsigned stride, const char* G) {
    const auto table = nmbcgen::derive(
        {.horizon = horizon, .order = order, .stride = stride, .stabilisation = {}});
    return make_half_space(table, nmbcgen::parse_rational(G));
}

/// By how much the largest factor of a step is above 1, at a cfl so far off the edge; like ends.
double growth_beside(const HalfSpace& h, const StepEdge& edge, double off) {
    const nmbcgen::LatticeEnd end{nmbcgen::LatticeEnd::Kind::matching, h};
    constexpr std::size_t nodes = 80;
    return spectral_radius(end, nodes, 2 * (edge.cfl + off) / maximum_frequency(h)) - 1;
}

// omega = 2 sin(xi/2) at n = 1, G = 1/2. C has a zero k of a stiff mode, whose sigma = B/C passes
// infinity where omega(k) dt/2 = 1.
TEST_CASE("steps of the chain of atoms end at rational (dt/2)^2") {
    struct Case {
        unsigned order;
        const char* square;
        double cfl;
        Failure beyond;
    };
    for (const Case& each :
         {Case{1, "1/4", 1, Failure::none}, Case{2, "1/8", std::sqrt(0.5), Failure::growing_mode},
          Case{3, "1/16", 0.5, Failure::growing_mode}}) {
        CAPTURE(each.order);
        const HalfSpace h = half_space_of(1, each.order, 1, "1/2");
        for (const Grade grade : {Grade::paired, Grade::contractive}) {
            const auto edge = nmbcgen::StepEdges(h).edge(grade);
            REQUIRE(edge.has_value());
            const auto* exact = std::get_if<AlgebraicNumber>(&edge->where);
            REQUIRE(exact != nullptr);
            CHECK(to_text(*exact) == each.square);
            CHECK(edge->cfl <= each.cfl);
            CHECK(edge->cfl > each.cfl - 1e-14);  // rounded down by a few units in the last place
            CHECK(edge->beyond == each.beyond);
        }
    }
}

// Complex k at which omega^2 is real become a mode of imaginary sigma (N = 2, 3), or a wave of
// NMBC1 has the frequency of an extremum of the band and beta = Omega.
TEST_CASE("edges of several waves are algebraic, of any degree") {
    struct Case {
        unsigned horizon, order, stride;
        const char* G;
        double cfl;  ///< of a search by spectra alone, which sees amplification late
        std::size_t degree;
    };
    for (const Case& each :
         {Case{1, 1, 1, "1/10", 0.790569422, 1}, Case{2, 1, 1, "1", 0.825512087, 3},
          Case{2, 2, 2, "1", 0.750171109, 14}, Case{2, 3, 2, "1", 0.379908794, 22}}) {
        CAPTURE(each.order);
        const auto edge =
            nmbcgen::StepEdges(half_space_of(each.horizon, each.order, each.stride, each.G))
                .edge(Grade::paired);
        REQUIRE(edge.has_value());
        const auto* exact = std::get_if<AlgebraicNumber>(&edge->where);
        REQUIRE(exact != nullptr);
        CHECK(exact->polynomial.degree() == each.degree);
        constexpr double seen_late = 2e-8;
        CHECK(edge->cfl <= each.cfl + 1e-9);
        CHECK(edge->cfl > each.cfl - seen_late);
    }
}

TEST_CASE("chains grow beyond an edge at once, and below it they do not") {
    for (const HalfSpace& h : {half_space_of(1, 2, 1, "1/2"), half_space_of(1, 3, 1, "1/2"),
                               half_space_of(2, 2, 2, "1"), half_space_of(2, 3, 2, "1")}) {
        const auto edge = nmbcgen::StepEdges(h).edge(Grade::paired);
        REQUIRE(edge.has_value());
        CHECK(edge->beyond == Failure::growing_mode);
        constexpr double near = 1e-4;
        // of eigenvalues, among which the double 1 of a constant and a uniform velocity splits
        constexpr double root_of_roundings = 1e-7;
        CHECK(growth_beside(h, *edge, -near) < root_of_roundings);
        CHECK(growth_beside(h, *edge, near) > 1e-5);
    }
}

TEST_CASE("an edge in the midst of the band is a bracket") {
    // paired to 0.617.., contractive to 0.464..
    const HalfSpace h = half_space_of(3, 2, 3, "27/7");
    const auto edge = nmbcgen::StepEdges(h).edge(Grade::contractive);
    REQUIRE(edge.has_value());
    const auto* bracket = std::get_if<CflBracket>(&edge->where);
    REQUIRE(bracket != nullptr);
    CHECK(bracket->high - bracket->low <= 1e-9);
    CHECK(edge->cfl == bracket->low);
    CHECK(edge->cfl == doctest::Approx(0.464221137).epsilon(1e-8));
    CHECK(edge->beyond == Failure::none);  // paired goes on
    CHECK(!nmbcgen::StepEdges(half_space_of(2, 1, 1, "1")).edge(Grade::contractive).has_value());
}

}  // namespace
