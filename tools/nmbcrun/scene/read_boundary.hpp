// SPDX-License-Identifier: MIT
/// The ends of a scene, from its keys.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {

/// Fails for a key of a group that counts neither for its kind nor for the other kinds, of ends
/// that inherit the key. A file's keys may stay where an override changes one of these kinds.
void refuse_idle_keys(SceneReader& reader, const std::string& group, BoundaryKind kind,
                      const std::vector<BoundaryKind>& others);

/// The keys of `group`; those that are not there are as in `others`.
Boundary read_boundary(SceneReader& reader, const std::string& group, const Boundary& others);

/// What is given on the surface at one end.
std::optional<ForceHistory> read_value(SceneReader& reader, const std::string& path,
                                       const std::string& end, BoundaryKind kind);

}  // namespace nmbcrun
