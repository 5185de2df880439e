// SPDX-License-Identifier: MIT
/// Numbers of one real quadratic field.
#pragma once

#include <optional>

#include "generator/table/algebraic.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// rational + radical sqrt(radicand). The radicand is positive and no square; 0 as long as the
/// number is rational. Two numbers that meet in an operation have the same radicand, or one has 0.
struct Quadratic {
    Rational rational = 0;
    Rational radical = 0;
    Rational radicand = 0;

    Quadratic() = default;
    Quadratic(Rational value)
        : rational(std::move(value)) {}        // NOLINT(google-explicit-constructor)
    Quadratic(int value) : rational(value) {}  // NOLINT(google-explicit-constructor)
    Quadratic(Rational a, Rational b, Rational D)
        : rational(std::move(a)), radical(std::move(b)), radicand(std::move(D)) {}

    Quadratic& operator+=(const Quadratic& other);
    Quadratic& operator-=(const Quadratic& other);
    Quadratic& operator*=(const Quadratic& other);
    Quadratic& operator/=(const Quadratic& other);  ///< std::domain_error where other is 0

    friend Quadratic operator+(Quadratic left, const Quadratic& right) { return left += right; }
    friend Quadratic operator-(Quadratic left, const Quadratic& right) { return left -= right; }
    friend Quadratic operator*(Quadratic left, const Quadratic& right) { return left *= right; }
    friend Quadratic operator/(Quadratic left, const Quadratic& right) { return left /= right; }
    friend bool operator==(const Quadratic& left, const Quadratic& right) {
        return left.rational == right.rational && left.radical == right.radical;
    }
};

/// The positive root of a positive rational that is a square; nothing where it is none.
std::optional<Rational> rational_root(const Rational& square);

/// The positive root of a positive rational, in the field of sqrt(radicand), or of the square's own
/// where radicand is 0; nothing where it lies in another field.
std::optional<Quadratic> quadratic_root(const Rational& square, const Rational& radicand);

AlgebraicNumber to_algebraic_number(const Quadratic& number);

}  // namespace nmbcgen
