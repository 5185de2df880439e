// SPDX-License-Identifier: MIT
/// Greatest common divisors of integer polynomials.
#pragma once

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// The greatest common divisor over Q of two polynomials, of which one may be 0: primitive, the
/// leading coefficient positive. By the divisors modulo 31-bit primes (Brown 1971): where one of
/// these is 1, so is it, which costs next to nothing; otherwise they are put together until what
/// they make divides both. Throws std::domain_error where both are 0.
IntegerPolynomial primitive_gcd(const IntegerPolynomial& one, const IntegerPolynomial& other);

}  // namespace nmbcgen
