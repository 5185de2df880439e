// SPDX-License-Identifier: MIT
/// How the coefficients of bonds are chosen.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace nmbcgen {

/// The residual R is omega^2 - xi^2 of a chain; of a square lattice (36), the sum over both waves
/// of omega^2 - V^2 k^2, on the contour of the irreducible Brillouin zone. R is signed: with the
/// printed moduli (42), (43), (46), (47) cannot vanish, nor (41) at Y, where both waves have one
/// frequency.
enum class BondMethod {
    point,          ///< (40); as (41), of other places: R = 0 at equally spaced ones
    subdomain,      ///< (42), (43): the mean of R vanishes on equal parts
    galerkin,       ///< (46), (47): R is orthogonal to what each bond adds to omega^2
    least_squares,  ///< (44), (45): the least mean square, of both waves their sum
    taylor,         ///< of a chain: R is of the order 2N + 2 in xi
    bz_ls           ///< of a square lattice: the least squares of the dynamical matrix
};

/// Nothing where there is none of this name.
std::optional<BondMethod> bond_method(std::string_view name);
std::string_view bond_method_name(BondMethod method);

/// "point, subdomain, .."
std::string bond_method_names(unsigned dimension);

bool has_method(unsigned dimension, BondMethod method);
/// What it solves, in words; empty where it is none of this dimension.
std::string_view equation_of(BondMethod method, unsigned dimension);

}  // namespace nmbcgen
