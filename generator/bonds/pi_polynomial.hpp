// SPDX-License-Identifier: MIT
/// Numbers that are polynomials in pi with coefficients a + b sqrt(d): what the coefficients of
/// bonds are where they have a closed form.
#pragma once

#include <string>
#include <vector>

#include "generator/exact/real.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// rational + irrational sqrt(radicand), the radicand square-free and > 1 where irrational is not
/// 0. Numbers that meet have the same radicand, or are rational.
class Quadratic {
  public:
    // Rational numbers are such numbers, and the same equations are solved with either.
    Quadratic(Rational rational = 0)
        : rational_(std::move(rational)) {
    }  // NOLINT(google-explicit-constructor,hicpp-explicit-conversions)
    Quadratic(int rational)
        : rational_(rational) {}  // NOLINT(google-explicit-constructor,hicpp-explicit-conversions)
    /// Throws std::invalid_argument unless the radicand is square-free and above 1.
    Quadratic(Rational rational, Rational irrational, unsigned radicand);

    const Rational& rational() const { return rational_; }
    const Rational& irrational() const { return irrational_; }
    unsigned radicand() const { return radicand_; }

    Quadratic& operator+=(const Quadratic& other);
    Quadratic& operator-=(const Quadratic& other);
    Quadratic& operator*=(const Quadratic& other);
    /// Throws std::domain_error where the other is 0.
    Quadratic& operator/=(const Quadratic& other);

    friend Quadratic operator*(Quadratic left, const Quadratic& right) { return left *= right; }
    friend bool operator==(const Quadratic& left, const Quadratic& right) {
        return left.rational_ == right.rational_ && left.irrational_ == right.irrational_ &&
               left.radicand_ == right.radicand_;
    }

  private:
    /// Throws std::logic_error where both are irrational, and of different fields.
    void meet(const Quadratic& other);
    void settle();

    Rational rational_;
    Rational irrational_ = 0;
    unsigned radicand_ = 1;
};

/// sqrt(n), n > 0.
Quadratic square_root(unsigned n);

/// Its coefficients of 1, pi, pi^2, ..
using PiPolynomial = std::vector<Quadratic>;

Real value_of(const PiPolynomial& number);

/// "8/3 - 1/2*sqrt(2)*pi^2": Python reads it but for the power. "0" where all vanish.
std::string to_text(const PiPolynomial& number);

}  // namespace nmbcgen
