// SPDX-License-Identifier: MIT
/// What becomes of a boundary in a long run.
#pragma once

#include <cstddef>
#include <string_view>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

enum class Fate {
    steady,   ///< neither
    drifts,   ///< displacements grow, by a power of time
    unstable  ///< it grows exponentially, or is not finite any more
};

std::string_view name_of(Fate fate);

struct Endurance {
    Fate fate = Fate::steady;
    double energy = 0;  ///< at the end over that at the start
    /// Of the largest displacement over the second half of the run: of exp(rate t) where it
    /// is unstable [1/time], of t^rate where it drifts.
    double rate = 0;
};

/// Runs the scene's chain, with its ends and in its step, for so many steps from random data.
Endurance endure(Scene scene, std::size_t steps);

}  // namespace nmbcrun
