// SPDX-License-Identifier: MIT
/// Whether a run can go on from a checkpoint, bit for bit.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/nmbcrun/output/checkpoint.hpp"
#include "tools/nmbcrun/output/sample.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"

namespace nmbcrun {

/// A chain's run between two steps.
struct ChainRun {
    nmbc::ChainState<double> chain{};
    Ledger::Totals ledger{};
    Highlights highlights{};
};

/// To and from the state of a checkpoint. Throws FileError where that is none of a chain.
std::vector<std::vector<double>> packed(const ChainRun& run);
ChainRun chain_run_of(const Checkpoint& checkpoint, const std::filesystem::path& path);

/// All that a run with these keys and plan goes on from must have in common, the name of a key
/// each; what changes no result is left out.
std::map<std::string, std::string> identity(const Simulation& simulation);

}  // namespace nmbcrun
