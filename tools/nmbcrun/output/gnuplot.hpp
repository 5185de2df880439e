// SPDX-License-Identifier: MIT
/// Pictures, drawn by gnuplot with the scripts of tools/plots.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// To be called before the work that draw() is to draw with this script: throws FileError where
/// there is no such script, SceneError where it could not read from the folder.
void require_drawable(const std::string& script, const std::filesystem::path& folder);

/// Runs `gnuplot -c SCRIPT ARGUMENT..`, SCRIPT from the folder share/nmbc/plots beside the
/// program's bin, and prints the files it made; or the command, where gnuplot is not installed or
/// fails. Throws FileError where there is no such script, Interrupted where the user stops it.
void draw(const std::string& script, const std::vector<std::string>& arguments,
          const std::vector<std::filesystem::path>& made);

/// How the names of a run's pictures go on.
inline constexpr std::array pictures_of_chains{"_energy.svg", "_energy.png", "_spectrum.svg",
                                               "_spectrum.png", "_spacetime.png"};
inline constexpr std::array pictures_of_planes{"_energy.svg", "_energy.png",       "_cracks.png",
                                               "_field.png",  "_field_energy.png", "_fields.png",
                                               "_fields.gif", "_fields_energy.png"};

/// The pictures of what a run of the scene has left in the folder: its energies, the spectrum of
/// its fields (output.field) and displacements over space and time (output.snapshots). Throws as
/// draw().
void draw_run(const Scene& scene, const std::filesystem::path& folder);

}  // namespace nmbcrun
