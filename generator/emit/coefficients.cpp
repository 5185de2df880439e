// SPDX-License-Identifier: MIT
#include "generator/emit/coefficients.hpp"

#include "generator/exact/rational_function.hpp"
#include "generator/lattice/symbol.hpp"

namespace nmbcgen {

CoefficientList c_list(const Table& table) {
    return {"c", 0, table.c, table.digits};
}

CoefficientList b_list(const Table& table) {
    return {"b", 0, table.b, table.digits};
}

std::vector<CoefficientList> coefficient_lists(const Table& table) {
    CoefficientList symbol{"symbol", 0, {}};
    for (const Polynomial& coefficient : symbol_of(table)) {
        symbol.functions.push_back(to_rational_function(coefficient));
    }
    CoefficientList damping{"damping", 0, {}};
    for (const Rational& coefficient : table.model.damping) {
        damping.functions.push_back(to_rational_function(constant(coefficient)));
    }
    CoefficientList taylor{"taylor", 1, {}};
    for (const Polynomial& coefficient : table.taylor) {
        taylor.functions.push_back(to_rational_function(coefficient));
    }
    return {std::move(symbol), std::move(damping), std::move(taylor), c_list(table), b_list(table)};
}

std::vector<std::string> texts_of(const IntegerPolynomial& polynomial) {
    std::vector<std::string> texts;
    for (const Integer& coefficient : polynomial.data()) {
        texts.push_back(coefficient.str());
    }
    return texts.empty() ? std::vector<std::string>{"0"} : texts;
}

}  // namespace nmbcgen
