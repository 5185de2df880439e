// SPDX-License-Identifier: GPL-2.0-or-later
/// The gate between the algebra system and everything behind it. GiNaC orders terms differently
/// from run to run, so no GiNaC expression is printed, hashed or iterated into output: freeze
/// takes its coefficients out one by one, by power, into exact data.
#pragma once

#include <ginac/ginac.h>

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// A polynomial over Q in the given symbol as exact data.
/// Throws std::logic_error where expression is not such a polynomial.
Polynomial freeze(const GiNaC::ex& expression, const GiNaC::symbol& parameter);

/// The other way, at the entrance: exact data as an expression in the given symbol.
GiNaC::ex thaw(const Polynomial& polynomial, const GiNaC::symbol& parameter);

}  // namespace nmbcgen
