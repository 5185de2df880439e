// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/freeze.hpp"

#include <sstream>
#include <stdexcept>

#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

Integer freeze_integer(const GiNaC::numeric& number) {
    std::ostringstream digits;
    digits << number;  // one integer: no order to get wrong
    return Integer(digits.str());
}

}  // namespace

Polynomial freeze(const GiNaC::ex& expression, const GiNaC::symbol& parameter) {
    const GiNaC::ex expanded = expression.expand();
    if (!expanded.is_polynomial(parameter)) {
        throw std::logic_error("freeze: not a polynomial in the parameter");
    }
    std::vector<Rational> coefficients;
    for (int power = 0; power <= expanded.degree(parameter); ++power) {
        const GiNaC::ex coefficient = expanded.coeff(parameter, power);
        if (!coefficient.info(GiNaC::info_flags::rational)) {
            throw std::logic_error("freeze: a coefficient is not a rational number");
        }
        const auto& number = GiNaC::ex_to<GiNaC::numeric>(coefficient);
        coefficients.emplace_back(freeze_integer(number.numer()), freeze_integer(number.denom()));
    }
    return Polynomial(std::move(coefficients));
}

GiNaC::ex thaw(const Polynomial& polynomial, const GiNaC::symbol& parameter) {
    GiNaC::ex result = 0;
    for (std::size_t power = 0; power < polynomial.size(); ++power) {
        const GiNaC::numeric coefficient(to_string(polynomial[power]).c_str());
        result += coefficient * GiNaC::pow(parameter, int(power));
    }
    return result;
}

}  // namespace nmbcgen
