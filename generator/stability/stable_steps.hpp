// SPDX-License-Identifier: MIT
/// The stable time steps over whole windows of G.
#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "generator/stability/discrete.hpp"
#include "generator/table/certificate.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

/// Of one table.
class StableSteps {
  public:
    /// critical: values of G, ascending.
    StableSteps(const Table& table, const std::vector<double>& critical);

    /// Pieces of G within the windows, ascending, each with steps that have this grade in all of
    /// it; a piece without them is left out. They are those of stable_range() at both ends, in the
    /// middle and at both sides of every critical value inside; where their largest cfl differ by
    /// more than 0.06, or their `from` by more than 0.01, for smaller pieces. For what may lie
    /// between, cfl is 0.01 less than the least of them, and `from`, where one of them has it, as
    /// much more than the largest as they differ, 0.01 at least. A window without an end is sampled
    /// to 1000 times where it begins.
    std::vector<StableStep> over(const std::vector<StabilityWindow>& windows, Grade least);

  private:
    /// stable_range() at one G.
    struct Ranges {
        StepRange paired;
        StepRange contractive;  ///< of a damped lattice not looked for
    };

    class Pieces;
    const Ranges& ranges_at(double G);

    const Table& table_;
    const std::vector<double>& critical_;
    std::map<double, Ranges> known_;  ///< by G: both grades see the same windows, mostly
    std::mutex guard_;                ///< of known_, as pieces are covered at the same time
};

}  // namespace nmbcgen
