// SPDX-License-Identifier: MIT
/// What scenes of chains and of planes have in common, and how it is read. Keys, units and
/// defaults: docs/reference/scene.md.
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace nmbcrun {

class SceneReader;

/// The most nodes that a scene may have, and steps between two rows or snapshots.
inline constexpr long most_nodes = 100'000'000;

struct AnyScene {
    std::string title{};
    std::string name{};  ///< of the output files; default: the scene file's own
    double density = 1;
    double youngs_modulus = 1;
    double spacing = 1;
    bool allow_unstable = false;  ///< run what is not certified to be stable, too
    double end = 0;
    std::optional<double> step{};  ///< dt [time]; at most one of step and cfl is given;
    std::optional<double> cfl{};   ///< dt omega_max / 2; neither: what the scene allows
    std::size_t every = 10;        ///< steps between two rows of energies
    bool field = false;            ///< whether u and v at the end are written
    std::size_t snapshots = 0;     ///< steps between two snapshots of all nodes; 0: none
    double checkpoint = 60;        ///< seconds of the clock between two checkpoints
    /// Every key that is given, by its dotted path, and its value as text, for comparison.
    std::map<std::string, std::string> given{};
};

/// c = sqrt(E/rho) [length/time].
inline double wave_speed(const AnyScene& scene) {
    return std::sqrt(scene.youngs_modulus / scene.density);
}

/// dX/c [time].
inline double unit_of_time(const AnyScene& scene) {
    return scene.spacing / wave_speed(scene);
}

/// Where waves do not go from node to node until time.end, as where units do not belong together;
/// empty where they do.
std::string warning_of_short_run(const AnyScene& scene);

// Each reads some keys of a scene, and throws SceneError.

/// The title and the name of the output files: the scene file's own, with `_` for what a name must
/// not have, unless it says another, which must not lead out of the folder or garble what is
/// printed.
void read_title(SceneReader& reader, const std::string& path, AnyScene& scene);

/// The material, of whose sqrt(E/rho) a time step is a double.
void read_material(SceneReader& reader, AnyScene& scene);

/// What is written, but for probes. `field` has its default.
void read_output(SceneReader& reader, AnyScene& scene);

/// At most one of time.step and time.cfl: an override of one replaces the other of the file. The
/// last to be read: what is left is unknown.
void read_step(SceneReader& reader, AnyScene& scene);

}  // namespace nmbcrun
