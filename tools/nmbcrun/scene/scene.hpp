// SPDX-License-Identifier: MIT
/// A scene: what nmbcrun runs, read from TOML. Keys, units and defaults: docs/reference/scene.md.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/surface.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/nmbcrun/scene/any_scene.hpp"
#include "tools/nmbcrun/scene/sources.hpp"
#include "tools/nmbcrun/scene/table_file.hpp"

namespace nmbcrun {

/// Nodes of a layer: more than any that somebody could want to wait for.
inline constexpr long most_layer = 10'000'000;

enum class BoundaryKind {
    nmbc,         ///< (60) on all ghost layers
    fixed,        ///< ghosts held at u = 0
    free,         ///< ghosts the mirror image
    mirror,       ///< likewise, under a traction or at a displacement that is given in time
    snm,          ///< the same by a surface node (SNM 2023)
    sbp,          ///< the same on the outermost node, by summation by parts
    kernel,       ///< the same by convex kernels (Wu 2015)
    cut,          ///< the same, the families cut off there
    extended,     ///< more of the same lattice, fixed at its far end
    exact,        ///< the same lattice for ever, by convolution
    sponge,       ///< a layer that damps the velocity
    pml,          ///< a perfectly matched layer
    passive,      ///< stable by construction, designed for the lattice and the steps
    higdon,       ///< Higdon's one-way product on all ghost layers
    truncated,    ///< (60) on n ghost nodes, the families cut off there: the edge effect
    node_mirror,  ///< a mirror whose surface is on the outermost node
};

/// One end of the chain.
struct Boundary {
    BoundaryKind kind = BoundaryKind::nmbc;
    // Of an nmbc or truncated; the order of a higdon, too:
    int order = 1;
    int stride = 1;
    nmbc::GhostRule ghosts = nmbc::GhostRule::midpoint;
    std::string matched_step = "0";  ///< dt its table is matched in [dX/c], "p/q"; "0": none
    // Of those that put a layer outside of the interior:
    std::size_t layer = 0;  ///< nodes of it; of an extended end 0: as many as it takes
    // Of a sponge or pml:
    double profile = 2;              ///< exponent of the loss in the depth
    std::optional<double> target{};  ///< what the continuum sends back; nothing: the kind's own
    // Of a surface, is_surface():
    nmbc::OnSurface given = nmbc::OnSurface::traction;
    std::optional<ForceHistory> value{};  ///< of that [stress or length]; nothing: 0

    friend bool operator==(const Boundary&, const Boundary&) = default;
};

/// The G at which the speed of long waves is right to fourth order in continuous time, at constant
/// influence, "p/q" (docs/explanation/dispersion.md).
std::string best_G(long horizon);

/// As a scene spells it, such as "fixed".
std::string_view name_of(BoundaryKind kind);

/// Whether it is a part of what is simulated, and not in the place of more of the same lattice: a
/// physical end stays as it is, where artificial ones are compared, advised and taken away.
bool is_physical(BoundaryKind kind);

/// Whether it is a surface with something given on it.
bool is_surface(BoundaryKind kind);

/// Whether it is a surface and no mirror: its closure errs on its own lattice, and may oscillate
/// faster than the interior.
bool is_closure(BoundaryKind kind);

/// Whether it sends waves back as a free end does: that, or a mirror between nodes under a
/// traction, whichever that is.
bool is_free(const Boundary& boundary);

/// How it is closed. Throws std::logic_error for a kind that is no surface.
nmbc::Closure closure_of(BoundaryKind kind);

/// Whether it puts a layer outside of the interior.
bool has_layer(BoundaryKind kind);

/// Whether that layer takes energy out, by a profile and a target.
bool has_profile(BoundaryKind kind);

/// Whether it can only take energy from the chain, or give back what it took, at every step up to
/// the interior's limit.
bool adds_no_energy(BoundaryKind kind);

/// Whether a table with its coefficients makes this end.
bool takes_table(BoundaryKind kind);

/// Whether there can be a certificate for a chain with this end.
bool has_certificate(BoundaryKind kind);

/// The amplitude that the layer of a sponge or pml lets come back in the continuum.
double target_of(const Boundary& boundary);

/// The end in words, such as "NMBC1, stride 1, midpoint ghosts" or "fixed".
std::string heading_of(const Boundary& boundary);

struct Scene : AnyScene {
    std::string family = "nopd1d";
    int horizon = 1;
    double G = 0;
    std::string exact_G{};      ///< "p/q" in lowest terms, where it is given so; of that G alone
    bool auto_horizon = false;  ///< left to be chosen, and what horizon or G says does not count;
    bool auto_G = false;        ///< what needs the lattice refuses the scene then (tables.hpp)
    std::string tau = "0";      ///< damping [c/dX], "p/q" in lowest terms
    /// Of the influence, w_1 = "1" .. w_n, "p/q" in lowest terms; none: constant.
    std::vector<std::string> weights{};
    std::vector<std::filesystem::path> table_files{};  ///< the user's own, in the order to look in
    std::vector<std::shared_ptr<const TableFile>> own_tables{};  ///< what they hold
    std::size_t nodes = 0;
    // At least one of them is there; together they add up.
    std::optional<Drive> drive{};
    std::optional<Initial> initial{};
    std::optional<Force> force{};
    std::optional<Incoming> incoming{};
    std::optional<Preload> preload{};
    Boundary left;
    Boundary right;
    bool allow_amplifying = false;      ///< ends that send back more than comes, of what comes, too
    std::vector<std::size_t> probes{};  ///< interior nodes, from 0, whose u and v are written
};

/// The scene with this boundary in the place of each artificial one.
Scene with_artificial_ends(Scene scene, const Boundary& boundary);

/// The files that a scene is read from, besides its own.
std::vector<std::filesystem::path> inputs_of(const Scene& scene);

/// nopd1d of constant influence: the lattice whose families nmbcrun can cut off, if undamped.
inline bool has_constant_influence(const Scene& scene) {
    return scene.family == "nopd1d" && scene.weights.empty();
}

/// Whether something other than 0 is given on a surface.
inline bool has_loaded_surface(const Scene& scene) {
    return scene.left.value || scene.right.value;
}

inline bool is_damped(const Scene& scene) {
    return scene.tau != "0";
}

/// Of the scene's chain in such steps [time].
inline nmbc::ChainParameters parameters_of(const Scene& scene, double time_step) {
    return {scene.nodes, scene.spacing, scene.youngs_modulus, scene.density, time_step};
}

/// KEY=VALUE of --set, not parsed yet.
using Overrides = std::vector<std::pair<std::string, std::string>>;

/// KEY=VALUE texts at their first '='. Throws SceneError where one has none, or no key.
Overrides split_settings(const std::vector<std::string>& settings);

/// Reads a scene file, with overrides applied, and its tables. Throws SceneError naming the
/// file and line, or the override, what is wrong and what is allowed; FileError where a file
/// cannot be read.
Scene read_scene(const std::string& path, const Overrides& overrides);

/// Likewise, of a text that is read already, without its tables; path: for messages, and the folder
/// and name it implies.
Scene read_scene_text(const std::string& text, const std::string& path, const Overrides& overrides);

/// Reads the scene's tables. Throws as read_scene().
Scene with_tables(Scene scene);

}  // namespace nmbcrun
