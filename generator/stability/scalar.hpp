// SPDX-License-Identifier: MIT
/// The paper's stability bounds, exactly: where the scalar reflection coefficient
/// R = -Delta(xi)/Delta(-xi) is at most 1 in size on the whole band.
///
/// With t = tan(xi/2), w = -t^2 and the polynomials E and O of half_space.hpp, |R| <= 1 at xi is
/// omega E(w) t O(w) >= 0. At stride 1 this is E O >= 0 for all w < 0, a sign condition whose
/// truth can change, as G moves, only where a root of E or O reaches w = 0 or infinity, two roots
/// meet, or a coefficient has a pole: at real roots of polynomials in Q[G].
#pragma once

#include <vector>

#include "generator/stability/half_space.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {

/// All G >= 0 with |R| <= 1 on the whole band, ascending, disjoint, closed but for 0 and poles;
/// isolated points left out. For a stride above 1 t changes sign within the band, where the two
/// halves ask for opposite signs: no window.
/// Throws std::invalid_argument for a table at a fixed G.
std::vector<ExactWindow> scalar_windows(const Table& table);

/// Whether |R| <= 1 on the whole band at one G.
bool scalar_reflection_is_bounded(const HalfSpace& half_space);

}  // namespace nmbcgen
