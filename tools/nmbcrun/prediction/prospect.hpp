// SPDX-License-Identifier: MIT
/// What a run will see of its own ends and its own lattice, said before it begins.
#pragma once

#include <string>
#include <vector>

#include "tools/nmbcrun/simulation/simulation.hpp"

namespace nmbcrun {

struct Prospect {
    /// How much of the energy that gets to the artificial ends comes back, in words; empty where
    /// both are physical.
    std::string ends;
    /// Whether that is known to be more than a tenth, of no less than a thousandth of all energy.
    bool sends_much_back = false;
    /// Which end sends back more than comes, of what comes; empty where none does.
    std::string objection;
    /// Sources that the lattice does not carry, and what would do.
    std::vector<std::string> warnings;
};

/// Of the waves that the sources send out (source_spectra()) those that get to an end before
/// time.end, each times what the end makes of it in these time steps by its modal analysis. Waves
/// with less than a thousandth of the energy together make no objection, and a source with less
/// than a tenth of its energy in waves slower than 0.75 c, or faster than 1.25 c, no warning.
Prospect prospect_of(const Simulation& simulation);

/// Whether the scene can be run, and its ends neither amplify nor send much back.
bool absorbs(const Scene& scene);

}  // namespace nmbcrun
