// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nmbc/coefficients.hpp>
#include <optional>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "tools/nmbcrun/scene/read_choice.hpp"
#include "tools/nmbcrun/scene/read_sources.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {
namespace {

constexpr long most_nodes = 100'000'000;

const std::vector<std::pair<std::string_view, BoundaryKind>> boundary_kinds{
    {"nmbc", BoundaryKind::nmbc},
    {"fixed", BoundaryKind::fixed},
    {"free", BoundaryKind::free},
    {"extended", BoundaryKind::extended},
    {"exact", BoundaryKind::exact}};

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
    const auto layer = reader.whole_number(group + ".layer", 1, most_nodes);
    return {
        .kind = kind.value_or(others.kind),
        .order = int(order.value_or(others.order)),
        .stride = int(stride.value_or(others.stride)),
        .ghosts = ghosts.value_or(others.ghosts),
        .matched_step = read_exact(reader, group + ".matched_step").value_or(others.matched_step),
        .layer = std::size_t(layer.value_or(long(others.layer)))};
}

/// The name of the output files: the scene file's own unless it says another, which must not lead
/// out of the folder or garble what is printed.
std::string read_name(SceneReader& reader, const std::string& path) {
    const auto name = reader.text("output.name");
    const auto forbidden = [](unsigned char c) { return c == '/' || std::iscntrl(c) != 0; };
    if (name && (name->empty() || name->find("..") != std::string::npos ||
                 std::ranges::any_of(*name, forbidden))) {
        reader.fail("output.name",
                    "must be a file name without a folder or an ending, without '..' and control "
                    "characters");
    }
    return name.value_or(std::filesystem::path(path).stem().string());
}

/// The nearest double to an exact number in a string, or a number.
std::optional<double> read_G(SceneReader& reader) {
    if (!reader.is_text("model.G")) {
        return reader.number("model.G", not_negative);
    }
    return nmbc::detail::nearest_to_fraction(*read_exact(reader, "model.G"));
}

/// Required, unless the family has one horizon only.
int read_horizon(SceneReader& reader, const std::string& family) {
    const auto horizon = reader.whole_number("model.horizon", 1, 1000);
    return int(family == "chain1d" ? horizon.value_or(1)
                                   : reader.required("model.horizon", horizon));
}

}  // namespace

std::string_view name_of(BoundaryKind kind) {
    return std::ranges::find(boundary_kinds, kind,
                             &std::pair<std::string_view, BoundaryKind>::second)
        ->first;
}

std::string heading_of(const Boundary& boundary) {
    if (boundary.kind == BoundaryKind::extended) {
        return fmt::format("extended by {} nodes", boundary.layer);
    }
    if (boundary.kind != BoundaryKind::nmbc) {
        return std::string(name_of(boundary.kind));
    }
    const bool midpoint = boundary.ghosts == nmbc::GhostRule::midpoint;
    return fmt::format("NMBC{}, stride {}, {} ghosts{}", boundary.order, boundary.stride,
                       midpoint ? "midpoint" : "explicit",
                       boundary.matched_step == "0"
                           ? std::string()
                           : ", matched in steps of " + boundary.matched_step + " dX/c");
}

Overrides split_settings(const std::vector<std::string>& settings) {
    Overrides overrides;
    for (const std::string& setting : settings) {
        const std::size_t mark = setting.find('=');
        if (mark == 0 || mark == std::string::npos) {
            throw SceneError("--set needs KEY=VALUE, not '" + setting + "'");
        }
        overrides.emplace_back(setting.substr(0, mark), setting.substr(mark + 1));
    }
    return overrides;
}

Scene read_scene(const std::string& path, const Overrides& overrides) {
    return read_scene_text(read_text(path), path, overrides);
}

Scene read_scene_text(const std::string& text, const std::string& path,
                      const Overrides& overrides) {
    SceneReader reader(text, path, overrides);
    Scene scene;
    scene.name = read_name(reader, path);
    scene.title = reader.text("title").value_or(scene.name);
    scene.family = reader.text("model.family").value_or(scene.family);
    scene.horizon = read_horizon(reader, scene.family);
    scene.G = read_G(reader).value_or(scene.G);
    scene.tau = read_exact(reader, "model.damping").value_or(scene.tau);
    scene.density = reader.number("material.density", positive).value_or(scene.density);
    scene.youngs_modulus =
        reader.number("material.youngs_modulus", positive).value_or(scene.youngs_modulus);
    scene.nodes = std::size_t(
        reader.required("domain.nodes", reader.whole_number("domain.nodes", 1, most_nodes)));
    scene.spacing = reader.number("domain.spacing", positive).value_or(scene.spacing);
    read_sources(reader, path, scene);
    const Boundary both = read_boundary(reader, "boundary", {});
    scene.left = read_boundary(reader, "boundary.left", both);
    scene.right = read_boundary(reader, "boundary.right", both);
    for (const auto& [group, boundary] :
         {std::pair("boundary.left", scene.left), {"boundary.right", scene.right}}) {
        if (boundary.kind == BoundaryKind::extended && boundary.layer == 0) {
            reader.fail(group, "is of a kind that needs boundary.layer, the nodes of its layer");
        }
    }
    scene.allow_unstable = reader.truth("boundary.allow_unstable").value_or(false);
    scene.end = reader.required("time.end", reader.number("time.end", positive));
    scene.step = reader.number("time.step", positive);
    scene.cfl = reader.number("time.cfl", positive);
    scene.every =
        std::size_t(reader.whole_number("output.every", 1, most_nodes).value_or(long(scene.every)));
    scene.field = reader.truth("output.field").value_or(false);
    reader.refuse_unknown_keys();
    // An override of one replaces the other of the file.
    if (scene.step && scene.cfl &&
        reader.is_overridden("time.step") != reader.is_overridden("time.cfl")) {
        (reader.is_overridden("time.cfl") ? scene.step : scene.cfl).reset();
    }
    if (scene.step && scene.cfl) {
        reader.fail("time", "has both step and cfl; at most one of them is allowed");
    }
    return scene;
}

}  // namespace nmbcrun
