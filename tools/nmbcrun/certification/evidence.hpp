// SPDX-License-Identifier: MIT
/// What it rests on that the two ends of a scene are stable together.
#pragma once

#include <nmbc/lattice.hpp>
#include <nmbc/table.hpp>
#include <string>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// In one of three words, and what it is said of, where PairOfEnds has no objection to a step
/// [dX/c]: "proved", by enclosures at the scene's own G and step (generator/enclosures/prove.hpp),
/// of like ends that they amplify nothing together, of others that each adds no energy, of a damped
/// lattice's that no mode of either grows, where the chain is not short (is_short()); "sampled",
/// also beside surface nodes; "by construction", where no end is an nmbc.
std::string evidence_of(const Scene& scene, const nmbc::Lattice& lattice,
                        const nmbc::MatchingTable& left, const nmbc::MatchingTable& right,
                        double step);

}  // namespace nmbcrun
