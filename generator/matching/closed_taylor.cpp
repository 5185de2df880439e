// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/closed_taylor.hpp"

#include "generator/matching/freeze.hpp"
#include "generator/matching/taylor.hpp"

namespace nmbcgen {

ClosedForms closed_taylor(const ClosedForms& moments) {
    const GiNaC::symbol n("n");
    const GiNaC::symbol weight("weight");  // G / n^pole
    const std::size_t powers = 2 * moments.functions.size() + 1;
    Moments thawed{std::vector<GiNaC::ex>(powers, GiNaC::ex(0)),
                   std::vector<GiNaC::ex>(powers, GiNaC::ex(0))};
    for (std::size_t i = 0; i < moments.functions.size(); ++i) {
        const ClosedForm& function = moments.functions[i];
        for (std::size_t g = 0; g < function.size(); ++g) {
            thawed.symbol[2 * i + 2] += thaw(function[g], n) * GiNaC::pow(weight, int(g));
        }
    }
    const std::vector<GiNaC::ex> a = taylor_coefficients(thawed);
    ClosedForms taylor{.pole = moments.pole, .functions = {}};
    for (std::size_t k = 1; k < a.size(); k += 2) {
        ClosedForm form;
        for (int g = 0; g <= a[k].degree(weight); ++g) {
            form.push_back(freeze(a[k].coeff(weight, g), n));
        }
        taylor.functions.push_back(std::move(form));
    }
    return taylor;
}

}  // namespace nmbcgen
