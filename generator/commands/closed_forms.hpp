// SPDX-License-Identifier: GPL-2.0-or-later
/// Closed forms of a family: derived once, proved for every horizon.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "generator/families/family.hpp"
#include "generator/table/closed_forms.hpp"

namespace nmbcgen {

/// The family has none; what() says so.
struct NoClosedForms : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Derives and proves them, N = order >= 1, with the bands of horizons 1 to 5. Throws
/// NoClosedForms, and std::logic_error where the proof fails (a defect of the generator).
FamilyClosedForms closed_forms(const Family& family, unsigned order);

/// Proves from the data and the degrees that family.hpp states of the models, that these are a_1,
/// a_3, .. a_{2N+1} of the family's models at every horizon n. Returns a sentence that says how;
/// throws std::logic_error naming what fails.
///
/// At a horizon n they are, where a_1 = 1 and the coefficients of x^2 .. x^(2N+2), x = i xi, in
/// (sum a_k x^k)^2 + omega^2 vanish. Those of G^g x^(2k), times n^(pole g), are polynomials in n of
/// degree at most 2k - 2 + pole g <= (2 + pole) N: of omega^2 by family.hpp, of the square where
/// a_{2j+1} is of degree <= j in G and the coefficient of G^g, times n^(pole g), of degree
/// <= 2j + pole g in n. A polynomial of degree d with d + 1 zeros is zero, so they vanish at all
/// horizons if they do at n = 1 .. (2 + pole) N + 1, where they are computed from make_model.
std::string prove_closed_taylor(std::string_view family, const ClosedForms& taylor);

/// The function at one horizon, as a polynomial in G.
Polynomial at_horizon(const ClosedForm& function, unsigned pole, unsigned horizon);

}  // namespace nmbcgen
