// SPDX-License-Identifier: GPL-2.0-or-later
/// prove() accepts every table the generator derives and none that was changed in one place.
/// (tests/emit changes every number of the committed set; here tables are random.)
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/matching/proof.hpp"
#include "generator/pipeline.hpp"
#include "tests/support/generators.hpp"
#include "tests/support/mutations.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

Specification random_condition() {
    Specification what{.family = "nopd1d",
                       .horizon = *rc::gen::inRange(1U, 6U),
                       .order = *rc::gen::inRange(1U, 7U),
                       .stride = *rc::gen::inRange(1U, 4U),
                       .stabilisation = {}};
    if (*rc::gen::arbitrary<bool>()) {
        what.stabilisation = *positive_rational();
    }
    if (*rc::gen::arbitrary<bool>()) {
        what.damping = *positive_damping();
    }
    return what;
}

Table random_table() {
    const Specification what = random_condition();
    try {
        return derive(what);
    } catch (const NoSuchBoundary&) {
        RC_DISCARD("no such boundary condition");
    }
}

Table random_damped_table() {
    Table table = random_table();
    RC_PRE(table.specification.damping != 0);
    return table;
}

/// What prove() says against the table; empty where it accepts it.
std::string objection(const Table& table) {
    try {
        return prove(table) == table.proved ? "" : "proved something else";
    } catch (const std::logic_error& error) {
        return error.what();
    }
}

/// Adds a random non-zero number, in one random power of G, to a polynomial.
void nudge(Polynomial& polynomial) {
    const Rational change =
        *rc::gen::suchThat(small_rational(), [](const Rational& r) { return r != 0; });
    const std::size_t power = *rc::gen::inRange<std::size_t>(0, 4);
    std::vector<Rational> term(power + 1, Rational(0));
    term[power] = change;
    polynomial += Polynomial(std::move(term));
}

template <class List>
auto& any_of(List& list) {
    return list[*rc::gen::inRange<std::size_t>(0, list.size())];
}

/// Changes the value of a rational function, keeping its normal form.
void nudge(ExactFunction& function) {
    Polynomial numerator = over_rationals(function.numerator);
    nudge(numerator);
    function = reduce(numerator, over_rationals(function.denominator));
}

}  // namespace

TEST_CASE("every derived table is proved") {
    CHECK(rc::check("random horizon, order, stride, G fixed or not", [] {
        const Table table = random_table();
        RC_ASSERT(objection(table).empty());
        RC_ASSERT(table.c.size() == table.specification.order + 1);
    }));
}

TEST_CASE("a table changed in one place is refused, and the place is named") {
    const auto refused = [](const std::string& name, const std::string& reason,
                            const std::function<void(Table&)>& change) {
        CHECK(rc::check(name, [&] {
            Table table = random_table();
            change(table);
            RC_LOG(objection(table));
            RC_ASSERT(objection(table).find(reason) != std::string::npos);
        }));
    };
    refused("c_j", "not proved", [](Table& table) { nudge(any_of(table.c)); });
    refused("b_j", "residual of (49)", [](Table& table) { nudge(any_of(table.b)); });
    refused("a_k", "Taylor coefficients", [](Table& table) { nudge(any_of(table.taylor)); });
    refused("the other root of omega^2", "Taylor coefficients", [](Table& table) {
        // a_k only enters squared or together with b: all signs turned is another solution, whose
        // boundary absorbs what goes in and emits what should come in.
        for (Polynomial& a : table.taylor) {
            a = -a;
        }
        for (ExactFunction& b : table.b) {
            b.numerator = -b.numerator;
        }
    });
    refused("symbol", "symbol", [](Table& table) { nudge(any_of(table.model.symbol)); });
    refused("weight", "symbol follows from the energy",
            [](Table& table) { nudge(any_of(table.model.energy).weight); });
    refused("stride", "residual", [](Table& table) { ++table.specification.stride; });
    refused("order", "sizes", [](Table& table) { ++table.specification.order; });
    refused("c and b scaled together", "c_0 = 1", [](Table& table) {
        for (auto* list : {&table.c, &table.b}) {
            for (ExactFunction& function : *list) {
                function = reduce(over_rationals(function.numerator) * constant(2),
                                  over_rationals(function.denominator));
            }
        }
    });
    refused("a coefficient not in lowest terms", "normal form", [](Table& table) {
        ExactFunction& function = any_of(table.b);
        function.numerator *= Integer(3);
        function.denominator *= Integer(3);
    });
    refused("a common factor of degree 1", "normal form", [](Table& table) {
        ExactFunction& function = any_of(table.b);
        const IntegerPolynomial factor(std::vector<Integer>{1, 1});
        function.numerator *= factor;
        function.denominator *= factor;
    });
}

