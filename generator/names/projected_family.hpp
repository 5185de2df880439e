// SPDX-License-Identifier: MIT
/// Names of the chains that waves along an axis see of a plane model: families of their own, such
/// as nopd2d_r4_nu1o4_P.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "generator/table/vector_model.hpp"

namespace nmbcgen {

enum class Polarisation { P, S };

struct ProjectedFamily {
    std::string family;  ///< of the plane models
    VectorChoice model{};
    Polarisation polarisation = Polarisation::P;
};

/// FAMILY_rR[_nuPoQ][_strain][_w_PoQ_PoQ ..]_P or _S; mPoQ is -P/Q.
std::string name_of(const ProjectedFamily& projected);

/// Larger families take minutes.
inline constexpr unsigned largest_radius_squared = 100;

/// What has this name; none where it is not such a name, or of a radius above the largest.
std::optional<ProjectedFamily> projected_family(std::string_view name);

/// --family FAMILY --radius2 R .., as on the command line.
std::string options_of(const ProjectedFamily& projected);

}  // namespace nmbcgen
