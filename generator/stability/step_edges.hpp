// SPDX-License-Identifier: MIT
/// Where the certified steps at one exact G end: the algebraic number next to the sampled edge.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "generator/stability/discrete.hpp"
#include "generator/table/algebraic.hpp"

namespace nmbcgen {

/// The (dt/2)^2 [dX^2/c^2] > 0, ascending, at which the modes or the band of an undamped half space
/// in time steps can change in kind: real roots of resultants in w of the mode polynomial, which is
/// affine in (dt/2)^2. A mode is at an extremum of the band; two modes meet; one is at w = 0 or
/// infinity, k = 1 or -1; C(k) = 0 where omega dt/2 = 1, sigma = B/C of a stiff mode passing
/// infinity; or omega dt/2 = 1 at an extremum of the band, above which the interior grows.
///
/// Where reach times the number of modes is at most 90 (n <= 2, n = 3 to order 2), also: two modes
/// have the same omega^2, as a pair of complex k has where it is real, sigma imaginary; and a mode
/// has the frequency of an extremum, beyond which another number of waves travels. Then none but
/// these begin or cease to grow.
std::vector<AlgebraicNumber> critical_steps(const HalfSpace& half_space);

/// An edge that is none of these, in cfl = dt omega_max/2: sampled between low and high, 1e-9
/// apart.
struct CflBracket {
    double low;
    double high;
};

/// The end of the steps that have a grade.
struct StepEdge {
    std::variant<AlgebraicNumber, CflBracket> where;  ///< (dt/2)^2 [dX^2/c^2], or a cfl
    double cfl = 0;                                   ///< the last one inside, rounded down
    Failure beyond = Failure::none;                   ///< none: of a lower grade
};

/// Of an undamped half space.
class StepEdges {
  public:
    explicit StepEdges(const HalfSpace& half_space);

    /// stable_range()
    StepRange range(Grade least);

    /// The upper end of the first unbroken run of steps of at least this grade; none where there
    /// are no such steps. The grade is sampled in the middle between any two critical steps below,
    /// and every 0.05 of cfl, then bisected; the edge is the critical step within 1e-6 of cfl, or
    /// one less by up to 1e-4, where what is amplified cannot be told from 1.
    std::optional<StepEdge> edge(Grade least);

  private:
    std::vector<double> middles_between(double from, double to) const;
    StepEdge described(double low, double high) const;

    HalfSpace half_space_;
    StepGrades grades_;
    double top_;  ///< omega_max [c/dX]
    std::vector<AlgebraicNumber> critical_;
};

}  // namespace nmbcgen
