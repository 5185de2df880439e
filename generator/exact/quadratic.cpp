// SPDX-License-Identifier: MIT
#include "generator/exact/quadratic.hpp"

#include <stdexcept>
#include <vector>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/real_roots.hpp"

namespace nmbcgen {
namespace {

void adopt_field(Quadratic& number, const Quadratic& other) {
    if (number.radicand == 0) {
        number.radicand = other.radicand;
    } else if (other.radicand != 0 && other.radicand != number.radicand) {
        throw std::logic_error("numbers of two quadratic fields");
    }
}

}  // namespace

Quadratic& Quadratic::operator+=(const Quadratic& other) {
    adopt_field(*this, other);
    rational += other.rational;
    radical += other.radical;
    return *this;
}

Quadratic& Quadratic::operator-=(const Quadratic& other) {
    adopt_field(*this, other);
    rational -= other.rational;
    radical -= other.radical;
    return *this;
}

Quadratic& Quadratic::operator*=(const Quadratic& other) {
    adopt_field(*this, other);
    const Rational product =
        rational * other.rational + radical * other.radical * Rational(radicand);
    radical = rational * other.radical + radical * other.rational;
    rational = product;
    return *this;
}

Quadratic& Quadratic::operator/=(const Quadratic& other) {
    const Rational norm =
        other.rational * other.rational - other.radical * other.radical * other.radicand;
    if (norm == 0) {
        throw std::domain_error("division by zero");
    }
    const Quadratic inverse(other.rational / norm, -other.radical / norm, other.radicand);
    return *this *= inverse;
}

std::optional<Rational> rational_root(const Rational& square) {
    const Integer p = sqrt(numerator(square));
    const Integer q = sqrt(denominator(square));
    Rational root(p, q);
    if (root * root != square) {
        return std::nullopt;
    }
    return root;
}

std::optional<Quadratic> quadratic_root(const Rational& square, const Rational& radicand) {
    if (const auto root = rational_root(square)) {
        return Quadratic(*root);
    }
    if (radicand == 0) {
        return Quadratic(0, 1, square);
    }
    if (const auto ratio = rational_root(square / radicand)) {
        return Quadratic(0, *ratio, radicand);
    }
    return std::nullopt;
}

AlgebraicNumber to_algebraic_number(const Quadratic& number) {
    if (number.radical == 0) {
        return to_algebraic_number(number.rational);
    }
    const Rational square = number.radical * number.radical * number.radicand;
    const Polynomial both(
        std::vector<Rational>{number.rational * number.rational - square, -2 * number.rational, 1});
    // (x - a)^2 = square < (1 + square)^2
    const std::vector<AlgebraicNumber> roots =
        real_roots(both, number.rational - 1 - square, number.rational + 1 + square);
    return number.radical > 0 ? roots.back() : roots.front();
}

}  // namespace nmbcgen
