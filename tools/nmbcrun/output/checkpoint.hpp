// SPDX-License-Identifier: MIT
/// A run in a file: all that it goes on from, bit for bit.
#pragma once

#include <filesystem>
#include <map>
#include <nmbc/chain.hpp>
#include <string>
#include <vector>

#include "tools/nmbcrun/output/journal.hpp"
#include "tools/nmbcrun/simulation/ledger.hpp"

namespace nmbcrun {

/// What a run keeps of its energies for its last lines.
struct Highlights {
    double peak = 0;         ///< the largest total energy of every tenth step
    double driven_peak = 0;  ///< and of those under a source
    double drift = 0;        ///< the largest of the ledger, whatever its sign
};

struct Checkpoint {
    std::map<std::string, std::string> scene{};  ///< what must be the same when the run goes on
    nmbc::ChainState<double> chain{};
    Ledger::Totals ledger{};
    Highlights highlights{};
    std::vector<Journal::Mark> journals{};
};

/// Puts it in the place of an older one, which is there until the new one is on the disk. Throws
/// FileError.
void save_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Throws FileError where there is none, or none that is whole.
Checkpoint load_checkpoint(const std::filesystem::path& path);

}  // namespace nmbcrun
