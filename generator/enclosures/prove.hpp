// SPDX-License-Identifier: MIT
/// What of a certificate is proved: at every G of a window and in every step up to one.
#pragma once

#include <functional>
#include <nmbc/table.hpp>
#include <variant>
#include <vector>

#include "generator/enclosures/condition.hpp"
#include "generator/enclosures/damped_modes.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {

/// What of a grade is not proved first.
enum class Undecided {
    nothing,  ///< it is proved
    modes,    ///< whether a boundary mode grows
    waves,    ///< whether waves are amplified
};

struct ProvedSteps {
    double cfl = -1;  ///< the largest, in hundredths; less than 0: not even the first
    Undecided beyond = Undecided::nothing;  ///< in the next hundredth
};

/// Proofs about one condition, its G open. Of a damped lattice, whose waves fade, only
/// Grade::paired is told, and at G > 0: no boundary mode grows (damped_modes.hpp).
class Prover {
  public:
    /// Throws std::invalid_argument as exact_condition() and damped_condition() do.
    explicit Prover(const Table& table);

    /// Whether, at all G of the window, the half space has this grade in all leapfrog steps with
    /// midpoint ghosts up to this cfl, or from one on that is given, 0 being continuous time.
    Undecided undecided(const nmbc::Window& window, double cfl, Grade least, double from = 0) const;
    bool holds(const nmbc::Window& window, double cfl, Grade least, double from = 0) const {
        return undecided(window, cfl, least, from) == Undecided::nothing;
    }

    /// Whether it has in one leapfrog step [dX/c] alone, to its roundings.
    bool holds_in_step(const nmbc::Window& window, double time_step, Grade least) const;

    /// Up to where it holds from one cfl on; told: the cfl that is reached.
    ProvedSteps proved_steps(const nmbc::Window& window, Grade least, double from,
                             const std::function<void(double)>& told) const;

  private:
    struct Undamped {
        ExactCondition per_G;
        ExactCondition plain;  ///< for G = 0

        EnclosedCondition enclosed(const nmbc::Window& window) const;
    };

    std::variant<Undamped, DampedCondition> condition_;
};

/// Parts of a window of G, ascending, in which something holds, found in pieces no narrower than
/// `finest`. Not all of them: after pieces that fail, up to 1/200 of the window is left out. told:
/// the G that is reached.
std::vector<nmbc::Window> parts_where(const std::function<bool(const nmbc::Window&)>& holds,
                                      const nmbc::Window& window, double finest,
                                      const std::function<void(double)>& told);

/// One double, or its neighbours about a number that is none.
nmbc::Window window_about(const Rational& G);

/// Puts into the certificate of a table at one G what is proved of its grades and steps: of one
/// that is matched in a step that step, of others all smaller ones, up to a cfl that is up to 0.02
/// less than the sampled one where that one is not. At horizons above 6 they would take minutes and
/// are sampled.
void prove_certificate(const Table& table, Certificate& certificate);

}  // namespace nmbcgen
