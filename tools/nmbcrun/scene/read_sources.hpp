// SPDX-License-Identifier: MIT
/// Reads the tables of a scene that start and drive it.
#pragma once

#include <string>

#include "tools/nmbcrun/scene/key_group.hpp"
#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {

/// Beyond them a gaussian, ricker or packet is less than 1e-9 of its amplitude: what
/// runs on that alone was meant to be elsewhere. exp(-25) = 1.4e-11, times the 49 of a ricker.
inline constexpr double widths_of_pulse = 5;

/// The keys of a force that say how it goes in time: which history, and its own. Throws SceneError
/// where they do not fit.
History history_of(const KeyGroup& group);
ForceHistory read_history(const KeyGroup& group, History history);

/// Throws SceneError where a force whose keys are in this group acts at no time of a run to `end`,
/// but for the tail beyond widths_of_pulse.
void require_in_run(const SceneReader& reader, const std::string& group, const ForceHistory& force,
                    double end);

/// Sets the scene's sources. path: of the scene file, whose folder those of files are relative to.
/// Throws SceneError where a source is incomplete or has a key that it does not take.
void read_sources(SceneReader& reader, const std::string& path, Scene& scene);

/// Throws SceneError where there is no source at all.
void require_a_source(const std::string& path, const Scene& scene);

/// Of a scene whose horizon or G is "auto": throws SceneError where its sources or its damping are
/// not the same at any lattice, or where the wave equation's answer to them is not known.
void require_physical_sources(const SceneReader& reader, const Scene& scene);

/// Throws SceneError where a source acts on no node of the bar, or at no time of the run, but for
/// the tail beyond widths_of_pulse. What is in a layer beside the bar may come in.
void require_sources_in_run(const SceneReader& reader, const Scene& scene);

}  // namespace nmbcrun
