// SPDX-License-Identifier: MIT
/// Long-time stability: what becomes of a boundary in a long run.
#pragma once

#include <cstddef>
#include <nmbc/chain.hpp>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/chart/trial.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

enum class LongRun {
    steady,    ///< none of these
    drifts,    ///< displacements grow, by a power of time
    unstable,  ///< it grows exponentially
    grows      ///< one or the other: too little to tell
};

std::string_view name_of(LongRun outcome);

struct LongTimeStability {
    LongRun outcome = LongRun::steady;
    /// Of the largest displacement over the second half of the run: of t^rate where it
    /// drifts, of exp(rate t) where it is unstable or grows [1/time].
    double rate = 0;
};

/// What the largest displacements show, at equal distances of time from 0 to `time`.
LongTimeStability stability_shown_by(const std::vector<double>& largest, double time);

/// Steps between two of them.
inline constexpr std::size_t steps_between_looks = 20;

/// |u| of any node; infinite where one is not finite.
[[nodiscard]] double largest_displacement(const nmbc::Chain& chain);

/// Runs the scene's chain, with its ends and in its step, for so many steps from random data. The
/// run ends early where it has grown, or faded, beyond all doubt: the rest counts as done then.
LongTimeStability long_time_stability(const Scene& scene, std::size_t steps,
                                      const Advance& advance);

}  // namespace nmbcrun
