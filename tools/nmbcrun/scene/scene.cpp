// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nmbc/coefficients.hpp>
#include <optional>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "tools/nmbcrun/scene/read_choice.hpp"
#include "tools/nmbcrun/scene/read_influence.hpp"
#include "tools/nmbcrun/scene/read_sources.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"
#include "tools/nmbcrun/scene/trimmed.hpp"

namespace nmbcrun {
namespace {

constexpr double sponge_target = 1e-2;
constexpr double pml_target = 1e-4;

const std::vector<std::pair<std::string_view, BoundaryKind>> boundary_kinds{
    {"nmbc", BoundaryKind::nmbc},
    {"fixed", BoundaryKind::fixed},
    {"free", BoundaryKind::free},
    {"mirror", BoundaryKind::mirror},
    {"node_mirror", BoundaryKind::node_mirror},
    {"snm", BoundaryKind::snm},
    {"sbp", BoundaryKind::sbp},
    {"kernel", BoundaryKind::kernel},
    {"cut", BoundaryKind::cut},
    {"extended", BoundaryKind::extended},
    {"exact", BoundaryKind::exact},
    {"sponge", BoundaryKind::sponge},
    {"pml", BoundaryKind::pml},
    {"passive", BoundaryKind::passive},
    {"higdon", BoundaryKind::higdon},
    {"truncated", BoundaryKind::truncated}};

const std::vector<std::pair<BoundaryKind, nmbc::Closure>> surfaces{
    {BoundaryKind::mirror, nmbc::Closure::mirror},
    {BoundaryKind::snm, nmbc::Closure::surface_node},
    {BoundaryKind::sbp, nmbc::Closure::sbp},
    {BoundaryKind::kernel, nmbc::Closure::kernel},
    {BoundaryKind::cut, nmbc::Closure::cut},
    {BoundaryKind::node_mirror, nmbc::Closure::node_mirror}};

/// In words.
std::string_view name_of(nmbc::Closure closure) {
    switch (closure) {
        case nmbc::Closure::surface_node:
            return "surface node";
        case nmbc::Closure::sbp:
            return "summation by parts";
        case nmbc::Closure::kernel:
            return "convex kernels";
        case nmbc::Closure::cut:
            return "cut";
        case nmbc::Closure::node_mirror:
            return "mirror through the outermost node";
        case nmbc::Closure::mirror:
            break;
    }
    return "mirror";
}

/// The keys that count for it, `kind` aside.
std::vector<std::string_view> keys_of(BoundaryKind kind) {
    switch (kind) {
        case BoundaryKind::nmbc:
        case BoundaryKind::truncated:
            return {"order", "stride", "ghosts", "matched_step"};
        case BoundaryKind::higdon:
            return {"order"};
        case BoundaryKind::extended:
            return {"layer"};
        case BoundaryKind::sponge:
        case BoundaryKind::pml:
            return {"layer", "profile", "target"};
        case BoundaryKind::mirror:
        case BoundaryKind::snm:
        case BoundaryKind::sbp:
        case BoundaryKind::kernel:
        case BoundaryKind::cut:
        case BoundaryKind::node_mirror:
            return {"given"};
        case BoundaryKind::fixed:
        case BoundaryKind::free:
        case BoundaryKind::exact:
        case BoundaryKind::passive:
            break;
    }
    return {};
}

bool counts(std::string_view key, BoundaryKind kind) {
    const auto keys = keys_of(kind);
    return std::ranges::find(keys, key) != keys.end();
}

/// Fails for a key of a group that counts neither for its kind nor for the other kinds, of ends
/// that inherit the key. A file's keys may stay where an override changes one of these kinds.
void refuse_idle_keys(SceneReader& reader, const std::string& group, BoundaryKind kind,
                      const std::vector<BoundaryKind>& others) {
    std::vector<std::string> of_kinds{"boundary.kind", group + ".kind"};
    if (!others.empty()) {
        of_kinds.insert(of_kinds.end(), {"boundary.left.kind", "boundary.right.kind"});
    }
    const bool kind_is_overridden = std::ranges::any_of(
        of_kinds, [&](const std::string& key) { return reader.is_overridden(key); });
    for (const std::string_view name :
         {"order", "stride", "ghosts", "matched_step", "layer", "profile", "target", "given"}) {
        const std::string key = fmt::format("{}.{}", group, name);
        const bool idle =
            !counts(name, kind) &&
            std::ranges::none_of(others, [&](BoundaryKind other) { return counts(name, other); });
        if (idle && reader.has(key) && (reader.is_overridden(key) || !kind_is_overridden)) {
            const auto keys = keys_of(kind);
            reader.fail(key, fmt::format("does not count for kind \"{}\"{}{}", name_of(kind),
                                         keys.empty() ? ", which has no keys of its own"
                                                      : ", whose keys are ",
                                         fmt::join(keys, ", ")));
        }
    }
}

/// An exact number in lowest terms: a string "p/q", or a decimal number as it is written.
std::optional<std::string> read_exact(SceneReader& reader, const std::string& key) {
    const auto given = reader.number_or_text(key);
    try {
        return given ? std::optional(nmbcgen::to_string(nmbcgen::parse_rational(*given)))
                     : std::nullopt;
    } catch (const std::invalid_argument& error) {
        reader.fail(key, "must be an exact number not below 0: " + std::string(error.what()));
    }
}

/// The keys of `group`; those that are not there are as in `others`.
Boundary read_boundary(SceneReader& reader, const std::string& group, const Boundary& others) {
    const auto kind = read_choice(reader, group + ".kind", boundary_kinds);
    const auto order = reader.whole_number(group + ".order", 1, 1000);
    const auto stride = reader.whole_number(group + ".stride", 1, 1000);
    const auto ghosts = read_choice<nmbc::GhostRule>(
        reader, group + ".ghosts",
        {{"midpoint", nmbc::GhostRule::midpoint}, {"explicit", nmbc::GhostRule::explicit_rule}});
    const auto layer = reader.whole_number(group + ".layer", 1, most_layer);
    const auto profile = reader.number(group + ".profile", up_to_10);
    const auto target = reader.number(group + ".target", between_0_and_1);
    const auto given = read_choice<nmbc::OnSurface>(
        reader, group + ".given",
        {{"traction", nmbc::OnSurface::traction}, {"displacement", nmbc::OnSurface::displacement}});
    return {
        .kind = kind.value_or(others.kind),
        .order = int(order.value_or(others.order)),
        .stride = int(stride.value_or(others.stride)),
        .ghosts = ghosts.value_or(others.ghosts),
        .matched_step = read_exact(reader, group + ".matched_step").value_or(others.matched_step),
        .layer = std::size_t(layer.value_or(long(others.layer))),
        .profile = profile.value_or(others.profile),
        .target = target ? target : others.target,
        .given = given.value_or(others.given),
        .value = {}};
}

/// What is given on the surface at one end.
std::optional<ForceHistory> read_value(SceneReader& reader, const std::string& path,
                                       const std::string& end, BoundaryKind kind) {
    const std::string name = end + ".value";
    if (!reader.has(name)) {
        return std::nullopt;
    }
    if (!is_surface(kind)) {
        reader.fail(name,
                    fmt::format("does not count for kind \"{}\"; it is given on a surface: a "
                                "\"mirror\", \"node_mirror\", \"snm\", \"sbp\", \"kernel\" or "
                                "\"cut\"",
                                name_of(kind)));
    }
    const KeyGroup group(reader, name, path);
    return read_history(group, history_of(group));
}

/// The nearest double to an exact number in a string, or a number. It has no default: 0 is standard
/// NOPD, which the paper's conditions absorb badly, and any other value is another lattice.
double read_G(SceneReader& reader, const Scene& scene) {
    if (reader.is_text("model.G")) {
        return nmbc::detail::nearest_to_fraction(*read_exact(reader, "model.G"));
    }
    const auto G = reader.number("model.G", not_negative);
    const bool has_G = scene.family.starts_with("nopd");
    if (!G && has_G) {
        reader.fail("model.G",
                    "is missing: 0 is standard NOPD, whose zero-energy modes no end absorbs" +
                        (scene.family == "nopd1d"
                             ? fmt::format("; \"{}\" makes the dispersion of long waves least at "
                                           "horizon {} and constant influence",
                                           best_G(scene.horizon), scene.horizon)
                             : ""));
    }
    return G.value_or(0);
}

/// Required, unless the family has one horizon only.
int read_horizon(SceneReader& reader, const std::string& family) {
    const auto horizon = reader.whole_number("model.horizon", 1, 1000);
    return int(family == "chain1d" ? horizon.value_or(1)
                                   : reader.required("model.horizon", horizon));
}

/// The nodes nearest to the positions.
std::vector<std::size_t> read_probes(SceneReader& reader, const Scene& scene) {
    std::vector<std::size_t> probes;
    for (const double X : reader.numbers("output.probes", any_number)) {
        const double node = std::round(X / scene.spacing);
        if (!(node >= 1 && node <= double(scene.nodes))) {
            reader.fail("output.probes",
                        fmt::format("has {}, but the nodes are at {} to {}", X, scene.spacing,
                                    double(scene.nodes) * scene.spacing));
        }
        if (std::ranges::find(probes, std::size_t(node) - 1) != probes.end()) {
            reader.fail("output.probes", fmt::format("has node {} twice", node));
        }
        probes.push_back(std::size_t(node) - 1);
    }
    return probes;
}

}  // namespace

std::string best_G(long n) {
    return nmbcgen::to_string(nmbcgen::Rational(4 * n * n * n, (n + 1) * (2 * n + 1)));
}

std::string_view name_of(BoundaryKind kind) {
    return std::ranges::find(boundary_kinds, kind,
                             &std::pair<std::string_view, BoundaryKind>::second)
        ->first;
}

bool is_physical(BoundaryKind kind) {
    return kind == BoundaryKind::fixed || kind == BoundaryKind::free || is_surface(kind);
}

bool is_surface(BoundaryKind kind) {
    return std::ranges::find(surfaces, kind, &std::pair<BoundaryKind, nmbc::Closure>::first) !=
           surfaces.end();
}

nmbc::Closure closure_of(BoundaryKind kind) {
    const auto found =
        std::ranges::find(surfaces, kind, &std::pair<BoundaryKind, nmbc::Closure>::first);
    if (found == surfaces.end()) {
        throw std::logic_error("this end is no surface");
    }
    return found->second;
}

Scene with_artificial_ends(Scene scene, const Boundary& boundary) {
    for (Boundary* end : {&scene.left, &scene.right}) {
        *end = is_physical(end->kind) ? *end : boundary;
    }
    return scene;
}

std::vector<std::filesystem::path> inputs_of(const Scene& scene) {
    std::vector<std::filesystem::path> files = scene.table_files;
    if (scene.initial) {
        files.push_back(scene.initial->file);
    }
    if (scene.force) {
        files.push_back(scene.force->file);
    }
    for (const Boundary& end : {scene.left, scene.right}) {
        if (end.value) {
            files.push_back(end.value->file);
        }
    }
    std::erase(files, std::filesystem::path());
    return files;
}

bool has_layer(BoundaryKind kind) {
    return counts("layer", kind);
}

bool has_profile(BoundaryKind kind) {
    return counts("profile", kind);
}

bool adds_no_energy(BoundaryKind kind) {
    return !takes_table(kind) && kind != BoundaryKind::higdon;
}

bool takes_table(BoundaryKind kind) {
    return kind == BoundaryKind::nmbc || kind == BoundaryKind::truncated;
}

bool has_certificate(BoundaryKind kind) {
    return kind == BoundaryKind::nmbc || adds_no_energy(kind);
}

double target_of(const Boundary& boundary) {
    return boundary.target.value_or(boundary.kind == BoundaryKind::sponge ? sponge_target
                                                                          : pml_target);
}

std::string heading_of(const Boundary& boundary) {
    switch (boundary.kind) {
        case BoundaryKind::extended:
            return boundary.layer > 0 ? fmt::format("extended by {} nodes", boundary.layer)
                                      : "extended until nothing returns";
        case BoundaryKind::sponge:
        case BoundaryKind::pml:
            return fmt::format("{} of {} nodes, profile {}, target {}", name_of(boundary.kind),
                               boundary.layer, boundary.profile, target_of(boundary));
        case BoundaryKind::higdon:
            return fmt::format("higdon of order {}", boundary.order);
        case BoundaryKind::mirror:
        case BoundaryKind::snm:
        case BoundaryKind::sbp:
        case BoundaryKind::kernel:
        case BoundaryKind::cut:
        case BoundaryKind::node_mirror:
            return fmt::format("{} {}{}", name_of(closure_of(boundary.kind)),
                               boundary.given == nmbc::OnSurface::traction ? "under a traction"
                                                                           : "at a displacement",
                               boundary.value ? " in time" : " of 0");
        case BoundaryKind::fixed:
        case BoundaryKind::free:
        case BoundaryKind::exact:
        case BoundaryKind::passive:
            return std::string(name_of(boundary.kind));
        case BoundaryKind::nmbc:
        case BoundaryKind::truncated:
            break;
    }
    const bool midpoint = boundary.ghosts == nmbc::GhostRule::midpoint;
    return fmt::format("{}{}, stride {}, {} ghosts{}",
                       boundary.kind == BoundaryKind::nmbc ? "NMBC" : "truncated MBC",
                       boundary.order, boundary.stride, midpoint ? "midpoint" : "explicit",
                       boundary.matched_step == "0"
                           ? std::string()
                           : ", matched in steps of " + boundary.matched_step + " dX/c");
}

Overrides split_settings(const std::vector<std::string>& settings) {
    Overrides overrides;
    for (const std::string& setting : settings) {
        const std::size_t mark = setting.find('=');
        const std::string key(trimmed(setting.substr(0, mark)));
        if (key.empty() || mark == std::string::npos) {
            throw SceneError("--set needs KEY=VALUE, not '" + setting + "'");
        }
        overrides.emplace_back(key, trimmed(setting.substr(mark + 1)));
    }
    return overrides;
}

Scene read_scene(const std::string& path, const Overrides& overrides) {
    return with_tables(read_scene_text(read_text(path), path, overrides));
}

Scene with_tables(Scene scene) {
    for (const std::filesystem::path& file : scene.table_files) {
        scene.own_tables.push_back(std::make_shared<const TableFile>(file));
    }
    return scene;
}

Scene read_scene_text(const std::string& text, const std::string& path,
                      const Overrides& overrides) {
    SceneReader reader(text, path, overrides);
    reader.refuse_other_tables({"title", "model", "material", "domain", "boundary", "boundary.left",
                                "boundary.right", "time", "output", "drive", "initial", "force",
                                "incoming", "preload"});
    Scene scene;
    read_title(reader, path, scene);
    scene.family = reader.text("model.family").value_or(scene.family);
    scene.auto_horizon = reader.is_word("model.horizon", "auto");
    scene.auto_G = reader.is_word("model.G", "auto");
    scene.horizon = scene.auto_horizon ? scene.horizon : read_horizon(reader, scene.family);
    scene.G = scene.auto_G ? scene.G : read_G(reader, scene);
    scene.tau = read_exact(reader, "model.damping").value_or(scene.tau);
    if (scene.auto_horizon && reader.has("model.influence")) {
        reader.fail("model.influence", "needs a model.horizon that is a number");
    }
    scene.weights = read_influence(reader, scene.family, scene.horizon);
    for (const std::string& file : reader.texts("model.tables")) {
        scene.table_files.push_back(std::filesystem::path(path).parent_path() / file);
    }
    read_material(reader, scene);
    scene.nodes = std::size_t(
        reader.required("domain.nodes", reader.whole_number("domain.nodes", 1, most_nodes)));
    scene.spacing = reader.number("domain.spacing", positive).value_or(scene.spacing);
    read_sources(reader, path, scene);
    const Boundary both = read_boundary(reader, "boundary", {});
    scene.left = read_boundary(reader, "boundary.left", both);
    scene.right = read_boundary(reader, "boundary.right", both);
    scene.left.value = read_value(reader, path, "boundary.left", scene.left.kind);
    scene.right.value = read_value(reader, path, "boundary.right", scene.right.kind);
    require_a_source(path, scene);
    for (const auto& [group, boundary] :
         {std::pair("boundary.left", scene.left), {"boundary.right", scene.right}}) {
        const bool finds_its_own = boundary.kind == BoundaryKind::extended;
        if (has_layer(boundary.kind) && boundary.layer == 0 && !finds_its_own) {
            reader.fail(group, "is of a kind that needs boundary.layer, the nodes of its layer");
        }
    }
    refuse_idle_keys(reader, "boundary", both.kind, {scene.left.kind, scene.right.kind});
    refuse_idle_keys(reader, "boundary.left", scene.left.kind, {});
    refuse_idle_keys(reader, "boundary.right", scene.right.kind, {});
    require_physical_sources(reader, scene);
    scene.allow_unstable = reader.truth("boundary.allow_unstable").value_or(false);
    scene.allow_amplifying = reader.truth("boundary.allow_amplifying").value_or(false);
    scene.end = reader.required("time.end", reader.number("time.end", positive));
    require_sources_in_run(reader, scene);
    read_output(reader, scene);
    scene.probes = read_probes(reader, scene);
    read_step(reader, scene);
    return scene;
}

}  // namespace nmbcrun
