// SPDX-License-Identifier: GPL-2.0-or-later
/// Taylor coefficients of nopd1d for the tests of matching.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/matching/freeze.hpp"
#include "generator/matching/taylor.hpp"

namespace nmbcgen::test {

/// The symbol of nopd1d with the stabilisation G, a symbol or a number, for taylor_coefficients.
inline std::vector<GiNaC::ex> thawed_symbol(unsigned horizon, const GiNaC::ex& G) {
    const GiNaC::symbol parameter("G");
    std::vector<GiNaC::ex> symbol;
    for (const Polynomial& coefficient : make_model("nopd1d", horizon).symbol) {
        symbol.push_back(thaw(coefficient, parameter).subs(parameter == G));
    }
    return symbol;
}

/// a_0 .. a_highest of nopd1d, dX = c = 1.
inline std::vector<GiNaC::ex> nopd1d_taylor(unsigned horizon, const GiNaC::ex& G,
                                            unsigned highest) {
    return taylor_coefficients(thawed_symbol(horizon, G), highest);
}

/// Numbers out of the algebra system.
inline std::vector<Rational> to_rationals(const std::vector<GiNaC::ex>& numbers) {
    const GiNaC::symbol none("none");
    std::vector<Rational> result;
    result.reserve(numbers.size());
    for (const GiNaC::ex& number : numbers) {
        result.push_back(evaluate(freeze(number, none), 0));
    }
    return result;
}

}  // namespace nmbcgen::test
