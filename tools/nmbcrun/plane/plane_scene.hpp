// SPDX-License-Identifier: MIT
/// A scene of a plane lattice, read from TOML: one whose domain.nodes is [nx, ny]. Keys, units and
/// defaults: docs/reference/plane-scene.md.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <nmbc/plane_model.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/table/exact.hpp"
#include "tools/nmbcrun/plane/side_choice.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

enum class PlaneShape {
    gaussian,  ///< exp(-(r/width)^2), r the distance from the centre
    cosine,    ///< (1 + cos(pi r/width))/2 up to r = width, (86)
    packet,    ///< a wave exp(-(r/width)^2) cos(k . (X - centre)) that goes in the direction of k
    file,      ///< u of a file, and v
};

/// The state at t = 0.
struct PlaneInitial {
    PlaneShape shape = PlaneShape::gaussian;
    bool of_velocity = false;  ///< v has the shape, and not u
    std::size_t component = 0;
    double amplitude = 0;  ///< [length], or [length/time] of a velocity
    std::array<double, 2> centre{};
    double width = 0;        ///< [length]
    double wave_number = 0;  ///< of a packet: |k| [1/dX]
    double angle = 0;        ///< of k, from the x axis [degrees]
    bool is_P = true;
    std::filesystem::path file{};
    FileFormat format = FileFormat::csv;
    /// The scene's node that the first one of an HDF5 file is; none: the file has the scene's
    /// nodes.
    std::optional<std::array<std::ptrdiff_t, 2>> first_node{};
};

/// A body force in one direction of the nodes within a distance of its centre.
struct PlaneForcing {
    ForceHistory history;
    std::size_t component = 0;
    std::array<double, 2> centre{};
    double half_width = 0;
};

/// (83): one component of the nodes in a rectangle follows u = amplitude/2 (1 - cos(2 pi
/// t/duration)) for 0 <= t <= duration, and is let go.
struct PlaneDrive {
    double amplitude = 0;
    double duration = 0;
    std::size_t component = 0;
    std::array<double, 2> centre{};
    std::array<double, 2> half_width{};
};

/// What a source gives the nodes that it acts on.
enum class Given { force, velocity, displacement };

/// What acts on the nodes of a side or a rectangle from t = 0 on.
struct PlaneLoad {
    std::string name{};  ///< as a scene has it, "load.top"
    Given given = Given::force;
    std::size_t component = 0;
    double amplitude = 0;               ///< [force/volume], [length/time] or [length]
    std::optional<std::size_t> side{};  ///< on the body's outermost nodes there; none:
    std::array<double, 2> centre{};
    std::array<double, 2> half_width{};
    bool is_traction = false;      ///< or a pressure: of a side
    double rise = 0;               ///< grows linearly up to this time
    double until = 0;              ///< and ends at this one
    std::filesystem::path file{};  ///< or follows this one, columns time, force
};

/// Bonds that are cut from the start, and when others break.
struct PlaneFracture {
    std::optional<double> critical_stretch{};
    std::optional<double> energy{};               ///< G_0 [energy/area], in its place
    std::vector<std::array<double, 4>> cracks{};  ///< lines X1, Y1, X2, Y2
    std::vector<std::array<double, 4>> kept{};    ///< rectangles whose nodes keep their bonds
    bool allow_unstable = false;                  ///< weights below 0, too
};

/// Of the files of fields.
enum class FieldFormat { vtk, hdf5 };

struct PlaneScene;

/// That a scene is the body of another one on a lattice of its own (same_body()). Where forces,
/// drives and loads act is said in the lengths and nodes of that one.
struct PlaneOriginal {
    std::shared_ptr<const PlaneScene> scene;
    std::size_t ratio = 1;          ///< its dX over that of the lattice
    std::array<double, 2> first{};  ///< place of the lattice's node 0 among its nodes, from 0
};

struct PlaneScene : AnyScene {
    unsigned radius_squared = 1;
    /// Of a bond-based lattice, by class, where E = density = dX = 1; empty: nopd2d, of which:
    std::vector<double> weights{};
    nmbcgen::Rational nu;
    nmbc::StressState state = nmbc::StressState::plane_stress;
    double G = 0;
    nmbcgen::Rational tau{0};  ///< damping [dX sqrt(rho/E)]
    /// By the |R|^2 of bonds, least first; empty: constant.
    std::vector<double> influence{};
    std::array<std::size_t, 2> nodes{};
    std::optional<PlaneInitial> initial{};
    std::optional<PlaneForcing> force{};
    std::optional<PlaneDrive> drive{};
    std::vector<PlaneLoad> loads{};
    std::optional<PlaneFracture> fracture{};
    std::array<PlaneSideChoice, 4> sides{};  ///< in the order of nmbc::plane_sides
    FieldFormat field_format = FieldFormat::vtk;
    std::vector<std::array<std::size_t, 2>> probes{};  ///< interior nodes, from 0
    std::optional<PlaneOriginal> original{};           ///< of a reference; never read

    bool has(SideKind kind) const;
    bool may_grow() const;  ///< any of its sides can feed energy in
    bool is_bond_based() const { return !weights.empty(); }
};

/// Whether a side has as many nodes as the run's end asks for.
bool has_open_layer(const PlaneScene& scene);

/// The files that a scene is read from, besides its own.
std::vector<std::filesystem::path> inputs_of(const PlaneScene& scene);

/// Whether the text is of a plane scene: domain.nodes is a list there, or in an override.
bool is_plane_scene(const std::string& text, const std::string& path, const Overrides& overrides);

/// Throws SceneError naming the file and key, what is wrong and what is allowed.
PlaneScene read_plane_scene(const std::string& text, const std::string& path,
                            const Overrides& overrides);

/// The position of an interior node [length]: nodes are at dX, 2 dX, .. along each axis.
inline std::array<double, 2> position_of(const PlaneScene& scene, std::size_t x, std::size_t y) {
    return {double(x + 1) * scene.spacing, double(y + 1) * scene.spacing};
}

}  // namespace nmbcrun
