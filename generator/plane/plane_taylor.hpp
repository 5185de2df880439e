// SPDX-License-Identifier: MIT
/// Long waves of a plane lattice along any direction, as power series: the plane's like of (47).
#pragma once

#include <vector>

#include "generator/table/vector_model.hpp"

namespace nmbcgen {

/// s = i omega = c (x + a_3 x^3 + a_5 x^5 + ..), x = i xi, of waves along one direction.
struct PlaneTaylor {
    Rational speed_squared;     ///< c^2 in the units of the model
    std::vector<Polynomial> a;  ///< a_1 = 1, a_3, .. a_{2N+1}, polynomials in g
};

/// polarisation: 0 is P, 1 is S. The wave vector is along (cos, sin) of an angle whose cosine has
/// the given square, 0 to 1: all numbers are rational then, as the lattice's mirrors leave even
/// powers of either alone. With D the dynamical matrix, s^2 solves s^4 + tr(D) s^2 + det(D) = 0 as
/// a power series, which starts with -c^2 of the longitudinal long wave or of the other one, and
/// has no square root where c^2 is rational. Of a lattice in space the waves that move in the plane
/// of x and y.
///
/// Throws NoProjection (lattice/projection.hpp) where x -> -x is no symmetry, where c^2 is not
/// rational, vanishes, depends on g, or is that of the other wave, and where both long waves are
/// half longitudinal.
PlaneTaylor plane_taylor(const VectorModel& model, std::size_t polarisation,
                         const Rational& cosine_squared, unsigned order);

/// The same at every angle.
struct PlaneTaylorClosed {
    Rational speed_squared;
    /// [k][j]: the coefficient of q^j in a_{2k+1}, q = sin^2(2 angle).
    std::vector<std::vector<Polynomial>> a;
};

/// Where the square's symmetries leave the lattice as it is, coefficients of x^(2k) in tr(D) and
/// det(D) are polynomials in the invariants of the square, cos^2 + sin^2 = 1 and q/4 = cos^2 sin^2,
/// of degree k/2 and less in q. So a_{2k+1} is one of degree k at most, where c is the same at
/// every angle, and k + 1 values tell it. One value more is looked at.
///
/// Throws NoProjection likewise, and where c depends on the angle.
PlaneTaylorClosed plane_taylor_closed(const VectorModel& model, std::size_t polarisation,
                                      unsigned order);

}  // namespace nmbcgen
