// SPDX-License-Identifier: MIT
/// The equations of motion of a vector model, from its energy.
#pragma once

#include <array>
#include <map>

#include "generator/table/vector_model.hpp"

namespace nmbcgen {

/// Direction by direction, polynomials in g.
using PolynomialMatrix = std::array<std::array<Polynomial, 3>, 3>;

/// Phi(R): u_tt at node I is - sum_R Phi(R) u_{I+R}. Phi(-R) is the transpose of Phi(R). Offsets
/// with Phi = 0 are left out.
using ForceConstants = std::map<Offset, PolynomialMatrix>;

/// Since u_tt = -d(energy)/du: Phi(R) = sum over squares, and over pairs of terms R apart, of
/// weight times the product of their factors. The dynamical matrix of waves exp(i (xi . x - omega
/// t)) is sum_R Phi(R) exp(i xi . R).
ForceConstants force_constants(const VectorModel& model);

}  // namespace nmbcgen
