// SPDX-License-Identifier: MIT
/// The fields of a plane scene in files that other programs open.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/posix_file.hpp"
#include "tools/nmbcrun/plane/plane_simulation.hpp"

namespace nmbcrun {

/// ".vti" or ".h5"
std::string_view extension_of(FieldFormat format);

/// displacement at t and velocity at t - dt/2 of the nodes of the body, three components, z = 0;
/// energy at t - dt/2 [per volume]; damage of a scene with fracture. VTK image data, or HDF5
/// datasets of ny x nx (x 3) in doubles. To be published. Throws FileError.
nmbcgen::NewFile new_fields(const PlaneSimulation& simulation, const std::filesystem::path& path);

/// Likewise, published.
void write_fields(const PlaneSimulation& simulation, const std::filesystem::path& path);

/// Of such a file, but for its head.
double bytes_of_fields(const PlaneSimulation& simulation);

struct Snapshot {
    double time = 0;             ///< of displacement
    std::filesystem::path file;  ///< relative to the series' folder
};

/// What opens the snapshots as one: FOLDER/NAME.pvd; or FOLDER/NAME.xdmf, and NAME.h5, whose groups
/// displacement, velocity, energy and damage have a link to the dataset of each snapshot, and times
/// in `time`. Throws FileError.
void write_series(const PlaneSimulation& simulation, const std::filesystem::path& folder,
                  const std::vector<Snapshot>& snapshots);

/// The file that a person opens: NAME.pvd or NAME.xdmf.
std::string series_name(const PlaneScene& scene);

}  // namespace nmbcrun
