// SPDX-License-Identifier: MIT
/// Whether a boundary mode of a damped lattice grows, at every G and every step of a box. Its waves
/// fade, |k| != 1 where Re s >= 0 and s != 0, so that modes are all by which a half space grows.
///
/// With sigma = B/C and h = dt/2, the interior (half_space.hpp) has
///     B^2 + tau sigma(k) B C + omega^2(k) C^2 - h tau sigma(k) B^2 - h^2 omega^2(k) B^2 = 0,
/// a polynomial in t = (k-1)/(k+p), in which k = -p is infinitely far away. |k| < 1 is
/// (p-1) |t|^2 + 2 Re t < 0. Of each root either |k| > 1 or Re B conj(C) < 0 is shown.
/// Long waves have |k| -> 1 and Re sigma -> 0. About them, with y = (k-1)/(k+1) = a + ib,
///     Re B conj(C) = Q(-b^2) + a Re(B' conj(C) + B conj(C')) somewhere between ib and y,
/// Q(y^2) the even part of B(y) C(-y): no mode with a < 0 grows where Q <= 0 and the slope is > 0.
#pragma once

#include <array>
#include <nmbc/table.hpp>
#include <vector>

#include "generator/enclosures/interval.hpp"
#include "generator/lattice/band.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// A condition and its lattice, at every G exactly; polynomials in t, y, w or x, ascending.
struct DampedCondition {
    /// C(k) and B(k), in other variables than k times a positive function of it.
    struct CAndB {
        InX C;
        InX B;
    };

    /// In t of one p.
    struct Chart {
        int p;
        /// By powers of h - half_step, without t^q, which all three have in common.
        std::array<InX, 3> modes;
        CAndB condition;
    };

    InX band;     ///< omega^2 in x = cos xi
    InX damping;  ///< tau sigma in x
    CAndB in_k;
    unsigned stride = 1;
    /// That the condition is matched in, whose long waves cancel exactly there; 0: in continuous
    /// time.
    Rational half_step;
    std::array<Chart, 2> charts;
    CAndB in_y;
    InX Q;  ///< Q(w) / |w|^q for w < 0, in -w
};

/// Of a table whose G is open. Throws std::invalid_argument where B(1) != 0, or C(1) = 0 at every
/// G.
DampedCondition damped_condition(const Table& table);

/// Whether, at all G of a window above 0 and for all h = dt/2 [dX/c] of an interval, the interior
/// is stable and no mode grows; false where that is undecided.
bool no_mode_grows(const DampedCondition& condition, const nmbc::Window& window,
                   const Interval& half_step);

/// omega_max^2 [c^2/dX^2] at all G of a window.
Interval highest_square(const DampedCondition& condition, const nmbc::Window& window);

}  // namespace nmbcgen
