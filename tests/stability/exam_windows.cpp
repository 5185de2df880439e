// SPDX-License-Identifier: GPL-2.0-or-later
/// The windows of G in which a boundary is certified: every edge that is known.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/certify.hpp"
#include "generator/stability/modal_windows.hpp"

namespace {

using nmbcgen::AlgebraicNumber;
using nmbcgen::Bracket;
using nmbcgen::Edge;
using nmbcgen::Failure;
using nmbcgen::over_rationals;
using nmbcgen::Rational;
using nmbcgen::StabilityWindow;
using nmbcgen::Table;

/// Values are given to six decimals.
constexpr double half_of_last_digit = 5e-7;

/// How an edge has to be known.
enum class Known { exactly, as_algebraic_number, within_a_bracket };

struct KnownEdge {
    Known known;
    std::string text;  ///< of an exact one
    double value;
    Failure beyond;
};

KnownEdge exact(std::string text, double value, Failure beyond) {
    return {Known::exactly, std::move(text), value, beyond};
}

/// Of degree 3 or more, so that it has no text.
KnownEdge algebraic(double value, Failure beyond) {
    return {Known::as_algebraic_number, "", value, beyond};
}

KnownEdge bracket(double value, Failure beyond) {
    return {Known::within_a_bracket, "", value, beyond};
}

const KnownEdge from_zero = exact("0", 0, Failure::none);
const KnownEdge no_end{Known::exactly, "none", 0, Failure::none};

struct KnownWindow {
    KnownEdge low;
    KnownEdge high;
};

struct KnownTable {
    unsigned horizon, order, stride;
    std::vector<KnownWindow> modal;
    std::vector<KnownWindow> contractive;
};

// Beyond an edge of the contractive windows alone the boundary is stable with its like, so that
// nothing fails.
constexpr auto paired = Failure::none;
constexpr auto backward = Failure::backward_band;
constexpr auto growing = Failure::growing_mode;
constexpr auto resonance = Failure::resonance;

/// 1032/1445 at n = 2, and its like at n = 3: below it backward waves reach down among the others.
const KnownEdge threshold_1 = exact("1/4", 0.25, backward);
const KnownEdge threshold_2 = exact("1032/1445", 0.714187, backward);
const KnownEdge threshold_3 = exact("(-282042 + 29079*sqrt(718))/393764", 1.262546, backward);

/// Values of n = 1 and the thresholds by computer algebra; 208/85, where NMBC1 gains an order; the
/// others to three digits by two prototypes (eigenvalues of assembled chains up to 300 nodes) and
/// to six by the bisection itself, so that these hold what was once found.
const std::vector<KnownTable> known_tables{
    {1, 1, 1, {{from_zero, no_end}}, {{exact("1/4", 0.25, paired), no_end}}},
    {1, 2, 1, {{threshold_1, exact("1", 1, resonance)}}, {{threshold_1, exact("1", 1, resonance)}}},
    {1,
     3,
     1,
     {{threshold_1, exact("2/3", 0.666667, resonance)}, {exact("2", 2, growing), no_end}},
     {{threshold_1, exact("2/3", 0.666667, resonance)}, {exact("2", 2, growing), no_end}}},
    {1,
     4,
     1,
     {{threshold_1, exact("2 - sqrt(2)", 0.585786, resonance)},
      {exact("1", 1, growing), exact("2 + sqrt(2)", 3.414214, resonance)}},
     {{threshold_1, exact("2 - sqrt(2)", 0.585786, resonance)},
      {exact("1", 1, growing), exact("2 + sqrt(2)", 3.414214, resonance)}}},
    {2, 1, 1, {{from_zero, bracket(3.500201, backward)}}, {}},
    {2,
     2,
     1,
     {{exact("208/85", 2.447059, resonance), bracket(3.774204, backward)}},
     {{bracket(2.452769, paired), bracket(3.770356, paired)}}},
    {2,
     3,
     1,
     {{bracket(1.774591, backward), bracket(1.923117, backward)},
      {algebraic(4.437191, growing), bracket(23.042327, backward)}},
     {{bracket(1.776667, paired), bracket(1.886607, paired)}}},
    {2,
     4,
     1,
     {{algebraic(7.302332, resonance), bracket(13.939337, backward)}},
     {{bracket(8.179059, paired), bracket(11.215039, paired)}}},
    {2,
     2,
     2,
     {{threshold_2, bracket(2.969934, backward)}},
     {{threshold_2, bracket(2.930754, paired)}}},
    {2,
     3,
     2,
     {{bracket(0.860776, growing), bracket(2.063584, backward)},
      {algebraic(6.948248, growing), bracket(15.340491, growing)}},
     {{bracket(0.860776, growing), bracket(2.059192, paired)},
      {algebraic(6.948248, growing), bracket(15.340491, growing)}}},
    {2,
     4,
     2,
     {{bracket(1.133179, growing), bracket(1.842930, backward)},
      {algebraic(3.461348, growing), bracket(9.285426, backward)}},
     {{bracket(1.133179, growing), bracket(1.803249, paired)},
      {algebraic(3.461348, growing), bracket(9.269867, paired)}}},
    {2,
     2,
     4,
     {{bracket(0.078804, backward), bracket(0.339332, backward)}},
     {{bracket(0.106657, paired), bracket(0.186629, paired)}}},
    {3, 1, 1, {{from_zero, bracket(5.579020, backward)}}, {}},
    {3, 2, 1, {}, {}},
    {3, 3, 1, {{bracket(3.202409, backward), bracket(3.386089, backward)}}, {}},
    {3,
     1,
     3,
     {{exact("243/280", 0.867857, backward), bracket(12.908799, backward)}},
     {{exact("(-282042 + 29079*sqrt(718))/393764", 1.262546, paired), bracket(11.136391, paired)}}},
    {3,
     2,
     3,
     {{threshold_3, bracket(4.552392, backward)}},
     {{threshold_3, bracket(4.026523, paired)}}},
    {3,
     3,
     3,
     {{bracket(1.853107, growing), bracket(2.929946, backward)}},
     {{bracket(1.853107, growing), bracket(2.900950, paired)}}},
};

void check_edge(const Edge& edge, const KnownEdge& known, bool lower) {
    CAPTURE(known.value);
    CHECK(name_of(edge.beyond) == name_of(known.beyond));
    if (const auto* number = std::get_if<AlgebraicNumber>(&edge.where)) {
        CHECK(known.known != Known::within_a_bracket);
        CHECK(std::abs(edge.inner - known.value) <= 2 * half_of_last_digit);
        CHECK(to_text(*number) == known.text);
        CHECK(std::abs(nearest_double(*number) - known.value) <= half_of_last_digit);
        CHECK((lower ? compare(*number, Rational(edge.inner)) <= 0
                     : compare(*number, Rational(edge.inner)) >= 0));
    } else {
        const auto& found = std::get<Bracket>(edge.where);
        CHECK(known.known == Known::within_a_bracket);
        CHECK(found.low < found.high);
        CHECK(found.high - found.low <= 1e-6);
        CHECK(found.low - half_of_last_digit <= known.value);
        CHECK(known.value <= found.high + half_of_last_digit);
        CHECK(edge.inner == (lower ? found.high : found.low));
    }
}

void check_windows(const std::vector<StabilityWindow>& windows,
                   const std::vector<KnownWindow>& known) {
    REQUIRE(windows.size() == known.size());
    for (std::size_t i = 0; i < windows.size(); ++i) {
        check_edge(windows[i].low, known[i].low, true);
        REQUIRE(windows[i].high.has_value() == (known[i].high.text != "none"));
        if (windows[i].high) {
            check_edge(*windows[i].high, known[i].high, false);
        }
    }
}

double upper_end(const StabilityWindow& window) {
    return window.high ? window.high->inner : std::numeric_limits<double>::infinity();
}

bool within(const StabilityWindow& inner, const StabilityWindow& outer) {
    return outer.low.inner <= inner.low.inner && upper_end(inner) <= upper_end(outer);
}

TEST_CASE("every window, its edges and what fails beyond them") {
    for (const KnownTable& known : known_tables) {
        CAPTURE(known.horizon);
        CAPTURE(known.order);
        CAPTURE(known.stride);
        const auto table =
            nmbcgen::derive({"nopd1d", known.horizon, known.order, known.stride, std::nullopt});
        const auto windows = nmbcgen::modal_windows(table);
        {
            INFO("modal");
            check_windows(windows.modal, known.modal);
        }
        {
            INFO("contractive");
            check_windows(windows.contractive, known.contractive);
        }
        for (const StabilityWindow& contractive : windows.contractive) {
            CHECK(std::ranges::any_of(windows.modal, [&](const StabilityWindow& modal) {
                return within(contractive, modal);
            }));
        }
    }
}

/// c_j are those of NMBC1 at n = 1, b_j those times the factor: s (1 + k) = 2 factor (k - 1), where
/// every |k| < 1 has Re s < 0 and, the band being monotone above G = 1/4, |R| <= 1.
Table scaled_nmbc1(const nmbcgen::ExactFunction& factor) {
    Table table = nmbcgen::derive({"nopd1d", 1, 1, 1, std::nullopt});
    for (nmbcgen::ExactFunction& b : table.b) {
        b = nmbcgen::reduce(over_rationals(b.numerator) * over_rationals(factor.numerator),
                            over_rationals(b.denominator) * over_rationals(factor.denominator));
    }
    return table;
}

// No committed table has a pole inside a window.
TEST_CASE("a pole splits the window it lies in") {
    const nmbcgen::Polynomial squared(std::vector<Rational>{4, -4, 1});  // (G - 2)^2
    const auto factor = nmbcgen::reduce(squared + nmbcgen::constant(1), squared);
    const auto windows = nmbcgen::modal_windows(scaled_nmbc1(factor));
    const KnownEdge pole = exact("2", 2, Failure::pole);
    check_windows(windows.modal, {{from_zero, pole}, {pole, no_end}});
    check_windows(windows.contractive, {{exact("1/4", 0.25, paired), pole}, {pole, no_end}});
}

TEST_CASE("a value with C(1) = 0 that is a double is not in the window beside it") {
    const auto windows =
        nmbcgen::modal_windows(nmbcgen::derive({"nopd1d", 1, 2, 1, {}, Rational(1) / 50}));
    CHECK(windows.modal.back().low.beyond == Failure::jordan_block);
    CHECK(windows.modal.back().low.inner == 1 + 1e-9);
}

TEST_CASE("a table at a fixed G has that point for a window, or none") {
    const auto certificate = [](unsigned order, const Rational& G) {
        return nmbcgen::certify(nmbcgen::derive({"nopd1d", 1, order, 1, G}));
    };
    const auto is_half = [](const std::vector<StabilityWindow>& windows) {
        return windows.size() == 1 && windows[0].high && windows[0].low.inner == 0.5 &&
               windows[0].high->inner == 0.5 &&
               to_text(std::get<AlgebraicNumber>(windows[0].low.where)) == "1/2";
    };
    const auto stable = certificate(2, Rational(1) / 2);
    CHECK(is_half(stable.modal));
    CHECK(is_half(stable.contractive));
    CHECK(stable.reflection.size() == 1);
    REQUIRE(stable.max_cfl.size() == 1);
    CHECK(stable.max_cfl[0].window.low == 0.5);
    CHECK(stable.max_cfl[0].window.high == 0.5);
    // 0.70 by assembled spectra, found in steps of 0.01.
    CHECK(std::abs(stable.max_cfl[0].cfl - 0.70) < 0.0101);

    const auto unstable = certificate(2, 2);
    CHECK(unstable.modal.empty());
    CHECK(unstable.contractive.empty());
    CHECK(unstable.reflection.empty());
    CHECK(unstable.max_cfl.empty());

    const auto only_paired = certificate(1, 0);
    CHECK(only_paired.modal.size() == 1);
    CHECK(only_paired.contractive.empty());

    CHECK_THROWS_AS(nmbcgen::modal_windows(nmbcgen::derive({"nopd1d", 1, 2, 1, Rational(1) / 2})),
                    std::invalid_argument);
}

}  // namespace
