// SPDX-License-Identifier: MIT
/// A lattice with a matching boundary at its left end, at one exact value of G, seen as the
/// initial boundary value problem of a half space. Units dX = c = 1.
///
/// Waves are u_j = k^j exp(s t), j counted inwards. In the interior s^2 = -omega^2(k), on the
/// ghost layers s C(k) = B(k). With y = (k-1)/(k+1) and w = y^2, |k| < 1 is Re y < 0, and all of
/// it is even or odd in y:
///     -omega^2 = L(w) / (1-w)^r,   C = E(w) / (1-y)^{Ns},   B = y O(w) / (1-y)^{Ns},
/// r the reach of the stencil, N the order and s the stride of the condition.
///
/// Where the lattice is damped, s^2 + tau sigma(k) s + omega^2(k) = 0 in the interior with
///     tau sigma = D(w) / (1-w)^r,   C = (E + y F) / (1-y)^{Ns},   B = (y O + H) / (1-y)^{Ns}.
///
/// Leapfrog steps with midpoint ghosts change one thing: s in the boundary condition becomes sigma.
/// With zeta the factor of one step, the interior has (zeta - 2 + 1/zeta)/dt^2 = -omega^2(k), and
/// the ghosts have sigma C(k) = B(k) with
///     sigma = (2/dt) (zeta-1)/(zeta+1) = i omega / sqrt(1 - omega^2 dt^2/4)
/// What grows is |zeta| > 1, which is Re sigma > 0. Damping acts on the old velocity,
/// (zeta - 2 + 1/zeta)/dt^2 = -omega^2(k) - tau sigma(k) (1 - 1/zeta)/dt.
/// The frequency omega of a wave in steps is (2/dt) sin(theta/2), zeta = exp(i theta); undamped,
/// that is omega(k).
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "generator/table/table.hpp"

namespace nmbcgen {

struct HalfSpace {
    Polynomial L;  ///< in w, exact; see above
    Polynomial E;
    Polynomial O;
    Polynomial D;  ///< 0 where nothing is damped, as are F and H
    Polynomial F;
    Polynomial H;
    std::array<IntegerPolynomial, 3> modes;  ///< mode_coefficients() (mode_polynomial.hpp)
    std::vector<double> symbol;              ///< symbol[m], m = 0 .. r, rounded
    std::vector<double> damping;             ///< damping[m], m = 0 .. r, rounded
    /// omega^2 and tau sigma as polynomials in x = cos xi, ascending; no terms: not damped.
    std::vector<double> symbol_in_cosine;
    std::vector<double> damping_in_cosine;
    std::vector<double> c;  ///< c_0 .. c_N, rounded
    std::vector<double> b;  ///< b_0 .. b_N, rounded
    int stride = 1;
    double time_step = 0;  ///< dt [dX/c] of leapfrog; 0: continuous time

    std::size_t reach() const { return symbol.size() - 1; }
    bool is_damped() const { return !D.is_zero(); }
};

/// The half space of a table at an exact G >= 0.
/// Throws std::domain_error at a pole of the coefficients.
HalfSpace make_half_space(const Table& table, const Rational& G);

/// E and O of a table whose G is open, times the common denominator of its coefficients: by
/// ascending powers of w, with coefficients in Q[G], the last one not zero; c and b likewise.
struct EvenAndOddParts {
    std::vector<Polynomial> E;
    std::vector<Polynomial> O;
    Polynomial denominator;
    std::vector<Polynomial> c;
    std::vector<Polynomial> b;
};

EvenAndOddParts even_and_odd_parts(const Table& table);

/// The same half space in steps of time_step [dX/c].
HalfSpace stepped(HalfSpace half_space, double time_step);

/// sigma [c/dX] of a wave of frequency omega; omega dt/2 < 1 is assumed.
std::complex<double> boundary_rate(const HalfSpace& half_space, double omega);

/// (1 - 1/zeta)/dt, the rate that damping sees; i omega in continuous time.
std::complex<double> damped_rate(const HalfSpace& half_space, double omega);

/// C(k) and B(k).
struct CAndB {
    std::complex<double> C;
    std::complex<double> B;
};

CAndB evaluate_condition(const HalfSpace& half_space, std::complex<double> k);

/// omega^2 at real wave number xi, and its derivative by xi.
double omega_squared(const HalfSpace& half_space, double xi);
double omega_squared_slope(const HalfSpace& half_space, double xi);

/// symbol_0 + 2 sum symbol_m cos(m xi), such as omega^2 or tau sigma.
double symbol_at(const std::vector<double>& symbol, double xi);

}  // namespace nmbcgen
