// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/closed_forms.hpp"

#include <fmt/format.h>

#include "generator/exact/rational_function.hpp"
#include "generator/lattice/band_structure.hpp"
#include "generator/matching/closed_taylor.hpp"
#include "generator/matching/proof.hpp"

namespace nmbcgen {
namespace {

constexpr unsigned highest_band_horizon = 5;  // the polynomials get long

void require_identity(bool holds, const std::string& statement) {
    if (!holds) {
        throw std::logic_error("not proved: " + statement);
    }
}

/// That the degrees are those the number of horizons is reckoned from.
void require_degrees(const ClosedForms& taylor) {
    for (std::size_t j = 0; j < taylor.functions.size(); ++j) {
        const ClosedForm& function = taylor.functions[j];
        require_identity(function.size() <= j + 1,
                         fmt::format("a_{} is of degree {} in G at most", 2 * j + 1, j));
        for (std::size_t g = 0; g < function.size(); ++g) {
            const std::size_t highest = 2 * j + taylor.pole * g;
            require_identity(
                function[g].size() <= highest + 1,
                fmt::format("G^{} in a_{} is of degree {} in n at most", g, 2 * j + 1, highest));
        }
    }
}

}  // namespace

Polynomial at_horizon(const ClosedForm& function, unsigned pole, unsigned horizon) {
    const Rational weight(Integer(1), pow(Integer(horizon), pole));
    std::vector<Rational> coefficients;
    Rational power = 1;
    for (const Polynomial& coefficient : function) {
        coefficients.push_back(evaluate(coefficient, horizon) * power);
        power *= weight;
    }
    return Polynomial(std::move(coefficients));
}

std::string prove_closed_taylor(std::string_view family, const ClosedForms& taylor) {
    require_identity(taylor.functions.size() >= 2, "there are a_1 and a_3 at least");
    require_degrees(taylor);
    const std::size_t order = taylor.functions.size() - 1;
    const unsigned horizons = (2 + taylor.pole) * unsigned(order) + 1;
    Table table;
    for (unsigned n = 1; n <= horizons; ++n) {
        table.model = make_model(family, n);
        table.taylor.assign(2 * order + 1, Polynomial());
        for (std::size_t j = 0; j <= order; ++j) {
            table.taylor[2 * j] = at_horizon(taylor.functions[j], taylor.pole, n);
        }
        prove_taylor(table);
    }
    return fmt::format(
        "(sum a_k x^k)^2 + omega^2 = 0, x = i xi, through x^{} for the models of horizons n = 1 .. "
        "{}, identically in G. The coefficients of G^g, times n^({} g), are polynomials in n of "
        "degree at most {}: {} zeros prove them zero at every n",
        2 * order + 2, horizons, taylor.pole, horizons - 1, horizons);
}

FamilyClosedForms closed_forms(const Family& family, unsigned order) {
    if (family.moments == nullptr) {
        throw NoClosedForms(
            fmt::format("no closed forms in the horizon are known of family '{}'", family.name));
    }
    FamilyClosedForms result{
        std::string(family.name), closed_taylor(family.moments(order + 1)), {}, {}};
    result.proved = prove_closed_taylor(family.name, result.taylor);
    for (unsigned horizon = 1; horizon <= highest_band_horizon; ++horizon) {
        result.bands.push_back(band_structure(make_model(family.name, horizon), horizon));
    }
    return result;
}

}  // namespace nmbcgen
