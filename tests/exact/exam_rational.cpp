// SPDX-License-Identifier: GPL-2.0-or-later
/// Exact numbers from text and to text.
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include "generator/exact/rational.hpp"
#include "tests/support/contains.hpp"

using nmbcgen::Integer;
using nmbcgen::parse_rational;
using nmbcgen::Rational;
using nmbcgen::to_string;
using nmbcgen::test::contains;

namespace {

/// The message parse_rational refuses the text with; empty where it accepts it.
std::string refusal(const std::string& text) {
    try {
        parse_rational(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("parse_rational reads integers, fractions and decimals exactly") {
    CHECK(parse_rational("0") == Rational(0));
    CHECK(parse_rational("2") == Rational(2));
    CHECK(parse_rational("1/2") == Rational(1, 2));
    CHECK(parse_rational("2/4") == Rational(1, 2));
    CHECK(parse_rational("0/7") == Rational(0));
    CHECK(parse_rational("0.3") == Rational(3, 10));
    CHECK(parse_rational("0.50") == Rational(1, 2));
    CHECK(parse_rational("12.125") == Rational(97, 8));
    CHECK(parse_rational("208/85") == Rational(208, 85));
}

TEST_CASE("parse_rational reads leading zeros as decimal, not as octal") {
    CHECK(parse_rational("007/010") == Rational(7, 10));  // octal would be 7/8
    CHECK(parse_rational("00") == Rational(0));
    CHECK(parse_rational("010") == Rational(10));
    CHECK(parse_rational("0.010") == Rational(1, 100));
    CHECK(parse_rational("09.09") == Rational(909, 100));  // no octal number has a 9
}

TEST_CASE("parse_rational refuses everything else, and says what and why") {
    for (const std::string text :
         {"",      " ",     "nan",   "inf",  "-1",  "+1",    "--1", "1e400",    "1E5", "1/3/5",
          "1.2.3", "1.5/2", "1/2.5", ".5",   "5.",  ".",     "/",   "/2",       "1/",  "1/-2",
          " 1",    "1 ",    "1 /2",  "0x10", "1,5", "1_000", "1\n", "\xC2\xBD", "G"}) {
        CAPTURE(text);
        CHECK(contains(refusal(text), "'" + text + "'"));
        CHECK(contains(refusal(text), "1/2"));  // an example of what is allowed
    }
    CHECK_THROWS_AS(parse_rational(std::string("1\0", 2)), std::invalid_argument);
}

TEST_CASE("an exponent is named, with what is allowed in its place") {
    const std::string allowed =
        ": an exponent is not allowed; an integer, a fraction p/q and a decimal are";
    for (const std::string text : {"1e-3", "1E5", "2.5e+3", "1e400"}) {
        CHECK(contains(refusal(text), "'" + text + "' is not a non-negative exact number"));
        CHECK(contains(refusal(text), allowed));
    }
    for (const std::string text : {"e", "e5", "1e", "1e5.", "1.5", "nan", "1/e2", "1_0e2"}) {
        CHECK_FALSE(contains(refusal(text), allowed));
    }
    CHECK_THROWS_WITH_AS(
        nmbcgen::parse_signed_rational("-1e-3"),
        ("'-1e-3' is not an exact number such as 1/4, -1/3 or 0.3" + allowed).c_str(),
        std::invalid_argument);
}

TEST_CASE("parse_rational refuses the denominator 0") {
    for (const std::string text : {"1/0", "0/0", "3/000"}) {
        CHECK(contains(refusal(text), "denominator 0"));
    }
}

TEST_CASE("parse_rational takes 40 digits and refuses more") {
    const std::string forty(40, '7');
    // 77..7 (40 of them) = 7 (10^40 - 1)/9.
    const Integer value = 7 * ((pow(Integer(10), 40) - 1) / 9);
    CHECK(parse_rational(forty) == Rational(value));
    CHECK(parse_rational(forty.substr(0, 20) + "." + forty.substr(20)) ==
          Rational(value, pow(Integer(10), 20)));
    CHECK(parse_rational(forty.substr(0, 39) + "/7") == Rational((value - 7) / 70));
    for (const std::string& text : {forty + "7", forty + ".7", forty + "/7", "1/" + forty,
                                    std::string(50, '1'), std::string(100000, '1')}) {
        CAPTURE(text.substr(0, 60));
        CHECK(contains(refusal(text), "at most 40 digits"));
        CHECK(refusal(text).size() < 200);  // a message for people, however long the text
        CHECK_THROWS_WITH_AS(parse_signed_rational("-" + text),
                             doctest::Contains("at most 40 digits"), std::invalid_argument);
    }
}

TEST_CASE("to_string writes lowest terms, and an integer without a denominator") {
    CHECK(to_string(Rational(6, 4)) == "3/2");
    CHECK(to_string(Rational(4, 2)) == "2");
    CHECK(to_string(Rational(-2, 6)) == "-1/3");
    CHECK(to_string(Rational(0)) == "0");
    CHECK(to_string(parse_rational("0.125")) == "1/8");
    CHECK(parse_rational(to_string(parse_rational("405/98"))) == Rational(405, 98));
}
