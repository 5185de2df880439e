// SPDX-License-Identifier: MIT
/// The values of G at which stability can change in kind, exactly: real roots of resultants,
/// discriminants and coefficients of E, O and omega^2 (half_space.hpp) in Q[G].
#pragma once

#include <vector>

#include "generator/stability/half_space.hpp"
#include "generator/table/algebraic.hpp"

namespace nmbcgen {

/// All positive roots of all the polynomials but those that vanish identically; ascending, each
/// once.
std::vector<AlgebraicNumber> positive_roots(std::vector<Polynomial> polynomials);

/// Every G > 0 at which the truth of E O >= 0 on w < 0 can change, ascending: a pole, a root of E
/// or O that reaches w = 0 or infinity, two roots that meet.
std::vector<AlgebraicNumber> scalar_critical_values(const EvenAndOddParts& parts);

/// Those and, ascending, every G > 0 at which the band changes its structure (an extremum of
/// omega^2 appears, vanishes or reaches xi = pi), a zero of C or B on the unit circle meets an
/// extremum, or a static evanescent wave, omega(k) = 0, becomes a boundary mode.
std::vector<AlgebraicNumber> modal_critical_values(const Table& table,
                                                   const EvenAndOddParts& parts);

/// The G >= 0 at which there is no boundary condition: coefficients have a pole there.
std::vector<AlgebraicNumber> poles(const EvenAndOddParts& parts);

/// The G >= 0, other than poles, with C(1) = 0, where a constant displacement grows like t^2.
std::vector<AlgebraicNumber> jordan_values(const EvenAndOddParts& parts);

}  // namespace nmbcgen
