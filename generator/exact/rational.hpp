// SPDX-License-Identifier: MIT
/// Rationals to and from text, and to the nearest double.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// That a text of a number may have.
inline constexpr std::size_t maximum_digits = 40;

/// Reads a non-negative exact number: "3", "1/2" or "0.3". Throws std::invalid_argument with a
/// message for people where the text is anything else or has more digits.
Rational parse_rational(std::string_view text);

/// Likewise, with or without a minus in front.
Rational parse_signed_rational(std::string_view text);

/// "p/q" in lowest terms; "p" where q = 1.
std::string to_string(const Rational& value);

/// The largest integer <= value.
Integer floor(const Rational& value);

/// The double nearest to value, ties to even; the only place where the generator rounds.
/// Throws std::overflow_error where |value| rounds to infinity.
double nearest_double(const Rational& value);

/// The double nearest to numerator/denominator, denominator > 0; they may have a common factor.
double nearest_double(const Integer& numerator, const Integer& denominator);

}  // namespace nmbcgen
