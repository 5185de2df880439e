// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen recommend of a plane model: which boundary to use on a side.
#pragma once

#include "generator/commands/passive.hpp"
#include "generator/commands/recommend.hpp"

namespace nmbcgen {

/// The boundaries there are, the recommended one first, as a text for people: what is proved of
/// each and what was only found on samples, and what they reflect against the angle. Takes some
/// seconds at radius 1 and two minutes at radius 3.
std::string side_recommendation(const PlaneModel& model, const Progress& progress);

}  // namespace nmbcgen
