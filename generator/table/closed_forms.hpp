// SPDX-License-Identifier: MIT
/// Closed forms in the horizon n, for all horizons at once.
#pragma once

#include <string>
#include <vector>

#include "generator/table/algebraic.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// A function of n and G: sum_g p_g(n) (G / n^pole)^g, the p_g polynomials in n over Q. Ascending
/// in g, without zeros at the end; zero has none. The pole is said once for a list of them.
using ClosedForm = std::vector<Polynomial>;

/// A list of functions of n and G with the pole they have in common.
struct ClosedForms {
    unsigned pole = 0;
    std::vector<ClosedForm> functions;
};

/// The band omega^2(xi) at one horizon as a function of G. Some extrema keep their place at every
/// G, and omega^2 there is a multiple of G; the others move.
struct BandStructure {
    unsigned horizon;
    AlgebraicNumber threshold;  ///< above this G no extremum moves; below it some do
    AlgebraicNumber slope;      ///< from the threshold on, omega_max^2 = slope * G [(c/dX)^2]
    /// Below the threshold omega_max^2 is the greater of slope * G and the largest root W of this
    /// polynomial, ascending in W, its coefficients in Q[G]. Empty where some of its roots belong
    /// to no wave number, so that it does not tell.
    std::vector<Polynomial> below;
};

/// What is known of a family at all horizons, and of its band at some.
struct FamilyClosedForms {
    std::string family;
    ClosedForms taylor;  ///< a_1, a_3, .. a_{2N+1} of i omega = sum_k a_k (i xi)^k, (47)
    std::string proved;  ///< how that was proved
    std::vector<BandStructure> bands;
};

}  // namespace nmbcgen
