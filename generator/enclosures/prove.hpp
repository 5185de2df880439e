// SPDX-License-Identifier: MIT
/// What of a certificate is proved: at every G of a window and in every step up to one.
#pragma once

#include <functional>
#include <nmbc/table.hpp>
#include <optional>
#include <vector>

#include "generator/enclosures/condition.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {

/// Proofs about one condition of an undamped lattice, its G open.
class Prover {
  public:
    /// Throws std::invalid_argument as exact_condition() does.
    explicit Prover(const Table& table);

    /// Whether, at all G of the window, the half space has this grade in continuous time and in all
    /// leapfrog steps with midpoint ghosts up to this cfl; false where that is undecided.
    bool holds(const nmbc::Window& window, double cfl, Grade least) const;

    /// The same in one leapfrog step [dX/c] alone, to its roundings.
    bool holds_in_step(const nmbc::Window& window, double time_step, Grade least) const;

    /// The largest cfl, in hundredths, up to which it holds; less than 0 where it does not even in
    /// continuous time.
    double largest_cfl(const nmbc::Window& window, Grade least) const;

  private:
    std::optional<EnclosedCondition> enclosed(const nmbc::Window& window) const;

    ExactCondition per_G_;
    ExactCondition plain_;  ///< for G = 0
};

/// The parts of a window of G, ascending, in which something holds: by halves, to no less than
/// `finest`. told: the G that is reached.
std::vector<nmbc::Window> parts_where(const std::function<bool(const nmbc::Window&)>& holds,
                                      const nmbc::Window& window, double finest,
                                      const std::function<void(double)>& told);

/// One double, or its neighbours about a number that is none.
nmbc::Window window_about(const Rational& G);

/// Puts into the certificate of a table at one G what is proved of its grades and steps: of one
/// that is matched in a step that step, of others all smaller ones, up to a cfl that is up to 0.02
/// less than the sampled one where that one is not. At horizons above 3 they would take minutes and
/// are sampled. So are damped lattices.
void prove_certificate(const Table& table, Certificate& certificate);

}  // namespace nmbcgen
