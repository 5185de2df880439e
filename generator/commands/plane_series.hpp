// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen taylor: Taylor coefficients of waves of a plane lattice in any direction.
#pragma once

#include <optional>
#include <string>

#include "generator/commands/direction.hpp"
#include "generator/names/projected_family.hpp"

namespace nmbcgen {

struct PlaneSeriesTask {
    std::string family = "nopd2d";
    VectorChoice choice;
    Polarisation polarisation = Polarisation::P;
    unsigned order = 1;                    ///< N: a_1 to a_{2N+1}
    std::optional<Direction> direction{};  ///< none: at every angle, as polynomials of its sine
};

/// For people, or JSON (docs/reference/json-other.md). Throws NoProjection where there are no such
/// exact coefficients (plane/plane_taylor.hpp).
std::string plane_series_text(const PlaneSeriesTask& task);
std::string plane_series_json(const PlaneSeriesTask& task);

}  // namespace nmbcgen
