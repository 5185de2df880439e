// SPDX-License-Identifier: MIT
/// nmbcrun advise: the smallest model that meets a tolerance.
#pragma once

#include "tools/nmbcrun/advise/candidates.hpp"
#include "tools/nmbcrun/advise/pause.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

struct Advice {
    std::vector<Candidate> ranked;  ///< by cost, of those within 5 % the simplest first; not empty
    std::vector<LeftOut> left_out;
};

/// What meets the tolerance, its cost measured here and now. Throws as Simulation does, NotMet
/// where nothing meets it, and what `pause` throws.
Advice advice_for(const Scene& scene, double tolerance, const Pause& pause);

/// The scene with the cheapest of them, and a line that says which.
Scene as_advised(const Scene& scene, double tolerance, bool quiet, const Pause& pause);

/// Prints the advice, ranked, and what was left out and why.
void advise(const Scene& scene, double tolerance, bool quiet, const Pause& pause);

}  // namespace nmbcrun
