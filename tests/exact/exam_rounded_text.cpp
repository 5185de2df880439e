// SPDX-License-Identifier: GPL-2.0-or-later
/// Limits in a few digits: never beyond what they are limits of.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "generator/exact/rounded_text.hpp"

namespace {

using nmbcgen::rounded_down;
using nmbcgen::rounded_up;

TEST_CASE("a limit is rounded to its own side") {
    CHECK(rounded_down(0.12349, 3) == "0.123");
    CHECK(rounded_down(0.12399, 3) == "0.123");
    CHECK(rounded_up(0.12301, 3) == "0.124");
    CHECK(rounded_up(0.12399, 3) == "0.124");
    CHECK(rounded_down(2.0 / 3, 7) == "0.6666666");
    CHECK(rounded_up(1.0 / 3, 7) == "0.3333334");
    CHECK(rounded_down(1.99999e-7, 3) == "1.99e-07");
    CHECK(rounded_up(123456.7, 3) == "1.24e+05");
}

TEST_CASE("what the digits hold stays as it is") {
    for (const char* const text : {"0.25", "1", "100", "0.001", "1.5e-07"}) {
        CHECK(rounded_down(std::stod(text), 3) == text);
        CHECK(rounded_up(std::stod(text), 3) == text);
    }
}

TEST_CASE("beside a power of ten the last digit is that of the value") {
    CHECK(rounded_down(std::nextafter(1, 0), 3) == "0.999");
    CHECK(rounded_down(99.99, 3) == "99.9");
    CHECK(rounded_up(0.9991, 3) == "1");
    CHECK(rounded_up(std::nextafter(1, 2), 3) == "1.01");
}

TEST_CASE("values of many sizes are between their texts, which differ by one digit") {
    for (double value = 1.2345678e-9; value < 1e9; value *= 1.37) {
        CAPTURE(value);
        const double low = std::stod(rounded_down(value, 4));
        const double high = std::stod(rounded_up(value, 4));
        CHECK(low <= value);
        CHECK(high >= value);
        CHECK(high - low < 1.001e-3 * value);
    }
}

}  // namespace
