// SPDX-License-Identifier: MIT
/// The influence omega(xi) = (|xi| + eps)^-p of Seleson 2011, smoothed at 0 by a length eps, on
/// bonds of up to delta: force gamma_p (u' - u)/|xi| omega(xi) per length of the chain squared.
#pragma once

#include <span>
#include <vector>

#include "generator/table/vector_model.hpp"

namespace nmbcgen {

/// rational + of_log ln(1 + delta/eps)
struct WithLog {
    Rational rational;
    Rational of_log;
};

struct PowerInfluence {
    unsigned power = 0;      ///< p
    Rational smoothing = 1;  ///< eps [dX], > 0
    unsigned horizon = 1;    ///< delta [dX]
};

inline constexpr unsigned largest_power = 1000;
inline constexpr unsigned largest_power_horizon = 100;
/// With a larger one the influence is constant to nine digits, whatever p is.
inline constexpr double largest_smoothing = 1e9;

/// I(p, n) = int_0^delta xi^n (xi + eps)^-p dxi, in units of eps^(n+1-p).
WithLog moment(const PowerInfluence& influence, unsigned n);

/// 2/(n+1)! I(p, n)/I(p, 1), n odd, which the continuum's Omega^2 = c^2 k^2 (1 - [3] k^2 + [5] k^4
/// - ..) has, in units of eps^(n-1).
double dispersion_coefficient(const PowerInfluence& influence, unsigned n);

/// The same of the chain of the weights below.
Rational chain_dispersion_coefficient(const PowerInfluence& influence, unsigned n);

/// w_k of bond1d, omega(k)/omega(1) for k = 1 .. delta, the last one halved: half of its cell is
/// beyond the horizon. A factor says nothing: the chain's modulus is that of the solid.
std::vector<Rational> power_weights(const PowerInfluence& influence);

/// Of bond classes of a square or cubic lattice, over those of the nearest bonds: the influence
/// omega(|R|)/|R| of lps2d and lps3d, and the weights omega(|R|)/|R|^3 of bond2d and bond3d.
/// Rounded to 10^-12. Throws NoSuchModel (family.hpp) where one is less than that.
struct ClassWeights {
    std::vector<Rational> influence;
    std::vector<Rational> springs;
};
ClassWeights class_weights(unsigned power, const Rational& smoothing,
                           std::span<const Offset> classes);

/// The modulus of the chain, over the solid's, where its force has the continuum's gamma_p.
double modulus_of_continuum_factor(const PowerInfluence& influence);

}  // namespace nmbcgen
