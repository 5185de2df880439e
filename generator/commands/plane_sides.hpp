// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen recommend of a plane model: which boundary to use on a side.
#pragma once

#include <string>
#include <vector>

#include "generator/commands/passive.hpp"
#include "generator/commands/recommend.hpp"
#include "generator/names/projected_family.hpp"

namespace nmbcgen {

/// A long wave that a condition of one's own absorbs exactly.
struct AbsorbedWave {
    Polarisation polarisation = Polarisation::P;
    double degrees = 0;  ///< from the normal of the side, 0 <= degrees < 90

    friend bool operator==(const AbsorbedWave&, const AbsorbedWave&) = default;
};

/// The boundaries there are, as a text for people, first the passive side of a family that has them
/// designed, which alone is proved to add no energy: what was found of each on samples, and what
/// they reflect against the angle. Takes some seconds at radius 1 and half a minute at radius 3.
/// Throws NoSuchBoundary where a wave cannot be told from another one. absorbed: one or two waves,
/// and there is a row more, NMBC1 matched at this angle, or the product of both.
std::string side_recommendation(const SideTask& model, const std::vector<AbsorbedWave>& absorbed,
                                const Progress& progress);

/// CSV, what each of these boundaries sends back of a wave's energy, in any polarisation:
/// `boundary`, without commas; `wave` P or S; its wave number `xi` [1/dX] of 0.1, 0.5 and 1;
/// `degrees` from the normal, 0 to 89. Likewise.
std::string side_reflection_csv(const SideTask& model, const std::vector<AbsorbedWave>& absorbed,
                                const Progress& progress);

}  // namespace nmbcgen
