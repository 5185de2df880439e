// SPDX-License-Identifier: GPL-2.0-or-later
/// Rounding to double, against its definition in exact arithmetic and against CLN.
#include <cln/cln.h>
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>

#include "generator/exact/rational.hpp"

using nmbcgen::Integer;
using nmbcgen::nearest_double;
using nmbcgen::Rational;

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double infinity = std::numeric_limits<double>::infinity();

Rational power_of_two(int exponent) {
    const Rational power(Integer(1) << unsigned(std::abs(exponent)));
    return exponent < 0 ? Rational(1 / power) : power;
}

/// A finite double as the rational it is; infinity as 2^1024, where the next double would be.
Rational exactly(double value) {
    if (std::isinf(value)) {
        return std::copysign(1.0, value) * power_of_two(1024);
    }
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return Rational(std::int64_t(std::ldexp(fraction, 53))) * power_of_two(exponent - 53);
}

bool even(double value) {
    return (std::bit_cast<std::uint64_t>(value) & 1U) == 0;  // the last bit of the significand
}

/// The definition: no neighbour is nearer, and at equal distance the rounded one is even.
bool is_nearest(const Rational& exact, double rounded) {
    const Rational distance = abs(exact - exactly(rounded));
    const auto is_nearer = [&](double neighbour) {
        const Rational other = abs(exact - exactly(neighbour));
        return other < distance || (other == distance && !even(rounded));
    };
    return !is_nearer(std::nextafter(rounded, -infinity)) &&
           !is_nearer(std::nextafter(rounded, infinity));
}

/// CLN's rounding: the second way, where the result is normal. (CLN flushes subnormals to zero.)
double rounded_by_cln(const Rational& exact) {
    return cln::double_approx(cln::cl_RA(exact.str().c_str()));
}

Integer random_integer(std::mt19937_64& random, int words) {
    Integer value = 0;
    for (int i = 0; i < words; ++i) {
        value = (value << 64) + Integer(std::uint64_t(random()));
    }
    return value + 1;
}

}  // namespace

TEST_CASE("the definition of nearest tells right from wrong") {
    // 1/3 lies between 0x1.5555555555555p-2 and the next double, nearer to the first.
    CHECK(is_nearest(Rational(1, 3), 0x1.5555555555555p-2));
    CHECK_FALSE(is_nearest(Rational(1, 3), 0x1.5555555555556p-2));
    CHECK_FALSE(is_nearest(Rational(1, 3), 0x1.5555555555554p-2));
    // 1 + 2^-53 is half-way between 1 (even) and 1 + 2^-52 (odd).
    CHECK(is_nearest(1 + power_of_two(-53), 1.0));
    CHECK_FALSE(is_nearest(1 + power_of_two(-53), 0x1.0000000000001p0));
}

TEST_CASE("simple values and ties") {
    CHECK(nearest_double(0) == 0.0);
    CHECK(nearest_double(-3) == -3.0);
    CHECK(nearest_double(Rational(1, 10)) == 0.1);  // the compiler rounds decimals correctly
    CHECK(nearest_double(Rational(1, 3)) == 0x1.5555555555555p-2);
    CHECK(nearest_double(1 + power_of_two(-53)) == 1.0);
    CHECK(nearest_double(1 + 3 * power_of_two(-53)) == 0x1.0000000000002p0);
    CHECK(nearest_double(1 + power_of_two(-53) + power_of_two(-300)) == 0x1.0000000000001p0);
    CHECK(nearest_double(2 - power_of_two(-53)) == 2.0);  // carries into the next binade
    CHECK(nearest_double(-1 - power_of_two(-53)) == -1.0);
}

TEST_CASE("subnormal results are rounded once") {
    constexpr double tiny = std::numeric_limits<double>::denorm_min();  // 2^-1074
    CHECK(nearest_double(power_of_two(-1074)) == tiny);
    CHECK(nearest_double(power_of_two(-1075)) == 0.0);  // tie between 0 and tiny
    CHECK(nearest_double(power_of_two(-1075) + power_of_two(-2000)) == tiny);
    CHECK(nearest_double(power_of_two(-3000)) == 0.0);
    CHECK(nearest_double(3 * power_of_two(-1075)) == 2 * tiny);  // tie between tiny and 2 tiny
    // Half-way between the largest subnormal (odd) and the smallest normal number.
    CHECK(nearest_double(power_of_two(-1022) - power_of_two(-1075)) ==
          std::numeric_limits<double>::min());
    // 3/2 - 2^-60 units of 2^-1074: rounded to 53 bits first it would become 3/2 units, a tie, and
    // then 2 units.
    const Rational twice = (Rational(3, 2) - power_of_two(-60)) * power_of_two(-1074);
    CHECK(nearest_double(twice) == tiny);
}

TEST_CASE("overflow is an error, not infinity") {
    // The last double is 2^1024 - 2^971; from half a gap above it on, nearest is 2^1024.
    const Rational half_gap = power_of_two(1024) - power_of_two(970);
    CHECK(nearest_double(half_gap - power_of_two(-100)) == largest);
    CHECK(nearest_double(-half_gap + 1) == -largest);
    CHECK_THROWS_AS(nearest_double(half_gap), std::overflow_error);
    CHECK_THROWS_AS(nearest_double(-half_gap), std::overflow_error);
    CHECK_THROWS_AS(nearest_double(power_of_two(5000)), std::overflow_error);
}

TEST_CASE("random rationals of up to 384 bits") {
    std::mt19937_64 random(20180417);
    for (int i = 0; i < 20000; ++i) {
        const Rational value(random_integer(random, 1 + int(random() % 6)) * (i % 2 == 0 ? 1 : -1),
                             random_integer(random, 1 + int(random() % 6)));
        const double rounded = nearest_double(value);
        CAPTURE(value.str());
        REQUIRE(is_nearest(value, rounded));
        REQUIRE(rounded == rounded_by_cln(value));
        REQUIRE(rounded == nearest_double(6 * numerator(value), 6 * denominator(value)));
    }
}

TEST_CASE("random rationals over the whole range of exponents, subnormals included") {
    std::mt19937_64 random(20180427);
    std::uniform_int_distribution<int> exponent(-1150, 950);
    int subnormal = 0;
    for (int i = 0; i < 20000; ++i) {
        // About 200 bits; the quotient lies within 2^-64 .. 2^64 of 1.
        const Rational value = Rational(random_integer(random, 3), random_integer(random, 3)) *
                               power_of_two(exponent(random));
        const double rounded = nearest_double(value);
        CAPTURE(value.str());
        REQUIRE(is_nearest(value, rounded));
        subnormal += int(std::fpclassify(rounded) == FP_SUBNORMAL);
    }
    CHECK(subnormal > 100);  // 52 of 2100 exponents: some 500 expected
}

TEST_CASE("half-way cases, and their nearest neighbours") {
    std::mt19937_64 random(20260101);
    std::uniform_int_distribution<int> exponent(-1074, 970);
    for (int i = 0; i < 5000; ++i) {
        const Integer odd = 2 * (random_integer(random, 1) >> 11) + 1;  // up to 54 bits
        const Rational half_way = Rational(odd) * power_of_two(exponent(random) - 1);
        const Rational nothing = half_way * power_of_two(-400);
        for (const Rational& value :
             {half_way, Rational(half_way - nothing), Rational(half_way + nothing)}) {
            CAPTURE(value.str());
            REQUIRE(is_nearest(value, nearest_double(value)));
        }
    }
}
