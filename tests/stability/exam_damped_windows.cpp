// SPDX-License-Identifier: GPL-2.0-or-later
/// Windows of damped lattices, with the condition matched to the damped symbol, as tables have it,
/// and with the one matched to the undamped symbol (docs/explanation/damping.md).
#include <doctest/doctest.h>

#include <vector>

#include "generator/pipeline.hpp"
#include "generator/stability/modal_windows.hpp"

namespace {

using nmbcgen::Rational;
using nmbcgen::Table;

struct Range {
    double low;
    double high;
};

void check_windows(const Table& table, const std::vector<Range>& expected) {
    const auto windows = modal_windows(table).modal;
    REQUIRE(windows.size() == expected.size());
    for (std::size_t i = 0; i < windows.size(); ++i) {
        constexpr double digits = 5e-5;  // four digits are given
        CHECK(std::abs(windows[i].low.inner - expected[i].low) <= digits);
        CHECK(std::abs(windows[i].high->inner - expected[i].high) <= digits);
    }
}

TEST_CASE("windows with either match") {
    struct Known {
        unsigned horizon, order, stride;
        Rational tau;
        std::vector<Range> damped_match;
        std::vector<Range> undamped_match;
    };
    for (const Known& known : {
             Known{2, 2, 2, Rational(1, 10), {{0, 3}}, {{0, 3}}},
             Known{3, 2, 3, Rational(1, 10), {{.0001, 3}}, {{0, 3}}},
             Known{3, 2, 3, Rational(3, 10), {{.0006, 3}}, {{0, 3}}},
             Known{2,
                   3,
                   2,
                   Rational(1, 10),
                   {{0, .0364}, {.0364, 2.0849}, {2.2162, 3}},
                   {{.2232, 2.6375}}},
             Known{1, 2, 1, Rational(1, 50), {{.0417, .9583}, {1, 1.9328}}, {{0, 1.7586}}},
         }) {
        CAPTURE(known.horizon);
        CAPTURE(known.order);
        const auto& [horizon, order, stride, tau, damped_match, undamped_match] = known;
        const Table matched = nmbcgen::derive({"nopd1d", horizon, order, stride, {}, tau});
        Table unmatched = nmbcgen::derive({"nopd1d", horizon, order, stride, {}, 0});
        unmatched.model = matched.model;
        check_windows(matched, damped_match);
        check_windows(unmatched, undamped_match);
    }
}

}  // namespace
