// SPDX-License-Identifier: MIT
/// Runs whose steps are many or very short, or whose files are large, and those that cannot be.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/nmbcrun/scene/step_plan.hpp"

namespace nmbcrun {

/// Node-steps a second of one fast core, energies included.
inline constexpr double chain_pace = 5e8;
inline constexpr double plane_pace = 1e8;
inline constexpr double bond_pace = 3e7;

/// The steps that are left to a run.
struct StepsLeft {
    std::size_t steps;
    std::size_t nodes;
    double pace;
};

/// In words: where the steps are far below what the lattice allows, where it allows none but very
/// short ones, and where so many are left that they take more than an hour. unit_of_time: dX/c.
std::vector<std::string> warnings_of_steps(const StepPlan& plan, double unit_of_time,
                                           const StepsLeft& left);

/// Throws SceneError where they take more than 100 years.
void require_bearable_length(const StepPlan& plan, double unit_of_time, const StepsLeft& left);

/// ", about 8 min at 1e+08 node-steps a second"; empty of less than a million steps that take less
/// than a minute.
std::string length_of_run(const StepsLeft& left);

/// What a run still writes.
struct Output {
    double rows = 0;               ///< of energies
    double probes = 0;             ///< numbers beside each of them
    double snapshots = 0;          ///< fields of all nodes
    double bytes_of_snapshot = 0;  ///< as large as it gets while the run ends
    double bytes_at_end = 0;       ///< of the field at the end
};

/// In words: where that is more than 2 GB, or than is free [bytes] (infinite: not known); empty
/// where it is not.
std::string warning_of_files(const Output& output, double free);

/// Throws FileError where that cannot be written.
void require_space(const Output& output, double free);

}  // namespace nmbcrun
