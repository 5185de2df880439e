// SPDX-License-Identifier: GPL-2.0-or-later
/// Small plane scenes that start from a packet or a file, and how they differ.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>

#include "tools/nmbcrun/plane/plane_simulation.hpp"

namespace nmbcrun::test {

inline std::filesystem::path file_named(const char* name) {
    return std::filesystem::temp_directory_path() / name;
}

/// No unit is 1 by chance.
inline const std::string of_lattice = R"([material]
density = 3
youngs_modulus = 12
[domain]
nodes = [24, 18]
spacing = 0.5
[time]
end = 100
cfl = 0.3
[output]
format = "hdf5"
)";
inline const std::string nopd2d_of_2 =
    "model = { family = 'nopd2d', radius2 = 4, nu = 0.3, G = 0.5 }\n";
inline const std::string packet =
    "[initial]\nshape = 'packet'\namplitude = 0.01\ncentre = [5.2, 4.1]\nwidth = 2\n"
    "wave_number = 0.7\nangle = 25\npolarisation = 'S'\n";
inline const std::string free_sides = "[boundary]\nkind = 'free'\n";

inline PlaneScene plane_scene_of(const std::string& text, const Overrides& overrides = {}) {
    return read_plane_scene(text, file_named("exam.toml").string(), overrides);
}

/// The scene that starts from the file.
inline PlaneScene started_from(const std::string& text, const std::filesystem::path& file,
                               const std::string& more = "") {
    const bool is_csv = file.extension() == ".csv";
    return plane_scene_of(text + fmt::format("[initial]\nshape = '{}'\nfile = '{}'\n{}",
                                             is_csv ? "csv" : "hdf5", file.filename().string(),
                                             more));
}

/// Nodes of the first whose u or v is another, by as little as a bit, than that of the second,
/// whose node (shift) is its first.
inline std::size_t differences(const PlaneSimulation& one, const PlaneSimulation& other,
                               const std::array<std::size_t, 2>& shift = {0, 0}) {
    std::size_t found = 0;
    for (std::size_t y = 0; y < one.scene().nodes[1]; ++y) {
        for (std::size_t x = 0; x < one.scene().nodes[0]; ++x) {
            const std::size_t here = one.entry(x, y);
            const std::size_t there = other.entry(x + shift[0], y + shift[1]);
            for (const std::size_t a : {0U, 1U}) {
                found += std::size_t(
                    one.plane().displacement(a)[here] != other.plane().displacement(a)[there] ||
                    one.plane().velocity(a)[here] != other.plane().velocity(a)[there]);
            }
        }
    }
    return found;
}

}  // namespace nmbcrun::test
