// SPDX-License-Identifier: MIT
/// How fast the sources of a scene are.
#pragma once

#include <nmbc/lattice.hpp>
#include <string>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

struct TimeScale {
    double time;       ///< [time]
    std::string name;  ///< in words
};

/// The shortest that the scene states: of drive, force, incoming and what is given on surfaces;
/// infinite where it has none of them, or only those of files.
TimeScale shortest_time_scale(const Scene& scene, const nmbc::Lattice& lattice);

}  // namespace nmbcrun
