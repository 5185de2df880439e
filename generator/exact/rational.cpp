// SPDX-License-Identifier: MIT
#include "generator/exact/rational.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace nmbcgen {
namespace {

bool all_digits(std::string_view text) {
    return !text.empty() &&
           std::ranges::all_of(text, [](char digit) { return digit >= '0' && digit <= '9'; });
}

/// Decimal digits to an integer; GMP would read a leading zero as octal.
Integer parse_digits(std::string_view digits) {
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    return Integer(std::string(digits.substr(first)));
}

std::invalid_argument refusal(std::string_view text, const char* reason) {
    return std::invalid_argument("'" + std::string(text.substr(0, 60)) + "' " + reason);
}

/// Whether it is spelt as doubles are, 1e-3.
bool has_exponent(std::string_view text) {
    const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
    std::string_view exponent = text.substr(std::min(mark + 1, text.size()));
    if (exponent.starts_with('-') || exponent.starts_with('+')) {
        exponent.remove_prefix(1);
    }
    return mark > 0 && text.find_first_not_of("0123456789.") == mark && all_digits(exponent);
}

/// form: what is allowed, as "is not a number such as 1/2".
std::invalid_argument refusal_of_form(std::string_view text, const std::string& form) {
    constexpr auto of_exponent =
        ": an exponent is not allowed; an integer, a fraction p/q and a decimal are";
    const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
    return refusal(text, (form + (has_exponent(digits) ? of_exponent : "")).c_str());
}

bool is_too_long(std::string_view text) {
    const bool has_mark = text.find_first_of("/.") != std::string_view::npos;
    return text.size() > maximum_digits + (has_mark ? 1 : 0);
}

}  // namespace

Rational parse_rational(std::string_view text) {
    const auto refuse = [&](const char* reason) { return refusal(text, reason); };
    constexpr auto form = "is not a non-negative exact number such as 2, 1/2 or 0.3";
    const std::size_t mark = text.find_first_of("/.");
    if (is_too_long(text)) {
        throw refuse("is too long: at most 40 digits are allowed");
    }
    const std::string_view left = text.substr(0, mark);
    if (!all_digits(left)) {
        throw refusal_of_form(text, form);
    }
    if (mark == std::string_view::npos) {
        return Rational(parse_digits(left));
    }
    const std::string_view right = text.substr(mark + 1);
    if (!all_digits(right)) {
        throw refusal_of_form(text, form);
    }
    if (text[mark] == '.') {
        const Integer scale = boost::multiprecision::pow(Integer(10), unsigned(right.size()));
        return Rational(parse_digits(left)) + Rational(parse_digits(right), scale);
    }
    const Integer denominator = parse_digits(right);
    if (denominator == 0) {
        throw refuse("has the denominator 0");
    }
    return Rational(parse_digits(left), denominator);
}

Rational parse_signed_rational(std::string_view text) {
    const bool is_negative = text.starts_with('-');
    const std::string_view digits = text.substr(is_negative ? 1 : 0);
    try {
        return is_negative ? -parse_rational(digits) : parse_rational(digits);
    } catch (const std::invalid_argument&) {
        if (is_too_long(digits)) {
            throw;
        }
        throw refusal_of_form(text, "is not an exact number such as 1/4, -1/3 or 0.3");
    }
}

std::string to_string(const Rational& value) {
    return value.str();
}

Integer floor(const Rational& value) {
    const Integer p = numerator(value);
    const Integer q = denominator(value);
    return p < 0 ? Integer(-((q - 1 - p) / q)) : Integer(p / q);
}

double nearest_double(const Rational& value) {
    return nearest_double(numerator(value), denominator(value));
}

double nearest_double(const Integer& signed_numerator, const Integer& denominator) {
    if (signed_numerator == 0) {
        return 0.0;
    }
    const Integer numerator = abs(signed_numerator);

    // Scale by 2^-exponent so that the quotient has 53 or 54 bits; below the normal range
    // fewer bits are kept, so that a subnormal result is rounded once, too.
    constexpr int precision = std::numeric_limits<double>::digits;
    constexpr int smallest_exponent = std::numeric_limits<double>::min_exponent - precision;
    const int magnitude = int(msb(numerator)) - int(msb(denominator));  // within 1 of log2
    int exponent = std::max(magnitude - precision, smallest_exponent);
    const auto quotient_at = [&](int scale, Integer& remainder) {
        Integer quotient;
        const Integer n = scale < 0 ? Integer(numerator << unsigned(-scale)) : numerator;
        const Integer d = scale > 0 ? Integer(denominator << unsigned(scale)) : denominator;
        divide_qr(n, d, quotient, remainder);
        remainder = 2 * remainder - d;  // sign tells below, at or above one half
        return quotient;
    };
    Integer beyond_half;
    Integer quotient = quotient_at(exponent, beyond_half);
    if (quotient != 0 && msb(quotient) >= unsigned(precision)) {
        quotient = quotient_at(++exponent, beyond_half);
    }
    if (beyond_half > 0 || (beyond_half == 0 && bit_test(quotient, 0))) {
        ++quotient;
    }
    const double result = std::ldexp(double(quotient.convert_to<std::uint64_t>()), exponent);
    if (std::isinf(result)) {
        throw std::overflow_error("a number beyond 1.8e308 has no double");
    }
    return signed_numerator < 0 ? -result : result;
}

}  // namespace nmbcgen
