// SPDX-License-Identifier: MIT
/// Linear conditions on the ghost layers beside a side of a plane lattice, the same at every point
/// of the side and on every layer.
#pragma once

#include <array>
#include <vector>

#include "generator/plane/plane_lattice.hpp"

namespace nmbcgen {

/// A polynomial in D = d/dt and the inward shift Z: [p][j] is the coefficient of D^p Z^j.
using ShiftPolynomial = std::vector<std::vector<double>>;

/// residual[a] u_a = 0 on every ghost layer, a = 0 normal to the side, a = 1 along it. Its highest
/// power of D is 1 or 2, and has a constant coefficient other than 0.
struct SideCondition {
    std::array<ShiftPolynomial, 2> residual;

    bool is_shared() const { return residual[0] == residual[1]; }
};

ShiftPolynomial product(const ShiftPolynomial& one, const ShiftPolynomial& other);

/// (D + shift)(1 + Z) - 2 speed (Z - 1): a wave of this apparent speed normal to the side,
/// c/cos(angle), has a residual of the third power of its wave number (Nicely 2018 (85): b_1 = -b_0
/// = 2 a_1/(dX cos(angle)), not the printed one). A shift > 0 keeps products of such factors from
/// drifting.
ShiftPolynomial absorbs(double speed, double shift = 0);

/// (60): sum_j (c_j D - speed b_j) Z^(stride j).
ShiftPolynomial matching_residual(const std::vector<double>& c, const std::vector<double>& b,
                                  std::size_t stride, double speed);

/// NMBC1 as printed: (81) has 2 c_P for both components.
SideCondition published_condition(const PlaneLattice& lattice);

/// NMBC1 with the speed of P for the component normal to the side, of S for the other one.
SideCondition polarisation_wise_condition(const PlaneLattice& lattice);

/// Higdon's product of two factors, for P and for S, on both components.
SideCondition higdon_condition(const PlaneLattice& lattice, double shift);

/// Ghost layers that do not move: v = 0.
SideCondition fixed_condition();

/// What it is at D = s and Z = z.
template <class Scalar>
Scalar evaluate(const ShiftPolynomial& polynomial, const Scalar& s, const Scalar& z) {
    Scalar sum = 0;
    for (std::size_t p = polynomial.size(); p-- > 0;) {
        Scalar shifts = 0;
        for (std::size_t j = polynomial[p].size(); j-- > 0;) {
            shifts = shifts * z + polynomial[p][j];
        }
        sum = sum * s + shifts;
    }
    return sum;
}

}  // namespace nmbcgen
