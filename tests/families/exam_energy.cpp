// SPDX-License-Identifier: GPL-2.0-or-later
/// Energy and symbol of a family belong together.
#include <doctest/doctest.h>
#include <ginac/ginac.h>

#include <stdexcept>

#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/lattice/symbol.hpp"
#include "generator/matching/freeze.hpp"
#include "tests/support/printed.hpp"

using GiNaC::ex;
using GiNaC::pow;
using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

const GiNaC::symbol z("z");
const GiNaC::symbol G("G");

/// stencil(z) = sum_i stencil_i z^(i - reach)
ex transform(const std::vector<Rational>& stencil, const ex& argument) {
    const int reach = int(stencil.size() / 2);
    ex sum = 0;
    for (std::size_t i = 0; i < stencil.size(); ++i) {
        sum += to_ginac(stencil[i]) * pow(argument, int(i) - reach);
    }
    return sum;
}

Rational sum_of(const std::vector<Rational>& stencil) {
    Rational sum = 0;
    for (const Rational& entry : stencil) {
        sum += entry;
    }
    return sum;
}

}  // namespace

TEST_CASE("omega^2 is the weighted sum of |stencil(z)|^2") {
    // On |z| = 1 the conjugate of stencil(z) is stencil(1/z).
    for (unsigned n = 1; n <= 6; ++n) {
        CAPTURE(n);
        const Model model = make_model("nopd1d", n);
        ex squares = 0;
        for (const ExactSquare& square : model.energy) {
            squares += thaw(square.weight, G) * transform(square.stencil, z) *
                       transform(square.stencil, 1 / z);
        }
        ex symbol = thaw(model.symbol[0], G);
        for (std::size_t m = 1; m < model.symbol.size(); ++m) {
            symbol += thaw(model.symbol[m], G) * (pow(z, int(m)) + pow(z, -int(m)));
        }
        CHECK(identical(squares, symbol));
    }
}

TEST_CASE("the squares are the strain (16) and one stabilisation state (34) for each bond") {
    for (unsigned n = 1; n <= 6; ++n) {
        CAPTURE(n);
        const Model model = make_model("nopd1d", n);
        REQUIRE(model.energy.size() == 1 + 2 * n);
        REQUIRE(model.symbol.size() == 2 * n + 1);  // reaches 2n neighbours
        CHECK(model.energy.front().part == EnergyPart::strain);
        CHECK(model.energy.front().weight == constant(1));
        // A unit strain u_{I+i} = i has strain 1 and leaves no stabilisation state; a rigid
        // shift has neither.
        for (std::size_t k = 0; k < model.energy.size(); ++k) {
            const ExactSquare& square = model.energy[k];
            REQUIRE(square.stencil.size() == 2 * n + 1);
            Rational unit_strain = 0;
            for (std::size_t i = 0; i < square.stencil.size(); ++i) {
                unit_strain += square.stencil[i] * (int(i) - int(n));
            }
            CHECK(unit_strain == int(k == 0));
            CHECK(sum_of(square.stencil) == 0);
            CHECK(square.part == (k == 0 ? EnergyPart::strain : EnergyPart::stabilisation));
        }
    }
}

TEST_CASE("a fixed answer: n = 1") {
    // eps = (u_1 - u_-1)/2 and both bonds have z = +-(u_-1 - 2 u_0 + u_1)/2, weight G.
    const Model model = make_model("nopd1d", 1);
    const Rational half(1, 2);
    CHECK(model.energy[0].stencil == std::vector<Rational>{-half, 0, half});
    CHECK(model.energy[1].stencil == std::vector<Rational>{half, -1, half});
    CHECK(model.energy[2].stencil == std::vector<Rational>{half, -1, half});
    const Polynomial once(std::vector<Rational>{0, 1});
    CHECK(model.energy[1].weight == once);
    CHECK(model.energy[2].weight == once);
}

TEST_CASE("damping: nothing without tau, and a fixed answer for n = 1") {
    const Model undamped = make_model("nopd1d", 1, 0);
    CHECK(undamped.damping.empty());
    CHECK(undamped.description == make_model("nopd1d", 1).description);
    // sigma = 2(1 - cos)^2 = 3 - 4 cos(xi) + cos(2 xi)
    const Model damped = make_model("nopd1d", 1, Rational(1, 10));
    CHECK(damped.damping ==
          std::vector<Rational>{Rational(3, 10), Rational(-2, 10), Rational(1, 20)});
    CHECK(damped.symbol == undamped.symbol);
    CHECK(damped.description == undamped.description + ", damping tau = 1/10");
}

TEST_CASE("wrong requests") {
    CHECK_THROWS_AS(make_model("nopd1d", 1, -1), std::invalid_argument);
    Model strain_only = make_model("nopd1d", 1);
    strain_only.energy.erase(strain_only.energy.begin() + 1, strain_only.energy.end());
    CHECK_THROWS_AS(damp(strain_only, Rational(1, 10)), std::invalid_argument);
    CHECK_NOTHROW(damp(strain_only, 0));
    CHECK_THROWS_AS(make_model("nopd3d", 1), std::invalid_argument);
    CHECK_THROWS_AS(make_model("", 1), std::invalid_argument);
    CHECK_THROWS_AS(symbol_of(std::vector<ExactSquare>{}), std::logic_error);
    REQUIRE_FALSE(families().empty());
    CHECK(families().front().name == "nopd1d");  // the default of the command line
}
