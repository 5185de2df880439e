// SPDX-License-Identifier: GPL-2.0-or-later
/// A header for one value of G, made by nmbcgen while the tests are built, compiled in here.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nmbc/tables/nopd1d_n2_order3_G1o3.hpp>
#include <regex>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/pipeline.hpp"
#include "tests/support/read_tables.hpp"

using namespace nmbcgen;
using nmbc::generated::nopd1d_n2_order3_G1o3;
namespace data = nmbc::generated::nopd1d_n2_order3_G1o3_data;

// A table is a constant expression; its lattice is that of the committed table.
static_assert(nopd1d_n2_order3_G1o3.lattice == &nmbc::generated::nopd1d_n2);
static_assert(nopd1d_n2_order3_G1o3.order == 3);
static_assert(nopd1d_n2_order3_G1o3.lattice->horizon == 2);
static_assert(nopd1d_n2_order3_G1o3.stride == 1);
static_assert(nopd1d_n2_order3_G1o3.fixed_G == "1/3");
static_assert(nopd1d_n2_order3_G1o3.ghost_layers() == 4);
static_assert(std::size(data::rounded_c) == 4 && std::size(data::rounded_b) == 4);
static_assert(data::rounded_c[0] == 1.0 && data::rounded_c[3] == 1.0);
static_assert(data::rounded_c[1] == data::rounded_c[2]);
static_assert(data::rounded_b[0] == -data::rounded_b[3]);

namespace {

/// c_j(1/3) and b_j(1/3) from the table with G left open: not the way the header was made.
std::vector<Rational> exact_values(std::vector<ExactFunction> Table::*list) {
    const Table open =
        derive({.family = "nopd1d", .horizon = 2, .order = 3, .stride = 1, .stabilisation = {}});
    std::vector<Rational> values;
    for (const ExactFunction& function : open.*list) {
        values.push_back(evaluate(over_rationals(function.numerator), Rational(1, 3)) /
                         evaluate(over_rationals(function.denominator), Rational(1, 3)));
    }
    return values;
}

std::string header_text() {
    std::ifstream file(NMBC_FIXED_G_HEADER);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("the table proves, and is the open table at G = 1/3") {
    CHECK(test::objection(nopd1d_n2_order3_G1o3) == "");
    const Table table = test::read_table(nopd1d_n2_order3_G1o3);
    const auto c = exact_values(&Table::c);
    const auto b = exact_values(&Table::b);
    for (std::size_t j = 0; j <= 3; ++j) {
        CHECK(table.c[j] == to_rational_function(constant(c[j])));
        CHECK(table.b[j] == to_rational_function(constant(b[j])));
    }
}

TEST_CASE("the hexadecimal constants are the nearest doubles") {
    const auto c = exact_values(&Table::c);
    const auto b = exact_values(&Table::b);
    for (std::size_t j = 0; j <= 3; ++j) {
        CHECK(data::rounded_c[j] == nearest_double(c[j]));
        CHECK(data::rounded_b[j] == nearest_double(b[j]));
    }
    // By hand: c_1 = (30720 - 11136/3 - 1445/9)/(-4096 + 256/3 + 1445/9)
    //              = (276480 - 33408 - 1445)/(-36864 + 768 + 1445) = -241627/34651.
    CHECK(c[1] == Rational(-241627, 34651));
}

TEST_CASE("the 17 digits and the fraction beside them are the same number") {
    const std::string text = header_text();
    const std::regex pattern(R"(    (-?0x[0-9a-f.]+p[+-]\d+),  // (\S+) = (-?)(\d+(?:/\d+)?))");
    int lines = 0;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end;
         ++match) {
        const double hexadecimal = std::strtod((*match)[1].str().c_str(), nullptr);
        const double decimal = std::strtod((*match)[2].str().c_str(), nullptr);
        const Rational fraction = parse_rational((*match)[4].str());
        CHECK(decimal == hexadecimal);
        CHECK(nearest_double((*match)[3].length() == 0 ? fraction : Rational(-fraction)) ==
              hexadecimal);
        ++lines;
    }
    CHECK(lines == 8);
}
