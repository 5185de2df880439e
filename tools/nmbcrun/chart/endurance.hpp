// SPDX-License-Identifier: MIT
/// What becomes of a boundary in a long run.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

enum class Fate {
    steady,    ///< none of these
    drifts,    ///< displacements grow, by a power of time
    unstable,  ///< it grows exponentially
    grows      ///< one or the other: too little to tell
};

std::string_view name_of(Fate fate);

struct Endurance {
    Fate fate = Fate::steady;
    /// Of the largest displacement over the second half of the run: of t^rate where it
    /// drifts, of exp(rate t) where it is unstable or grows [1/time].
    double rate = 0;
};

/// What the largest displacements show, at equal distances of time from 0 to `time`.
Endurance fate_of(const std::vector<double>& largest, double time);

/// Runs each scene's chain, with its ends and in its step, for so many steps from random data, one
/// with an exact end for those of the scene's own run. A run ends early where it has grown, or
/// faded, beyond all doubt. On all cores; after_each is called after each run, by one thread at a
/// time. Throws Interrupted.
std::vector<Endurance> endure(const std::vector<Scene>& scenes, std::size_t steps,
                              const std::function<void()>& after_each);

}  // namespace nmbcrun
