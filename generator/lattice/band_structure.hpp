// SPDX-License-Identifier: MIT
/// Where the extrema of a band are, exactly.
#pragma once

#include "generator/table/closed_forms.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// Of an undamped model whose G is open. With omega^2 = w_0(x) + G w_1(x), x = cos xi, the extrema
/// that do not move are the common zeros F of w_0' and w_1', and xi = 0 and pi; the others are the
/// zeros of H = (w_0' + G w_1')/F. H changes the number of its zeros in -1 < x < 1 only where its
/// discriminant vanishes or one reaches an end: at roots in G of polynomials, between which
/// Sturm's theorem counts at one G.
///
/// Throws std::domain_error for a model of another kind: where a part is missing, the zeros of F
/// are not all simple, in the band and zeros of w_0, or some extrema move at every large G.
BandStructure band_structure(const Model& model, unsigned horizon);

}  // namespace nmbcgen
