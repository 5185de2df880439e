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

}  // namespace nmbcrun
