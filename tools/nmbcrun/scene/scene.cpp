// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nmbc/coefficients.hpp>
#include <optional>

#include "generator/exact/rational.hpp"
#include "generator/table/table.hpp"
#include "tools/nmbcrun/scene/read_boundary.hpp"
#include "tools/nmbcrun/scene/read_exact.hpp"
#include "tools/nmbcrun/scene/read_influence.hpp"
#include "tools/nmbcrun/scene/read_sources.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"
#include "tools/nmbcrun/scene/trimmed.hpp"

namespace nmbcrun {
namespace {

/// Into G, and exact_G where it is an exact number in a string. It has no default: 0 is standard
/// NOPD, which the paper's conditions absorb badly, and any other value is another lattice.
void read_G_into(Scene& scene, SceneReader& reader) {
    if (reader.is_text("model.G")) {
        scene.exact_G = *read_exact(reader, "model.G");
        scene.G = nmbc::detail::nearest_to_fraction(scene.exact_G);
        return;
    }
    const auto G = reader.number("model.G", not_negative);
    const bool has_G = scene.family.starts_with("nopd");
    if (!G && has_G) {
        reader.missing("model.G",
                       "0 is standard NOPD, whose zero-energy modes no end absorbs" +
                           (scene.family == "nopd1d"
                                ? fmt::format("; \"{}\" makes the dispersion of long waves least "
                                              "at horizon {} and constant influence",
                                              best_G(scene.horizon), scene.horizon)
                                : ""));
    }
    scene.G = G.value_or(0);
}

/// Required, unless the family has one horizon only.
int read_horizon(SceneReader& reader, const std::string& family) {
    const auto horizon = reader.whole_number("model.horizon", 1, nmbcgen::highest_count);
    return int(family == "chain1d" ? horizon.value_or(1)
                                   : reader.required("model.horizon", horizon));
}

/// The nodes nearest to the positions.
std::vector<std::size_t> read_probes(SceneReader& reader, const Scene& scene) {
    std::vector<std::size_t> probes;
    for (const double X : reader.numbers("output.probes", any_number)) {
        const double node = std::round(X / scene.spacing);
        if (!(node >= 1 && node <= double(scene.nodes))) {
            reader.fail_beside("output.probes", "domain.nodes",
                               fmt::format("has {}, but the nodes are at {} to {}", X,
                                           scene.spacing, double(scene.nodes) * scene.spacing));
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
    if (!scene.auto_G) {
        read_G_into(scene, reader);
    }
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
