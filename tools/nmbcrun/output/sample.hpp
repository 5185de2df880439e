// SPDX-License-Identifier: MIT
/// What a run says of its energies at one time.
#pragma once

#include <nmbc/energy.hpp>

#include "tools/nmbcrun/simulation/ledger.hpp"

namespace nmbcrun {

struct Sample {
    double time = 0;  ///< t - dt/2, the level of the velocity
    nmbc::Energies energies;
    Balance balance;
};

/// What a run keeps of its energies for its last lines.
struct Highlights {
    double peak = 0;         ///< the largest total energy of every tenth step
    double driven_peak = 0;  ///< and of those under a source
    double drift = 0;        ///< the largest of the ledger, whatever its sign
};

}  // namespace nmbcrun
