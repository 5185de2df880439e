// SPDX-License-Identifier: MIT
/// How long a source is, and the key that makes it longer. Sources are named as their tables in the
/// scene: drive, initial, force, incoming, boundary.left.value, boundary.right.value.
#pragma once

#include <string>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// The key that makes a source longer, and where the scene has its value.
struct SourceLength {
    std::string key;
    double* value;    ///< [length], [time] or [1/time]; nullptr: a source from a file has none
    bool is_inverse;  ///< the source is the longer, the smaller the value is
    /// The middle or start of a force [time], which goes along, so that none of it is cut off at
    /// t = 0; nullptr: other sources.
    double* time = nullptr;
};

/// Of a source that the scene has.
SourceLength length_of_source(Scene& scene, const std::string& source);

/// When a source that the scene has, by keys and not by a file, is over, but for what is negligible
/// of it [time].
double end_of_source(const Scene& scene, const std::string& source);

/// The scene with no other source than this one; a preload stays.
Scene with_source_alone(Scene scene, const std::string& source);

}  // namespace nmbcrun
