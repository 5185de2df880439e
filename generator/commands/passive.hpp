// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen passive: a side of a plane lattice, or an end of a chain, that is stable by
/// construction.
#pragma once

#include <optional>
#include <string>

#include "generator/passive/chain_end.hpp"
#include "generator/passive/plane_side.hpp"

namespace nmbcgen {

/// wave_at(); none where the wave cannot be told from others.
std::optional<ArrivingWave> told_wave(const PlaneLattice& lattice, bool is_P, double xi,
                                      double degrees);

/// passive_side(). Throws NoSuchBoundary where no design is found.
DesignedSide designed(const SideTask& model, const DesignProgress& progress = {});

/// A chain nopd1d at one G, or chain1d, the atoms, whose end has a closed form: horizon 1, G = 0,
/// time_step 0.
struct ChainModel {
    std::string family = "nopd1d";
    unsigned horizon = 1;
    Rational G;
    Rational time_step;  ///< of the steps it is for [dX/c]; 0: continuous time
};

/// Throws NoSuchBoundary where no design is found. In closed form an end has no `design`.
DesignedSide passive_end(const ChainModel& model);

/// As a C++ header: an nmbc::PassiveEnd, an nmbc::PassiveSide.
std::string passive_header(const ChainModel& model);
std::string passive_header(const SideTask& model, const DesignProgress& progress);

/// Designs as JSON (docs/reference/json-other.md): all of it exact, and what they reflect.
std::string passive_json(const SideTask& model, const DesignProgress& progress);
std::string passive_json(const ChainModel& model);

}  // namespace nmbcgen