TEST_CASE("damping changed in one place is refused, and the place is named") {
    const auto refused = [](const std::string& name, const std::string& reason,
                            const std::function<void(Table&)>& change) {
        CHECK(rc::check(name, [&] {
            Table table = random_damped_table();
            change(table);
            RC_LOG(objection(table));
            RC_ASSERT(objection(table).find(reason) != std::string::npos);
        }));
    };
    refused("tau", "damping follows", [](Table& table) { table.specification.damping *= 2; });
    refused("tau < 0", "tau >= 0", [](Table& table) {
        table.specification.damping *= -1;
        for (Rational& coefficient : table.model.damping) {
            coefficient *= -1;
        }
    });
    refused("tau = 0", "only there", [](Table& table) { table.specification.damping = 0; });
    refused("no damping", "only there", [](Table& table) { table.model.damping.clear(); });
    refused("a reach too short", "reaches as far",
            [](Table& table) { table.model.damping.pop_back(); });
    refused("a square counted as strain", "damping",
            [](Table& table) { table.model.energy.back().part = EnergyPart::strain; });
    CHECK(rc::check("damping that nobody asked for", [] {
        Table table = random_table();
        RC_PRE(table.specification.damping == 0);
        table.model.damping.assign(table.model.symbol.size(), Rational(0));
        RC_ASSERT(objection(table) == "not proved: damping where tau > 0, and only there");
    }));
}

TEST_CASE("no number of the damping can be changed, G open, fixed or zero") {
    for (const std::optional<Rational>& G :
         {std::optional<Rational>(), std::optional<Rational>(Rational(2, 3)),
          std::optional<Rational>(0)}) {
        Table table = derive({.family = "nopd1d",
                              .horizon = 2,
                              .order = 2,
                              .stride = 2,
                              .stabilisation = G,
                              .damping = Rational(1, 10)});
        REQUIRE(objection(table).empty());
        CHECK(table.proved.find("damping") != std::string::npos);
        int mutants = 0;
        for (Rational& coefficient : table.model.damping) {
            const Rational before = coefficient;
            for (const std::string& mutant : mutations(to_string(before))) {
                const std::size_t slash = mutant.find('/');
                const Integer denominator =
                    slash == std::string::npos ? Integer(1) : Integer(mutant.substr(slash + 1));
                if (denominator == 0) {
                    continue;
                }
                coefficient = Rational(Integer(mutant.substr(0, slash)), denominator);
                CAPTURE(mutant);
                CHECK(objection(table).starts_with("not proved"));
                ++mutants;
            }
            coefficient = before;
        }
        CHECK(mutants > 30);
    }
}

TEST_CASE("C(1) = 0 is refused even where the residual vanishes") {
    // n = 1, G = 1: (49) for N = 3 has the solution (z-1)^2 (NMBC1), see exam_degeneracies.cpp.
    Table table = derive(
        {.family = "nopd1d", .horizon = 1, .order = 4, .stride = 1, .stabilisation = Rational(1)});
    table.specification.order = 3;
    table.taylor.resize(7);
    const auto list = [](const std::vector<int>& numbers) {
        std::vector<ExactFunction> functions;
        functions.reserve(numbers.size());
        for (const int number : numbers) {
            functions.push_back(to_rational_function(constant(number)));
        }
        return functions;
    };
    table.c = list({1, -1, -1, 1});
    table.b = list({-2, 6, -6, 2});
    CHECK(objection(table) == "not proved: C(1) is not zero");
}
