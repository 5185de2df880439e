// SPDX-License-Identifier: GPL-2.0-or-later
/// What certified_cfl() promises for any opposite end that adds no energy: at that step a chain
/// with a fixed or a free end does not grow, and at the step for like ends it can.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nmbc/certificate.hpp>
#include <nmbc/tables/tables.hpp>
#include <vector>

#include "generator/stability/discrete.hpp"
#include "generator/stability/round_trip.hpp"
#include "tests/support/read_tables.hpp"

namespace {

using nmbc::MatchingTable;
using nmbc::Opposite;
using nmbcgen::HalfSpace;
using nmbcgen::LatticeEnd;
using nmbcgen::Rational;

/// A matching end in steps of a cfl, and the two ends that keep the energy, of one lattice.
struct Ends {
    double time_step = 0;
    LatticeEnd matching;
    LatticeEnd fixed;
    LatticeEnd free;
};

Ends ends_at(const MatchingTable& table, const Rational& G, double cfl) {
    const HalfSpace h = make_half_space(nmbcgen::test::read_table(table), G);
    const double time_step = 2 * cfl / maximum_frequency(h);
    return {
        time_step, {LatticeEnd::Kind::matching, stepped(h, time_step)}, fixed_end(h), free_end(h)};
}

/// The largest spectral radius of chains of 60 and 61 nodes between such ends.
double radius(const Ends& ends, const LatticeEnd& opposite) {
    double largest = 0;
    for (const std::size_t nodes : {60U, 61U}) {
        largest =
            std::max(largest, spectral_radius(ends.matching, opposite, nodes, ends.time_step));
    }
    return largest;
}

/// The double eigenvalue 1 of a constant and its uniform velocity splits by sqrt(eps) = 1.5e-8, and
/// by a few times more in a chain of 60 nodes.
constexpr double roundings = 1e-7;

double certified(const MatchingTable& table, double G, Opposite opposite) {
    return nmbc::certified_cfl(table, G, opposite);
}

TEST_CASE("n = 3, N = 2, stride 3, G = 4: contractive, and yet not at the step for like ends") {
    const MatchingTable& table = nmbc::generated::nopd1d_n3_order2_s3;
    const Ends like = ends_at(table, 4, certified(table, 4, Opposite::like));
    const auto verdict = round_trip_verdict(like.matching, like.fixed);
    CHECK(verdict.failure == nmbcgen::Failure::amplified_wave);
    CHECK(verdict.amplification > 1.05);  // 9.4 % were found
    CHECK(radius(like, like.fixed) > 1 + 100 * roundings);
    const Ends any = ends_at(table, 4, certified(table, 4, Opposite::any));
    for (const LatticeEnd& opposite : {any.fixed, any.free}) {
        CHECK(round_trip_verdict(any.matching, opposite).failure == nmbcgen::Failure::none);
        CHECK(radius(any, opposite) < 1 + roundings);
    }
}

TEST_CASE("at the step for any end no chain grows between this, a fixed and a free one") {
    std::vector<const MatchingTable*> tables;
    std::ranges::copy_if(
        nmbc::generated::tables, std::back_inserter(tables), [](const MatchingTable* table) {
            return table->lattice->horizon <= 3 && !table->max_cfl_contractive.empty();
        });
    REQUIRE(tables.size() > 5);
    // rapidcheck alone would begin with small numbers.
    const auto number_below = [](std::size_t count) {
        return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(std::size_t{0}, count));
    };
    CHECK(rc::check([&] {
        const MatchingTable& table = *tables[number_below(tables.size())];
        const nmbc::Window window =
            table.max_cfl_contractive[number_below(table.max_cfl_contractive.size())].window;
        const double high = std::min(window.high, window.low + 20);
        constexpr std::size_t parts = 1000;
        // Edges themselves are where the supremum is 1, or poles.
        const double part = (0.5 + double(number_below(parts))) / parts;
        const Rational G(window.low + part * (high - window.low));
        const double cfl = certified(table, G.convert_to<double>(), Opposite::any);
        RC_LOG() << table.name << " at G = " << G.convert_to<double>() << ", cfl = " << cfl << '\n';
        RC_ASSERT(cfl > 0);
        const Ends ends = ends_at(table, G, cfl);
        for (const LatticeEnd& opposite : {ends.fixed, ends.free}) {
            RC_ASSERT(round_trip_verdict(ends.matching, opposite).failure ==
                      nmbcgen::Failure::none);
            RC_ASSERT(radius(ends, opposite) < 1 + roundings);
        }
    }));
}

}  // namespace
