// SPDX-License-Identifier: MIT
#include "generator/exact/algebraic_number.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "generator/exact/polynomial_gcd.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/sturm.hpp"

namespace nmbcgen {
namespace {

/// Where the secant through the interval's ends vanishes, in units of 2^-bits of the interval from
/// its low end, to the nearest unit.
Integer nearest_to_secant(const AlgebraicNumber& number, unsigned bits) {
    const auto degree = unsigned(number.polynomial.degree());
    const Integer low =
        scaled_value(number.polynomial, number.low) * pow(denominator(number.high), degree);
    const Integer high =
        scaled_value(number.polynomial, number.high) * pow(denominator(number.low), degree);
    const Integer span = 2 * (low - high);
    return ((low << (bits + 1)) + span / 2) / span;
}

/// The rational of least denominator, and then nearest to zero, with low < it < high.
Rational simplest_between(const Rational& low, const std::optional<Rational>& high) {
    if (low < 0) {
        const bool around_zero = !high || *high > 0;
        return around_zero ? Rational(0) : Rational(-simplest_between(-*high, -low));
    }
    const Integer whole = floor(low);
    if (!high || whole + 1 < *high) {
        return whole + 1;
    }
    // No integer lies between, so that whole < it < whole + 1: the next step of the continued
    // fraction, down the Stern-Brocot tree.
    const Rational inverse_low = 1 / (*high - whole);
    const auto inverse_high = low == whole ? std::nullopt : std::optional(1 / (low - whole));
    return whole + 1 / simplest_between(inverse_low, inverse_high);
}

/// n = square^2 * radicand.
struct SquareFactor {
    Integer square = 1;
    Integer radicand = 1;
};

SquareFactor square_factor(Integer n) {
    constexpr unsigned long limit = 1000000;
    SquareFactor result;
    // Once n < p^3 without a factor below p, only a perfect square has a square factor.
    for (unsigned long p = 2; p < limit && n >= p * p * p; ++p) {
        unsigned count = 0;
        for (; integer_modulus(n, p) == 0; ++count) {
            n /= p;
        }
        result.square *= pow(Integer(p), count / 2);
        result.radicand *= pow(Integer(p), count % 2);
    }
    Integer remainder;
    const Integer root = sqrt(n, remainder);
    (remainder == 0 ? result.square : result.radicand) *= remainder == 0 ? root : n;
    return result;
}

/// The root of an irreducible quadratic: (-b +- square sqrt(radicand))/2a in lowest terms.
std::string radical_text(const AlgebraicNumber& number) {
    const auto& coefficients = number.polynomial.data();
    const Integer& a = coefficients[2];
    const Integer& b = coefficients[1];
    const auto [square, radicand] = square_factor(b * b - 4 * a * coefficients[0]);
    const Integer common = gcd(gcd(b, square), 2 * a);
    const Integer whole = -b / common;
    const Integer multiple = square / common;
    const Integer denominator = 2 * a / common;

    const bool above = std::is_gt(compare(number, Rational(-b, 2 * a)));
    const std::string root =
        (multiple == 1 ? "" : multiple.str() + "*") + "sqrt(" + radicand.str() + ")";
    if (whole == 0) {
        return (above ? "" : "-") + root + (denominator == 1 ? "" : "/" + denominator.str());
    }
    const std::string sum = whole.str() + (above ? " + " : " - ") + root;
    return denominator == 1 ? sum : "(" + sum + ")/" + denominator.str();
}

}  // namespace

AlgebraicNumber to_algebraic_number(const Rational& value) {
    return {IntegerPolynomial(std::vector<Integer>{-numerator(value), denominator(value)}), value,
            value};
}

void cut(AlgebraicNumber& number, const Rational& point) {
    if (point <= number.low || number.high <= point) {
        return;
    }
    const int sign = sign_of(number.polynomial, point);
    if (sign == 0) {
        number = to_algebraic_number(point);
    } else if (sign == sign_of(number.polynomial, number.low)) {
        number.low = point;
    } else {
        number.high = point;
    }
}

void halve(AlgebraicNumber& number) {
    cut(number, (number.low + number.high) / 2);
}

bool is_rational(const AlgebraicNumber& number) {
    return number.low == number.high;
}

void refine(AlgebraicNumber& number, const Rational& width) {
    if (width <= 0) {
        throw std::invalid_argument("refine: the width must be positive");
    }
    unsigned bits = 2;
    while (number.high - number.low > width) {
        const Rational step = (number.high - number.low) / Integer(Integer(1) << bits);
        const Rational middle = number.low + nearest_to_secant(number, bits) * step;
        cut(number, middle - step);
        cut(number, middle + step);
        if (number.high - number.low <= 2 * step) {
            bits *= 2;
        } else {
            halve(number);
            bits = std::max(bits / 2, 2U);
        }
    }
}

double nearest_double(const AlgebraicNumber& number) {
    AlgebraicNumber narrow = number;
    // First relative to the number, so that neither zero nor infinity is near if it is not.
    const Integer precision = Integer(1) << 60;
    while ((narrow.high - narrow.low) * precision > std::min(abs(narrow.low), abs(narrow.high))) {
        halve(narrow);
    }
    while (nearest_double(narrow.low) != nearest_double(narrow.high)) {
        halve(narrow);
    }
    return nearest_double(narrow.low);
}

std::strong_ordering compare(const AlgebraicNumber& left, const Rational& right) {
    AlgebraicNumber cut_there = left;
    cut(cut_there, right);
    if (is_rational(cut_there)) {
        return cut_there.low.compare(right) <=> 0;
    }
    return cut_there.high <= right ? std::strong_ordering::less : std::strong_ordering::greater;
}

std::strong_ordering compare(const AlgebraicNumber& left, const AlgebraicNumber& right) {
    const auto overlap = [](const AlgebraicNumber& a, const AlgebraicNumber& b) {
        return a.low <= b.high && b.low <= a.high;
    };
    if (overlap(left, right)) {
        const IntegerPolynomial common = primitive_gcd(left.polynomial, right.polynomial);
        const SturmChain chain(common);
        if (chain.roots_in_closed(std::max(left.low, right.low), std::min(left.high, right.high)) >
            0) {
            return std::strong_ordering::equal;
        }
    }
    AlgebraicNumber a = left;
    AlgebraicNumber b = right;
    while (overlap(a, b)) {
        halve(a);
        halve(b);
    }
    return a.high < b.low ? std::strong_ordering::less : std::strong_ordering::greater;
}

int sign_at(const Polynomial& polynomial, const AlgebraicNumber& number) {
    if (polynomial.is_zero()) {
        return 0;
    }
    const IntegerPolynomial f = primitive_square_free(polynomial);
    AlgebraicNumber narrow = number;
    if (!is_rational(number)) {
        if (changes_sign(primitive_gcd(f, number.polynomial), number)) {
            return 0;
        }
        const SturmChain chain(f);
        while (chain.roots_in_closed(narrow.low, narrow.high) > 0) {
            halve(narrow);
        }
    }
    return evaluate(polynomial, narrow.low).sign();
}

Rational rational_between(const AlgebraicNumber& one, const AlgebraicNumber& other) {
    const auto order = compare(one, other);
    if (std::is_eq(order)) {
        throw std::invalid_argument("no number lies between two equal ones");
    }
    AlgebraicNumber left = std::is_lt(order) ? one : other;
    AlgebraicNumber right = std::is_lt(order) ? other : one;
    // The simplest rational of the hull is the one wanted as soon as it lies in the gap. Simpler
    // ones before and behind leave the hull, which closes in on the two numbers.
    while (true) {
        Rational candidate = simplest_between(left.low, right.high);
        if (left.high < candidate && candidate < right.low) {
            return candidate;
        }
        halve(left);
        halve(right);
    }
}

Rational rational_above(const AlgebraicNumber& number) {
    const Integer positive_and_above = abs(floor(number.high)) + 2;
    return rational_between(number, to_algebraic_number(Rational(positive_and_above)));
}

std::string to_text(const AlgebraicNumber& number) {
    if (is_rational(number)) {
        return to_string(number.low);
    }
    return number.polynomial.degree() == 2 ? radical_text(number) : "";
}

}  // namespace nmbcgen
