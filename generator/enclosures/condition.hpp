// SPDX-License-Identifier: MIT
/// A matching condition of an undamped lattice as polynomials in x = (k + 1/k)/2, cos xi on the
/// unit circle: at every G exactly, and over an interval of G enclosed.
///
/// With k = (1+y)/(1-y), w = y^2 = (x-1)/(x+1) and the parts E and O of half_space.hpp,
///     C(k) = k^{Ns/2} C~,  B(k) = k^{Ns/2} B~,  C~^2 = 2^{-Ns} square_of_C,
///     B~^2 = -2^{-Ns} square_of_B,  C~ B~ = y (1+x) 2^{-Ns} product.
/// What a boundary mode obeys, sigma^2 C^2 = B^2 with sigma^2 = -omega^2/(1 - omega^2 dt^2/4), is
///     omega^2 square_of_C - square_of_B + (dt/2)^2 omega^2 square_of_B = 0,
/// which long waves obey twice at x = 1 at least: modes and modes_in_steps are without (1-x)^2.
#pragma once

#include <optional>

#include "generator/enclosures/interval.hpp"
#include "generator/lattice/band.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// What tells boundary modes, in one of two variables, of which no k is infinitely far away in
/// both: w, or v = 1/(x-3).
template <class InVariable>
struct ModePolynomials {
    InVariable modes;
    InVariable modes_in_steps;
    InVariable E;
    InVariable O;
};

/// Up to a positive function of G and one of x, |w| or |v|; in x but for the last two. Frequencies
/// omega^2 and steps are counted per G, band = omega^2/G and tau = G (dt/2)^2, wherever G > 0: from
/// some G on omega_max^2 is proportional to it, and so are the edges of the band.
template <class InVariable, class Number>
struct Condition {
    Number scale;     ///< G, or 1
    InVariable band;  ///< in 1/G, or in G
    InVariable product;
    InVariable square_of_C;
    InVariable square_of_B;
    InVariable E;  ///< E(w) and O(w) times (1+x)^{Ns/2}, Ns/2 floored
    InVariable O;
    InVariable C;  ///< c_0 .. c_N
    InVariable B;  ///< b_0 .. b_N
    unsigned stride = 1;
    ModePolynomials<InVariable> in_w;
    ModePolynomials<InVariable> in_v;
};

/// The band is omega^2 itself here.
using ExactCondition = Condition<InX, Polynomial>;

/// Throws std::invalid_argument where the lattice is damped, omega^2 is not affine in G, long waves
/// are not matched, or the degrees of E and O are others than those of a condition in general.
/// scale: G, or 1.
ExactCondition exact_condition(const Table& table, const Polynomial& scale);

/// At all G between low and high, where scale > 0.
using EnclosedCondition = Condition<Expansion, Interval>;

EnclosedCondition enclose(const ExactCondition& condition, double low, double high);

/// Whether Re B/C < 0 for all |k| up to this: near k = 0 it is about b_0/c_0.
bool rate_is_below_0(const EnclosedPolynomial& c, const EnclosedPolynomial& b, unsigned stride,
                     const Interval& modulus_of_k);

}  // namespace nmbcgen
