// SPDX-License-Identifier: MIT
/// Numbers that integrals of polynomials over x have: rationals and logarithms of rationals.
#pragma once

#include <map>
#include <string>

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// rational + sum of_log[p] ln p over primes p, no coefficient 0. It is the one such form of a
/// number: 1 and the logarithms of primes are linearly independent over the rationals.
struct LogNumber {
    Rational rational = 0;
    std::map<unsigned, Rational> of_log{};

    LogNumber& operator+=(const LogNumber& other);
    friend bool operator==(const LogNumber& left, const LogNumber& right) = default;
};

LogNumber operator*(const Rational& factor, const LogNumber& number);

/// ln of a positive number without a prime factor above a million. Throws std::invalid_argument for
/// any other.
LogNumber log_of(const Rational& number);

/// "11/9 + (-2/3) ln(2)"; of the parts only those that are not 0.
std::string to_string(const LogNumber& number);

/// To the nearest double or its neighbour; what cancels leaves 16 digits of 120.
double nearest_double(const LogNumber& number);

}  // namespace nmbcgen
