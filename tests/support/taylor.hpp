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

/// The dispersion relation of nopd1d with stabilisation G and damping tau, symbols or numbers.
inline Dispersion nopd1d_dispersion(unsigned horizon, const GiNaC::ex& G,
                                    const GiNaC::ex& tau = 0) {
    const GiNaC::symbol parameter("G");
    const Model model = make_model("nopd1d", horizon, 1);
    Dispersion result;
    for (const Polynomial& coefficient : model.symbol) {
        result.symbol.push_back(thaw(coefficient, parameter).subs(parameter == G));
    }
    for (const Rational& coefficient : model.damping) {
        result.damping.push_back(tau * thaw(constant(coefficient), parameter));
    }
    return result;
}

/// a_0 .. a_highest of nopd1d, dX = c = 1.
inline std::vector<GiNaC::ex> nopd1d_taylor(unsigned horizon, const GiNaC::ex& G, unsigned highest,
                                            const GiNaC::ex& tau = 0) {
    return taylor_coefficients(nopd1d_dispersion(horizon, G, tau), highest);
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
