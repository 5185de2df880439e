// SPDX-License-Identifier: GPL-2.0-or-later
/// The windows of the committed tables at random G: chains inside do not grow, chains outside do.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <nmbc/certificate.hpp>
#include <nmbc/coefficients.hpp>
#include <nmbc/tables/tables.hpp>
#include <vector>

#include "generator/pipeline.hpp"
#include "generator/stability/certify.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"
#include "tests/stability/spectra.hpp"
#include "tests/support/generators.hpp"
#include "tests/support/read_tables.hpp"

namespace {

using nmbc::MatchingTable;
using nmbc::Window;
using nmbcgen::Failure;
using nmbcgen::HalfSpace;
using nmbcgen::Rational;
using nmbcgen::test::spectral_abscissa;

/// Certified chains of committed tables are shorter (tests/stability/exam_short_chains.cpp).
constexpr std::size_t shortest = 40;
constexpr std::size_t longest = 160;

/// Roundings of eigenvalues: 2e-12 c/dX at most in thousands of chains without growth. Growth by
/// less would take 1e11 time units to be seen.
constexpr double roundings = 1e-11;

/// The committed tables to horizon 3: larger matrices take longer than they tell more.
std::vector<const MatchingTable*> tables(bool with_window) {
    std::vector<const MatchingTable*> chosen;
    std::ranges::copy_if(nmbc::generated::tables, std::back_inserter(chosen),
                         [with_window](const MatchingTable* table) {
                             return table->lattice->horizon <= 3 &&
                                    !(with_window && table->modal.empty());
                         });
    return chosen;
}

template <class List>
auto element_of(const List& list) {
    return list[std::size_t(nmbcgen::test::whole_number(0, int(std::size(list))))];
}

/// A multiple of 1e-4 in the window; of one without an end, to 20 above its lower edge.
Rational value_in(const Window& window) {
    constexpr int denominator = 10000;
    const double high = std::min(window.high, window.low + 20);
    return {nmbcgen::test::whole_number(int(std::ceil(window.low * denominator)),
                                        int(std::floor(high * denominator)) + 1),
            denominator};
}

HalfSpace half_space(const MatchingTable& table, const Rational& G) {
    RC_LOG() << table.name << " at G = " << G << '\n';
    return make_half_space(nmbcgen::test::read_table(table), G);
}

TEST_CASE("inside a window no chain grows") {
    CHECK(rc::check([] {
        const auto& table = *element_of(tables(true));
        Window window = element_of(table.modal);
        constexpr double margin = 1e-3;
        window = {window.low == 0 ? 0 : window.low + margin, window.high - margin};
        const HalfSpace h = half_space(table, value_in(window));
        for (const std::size_t nodes :
             {shortest, shortest + 1, 80UL, 81UL, 100UL, 101UL, longest - 1, longest}) {
            RC_ASSERT(nodes < std::size_t(table.least_nodes) ||
                      spectral_abscissa(h, nodes) < roundings);
        }
    }));
}

/// Where the amplified band is narrow it takes a length that fits it: at n = 3, N = 2, stride 3,
/// G = 1.05 those of 61 to 73 nodes, 96 to 109, .. What is amplified by less may need longer ones.
TEST_CASE("outside of the windows some chain grows") {
    CHECK(rc::check([] {
        const auto& table = *element_of(tables(false));
        RC_PRE(table.lattice->tau == "0" &&
               table.time_step == "0");  // what a damped chain may do is a bound (exam_damped.cpp)
        const Rational G = value_in({0.01, 12});  // some have a pole at 0
        RC_PRE(std::ranges::none_of(table.modal, [&G](const Window& window) {
            constexpr double margin = 0.05;
            return Window{window.low - margin, window.high + margin}.contains(
                G.convert_to<double>());
        }));
        const HalfSpace h = half_space(table, G);
        const auto verdict = modal_verdict(h);
        RC_ASSERT(verdict.failure != Failure::none);
        RC_PRE(verdict.failure != Failure::amplified_wave || verdict.supremum > 1.02);
        std::size_t nodes = shortest;
        while (nodes <= longest && spectral_abscissa(h, nodes) <= roundings) {
            nodes += 3;
        }
        RC_ASSERT(nodes <= longest);
    }));
}

/// The largest factor of a step of this cfl in a chain with two such ends, or a fixed one opposite.
double largest_factor(const HalfSpace& h, double cfl, std::size_t nodes, bool like = true) {
    const nmbcgen::LatticeEnd end{nmbcgen::LatticeEnd::Kind::matching, h};
    const double time_step = 2 * cfl / maximum_frequency(h);
    return like ? spectral_radius(end, nodes, time_step)
                : spectral_radius(end, fixed_end(h), nodes, time_step);
}

/// Of what breaks at its ends: a third of all draws.
bool is_at_an_end() {
    return nmbcgen::test::whole_number(0, 3) == 0;
}

/// A certified cfl: the largest, or one from 1e-5 on, all orders of magnitude alike.
double cfl_in(const nmbc::StableStep& steps) {
    const double low = std::max(steps.from, 1e-5);
    const double part = is_at_an_end() ? 1 : nmbcgen::test::whole_number(0, 1001) / 1000.0;
    const double cfl = low * std::pow(steps.cfl / low, part);
    RC_LOG() << "cfl " << cfl << '\n';
    return cfl;
}

/// In steps this short the double factor 1 of a constant and of a uniform velocity splits by the
/// square root of roundings.
constexpr double root_of_roundings = 1e-7;

/// Against a like end, or against a fixed one where any that adds no energy is allowed.
TEST_CASE("in no certified step a chain of the committed tables grows") {
    std::vector<const MatchingTable*> certified;
    std::ranges::copy_if(nmbc::generated::tables, std::back_inserter(certified),
                         [](const MatchingTable* table) { return !table->max_cfl.empty(); });
    CHECK(rc::check([&certified] {
        const auto& table = *element_of(certified);
        const Window window = element_of(table.max_cfl).window;
        const double part = is_at_an_end() ? element_of(std::vector{1e-6, 1 - 1e-6})
                                           : nmbcgen::test::whole_number(0, 1001) / 1000.0;
        const double G = window.low + part * (std::min(window.high, window.low + 20) - window.low);
        const bool like = nmbcgen::test::whole_number(0, 2) == 0;
        const nmbc::StableStep steps =
            nmbc::certified_steps(table, G, like ? nmbc::Opposite::like : nmbc::Opposite::any);
        RC_PRE(steps.cfl > 0);
        const HalfSpace h = half_space(table, Rational(G));
        const double own_step = nmbc::detail::nearest_to_fraction(table.time_step);
        const double cfl = own_step > 0 ? cfl_of(h, own_step) : cfl_in(steps);
        const int longer = is_at_an_end() ? 0 : nmbcgen::test::whole_number(0, 40);
        const auto nodes = std::size_t(table.least_nodes + longer);
        RC_LOG() << nodes << " nodes" << (like ? "" : ", a fixed end opposite") << '\n';
        RC_ASSERT(largest_factor(h, cfl, nodes, like) < 1 + root_of_roundings);
    }));
}

TEST_CASE("nor do chains of tables with a pole near which modes grow in short steps") {
    for (const nmbcgen::Specification& what :
         {nmbcgen::Specification{.horizon = 2,
         .order = 3,
         .stride = 2,
         .stabilisation = {},
         .damping = Rational(1, 10)},
          nmbcgen::Specification{
              .horizon = 1, .order = 2, .stabilisation = {}, .damping = Rational(1, 50)}}) {
        const nmbcgen::Table table = nmbcgen::derive(what);
        const auto pieces = nmbcgen::certify(table).max_cfl;
        REQUIRE(std::ranges::any_of(pieces, [](const auto& steps) { return steps.from > 0; }));
        CHECK(rc::check([&] {
            const nmbc::StableStep steps = element_of(pieces);
            const double part = nmbcgen::test::whole_number(1, 1000) / 1000.0;
            const double G = steps.window.low + part * (steps.window.high - steps.window.low);
            RC_LOG() << "G " << G << ", from " << steps.from << '\n';
            const auto nodes = std::size_t(100 + nmbcgen::test::whole_number(0, 20));
            const HalfSpace h = make_half_space(table, Rational(G));
            RC_ASSERT(largest_factor(h, cfl_in(steps), nodes) < 1 + root_of_roundings);
        }));
    }
}

}  // namespace
