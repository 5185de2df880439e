// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen recommend of a plane model: which boundary to use on a side.
#pragma once

#include "generator/commands/passive.hpp"
#include "generator/commands/recommend.hpp"

namespace nmbcgen {

/// The boundaries there are, as a text for people, first the passive side, which alone is proved to
/// add no energy: what was found of each on samples, and what they reflect against the angle. Takes
/// some seconds at radius 1 and half a minute at radius 3. Throws NoSuchBoundary where a wave
/// cannot be told from another one.
std::string side_recommendation(const SideTask& model, const Progress& progress);

}  // namespace nmbcgen
