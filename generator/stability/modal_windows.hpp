// SPDX-License-Identifier: GPL-2.0-or-later
/// Where a matching boundary is stable on a half space and between like ends, as a set of G.
#pragma once

#include <variant>
#include <vector>

#include "generator/stability/modal.hpp"
#include "generator/stability/window.hpp"

namespace nmbcgen {

/// An edge found by bisection of the verdict: it lies between low and high, at most 1e-6 apart.
struct Bracket {
    double low;
    double high;
};

/// Where a window begins or ends. An edge at a critical value of the exact polynomials is known
/// exactly; 0 and the end of the search are exact, too, and have no failure beyond.
struct ModalEdge {
    std::variant<AlgebraicNumber, Bracket> where;
    ModalVerdict beyond;  ///< how the condition fails just outside
};

struct ModalWindow {
    ModalEdge low;
    ModalEdge high;
};

/// The windows in 0 <= G <= highest_G, ascending. Edges at exact critical values (poles, zeros of
/// E and O at the ends of the band, meetings of zeros of E or O with each other or with an
/// extremum of the band, changes of the band's structure) are recognised as such.
/// Between neighbouring critical values the verdict is sampled 24 times, so a window or a gap
/// narrower than a 24th of that, with no critical value in it, may be missed; windows narrower
/// than 0.005 are left out.
std::vector<ModalWindow> modal_windows(const Table& table, const Rational& highest_G);

/// Critical values of G > 0: those of scalar_critical_values, of the band (extrema of omega^2
/// that appear or vanish), and where a zero of E or O on the unit circle meets an extremum.
std::vector<AlgebraicNumber> modal_critical_values(const Table& table);

}  // namespace nmbcgen
