// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

#include "generator/exact/rational.hpp"
#include "tools/nmbcrun/scene/key_group.hpp"
#include "tools/nmbcrun/scene/printable.hpp"
#include "tools/nmbcrun/scene/read_sources.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {
namespace {

const std::vector<std::pair<std::string_view, SideKind>> side_kinds{
    {"passive", SideKind::passive},   {"fixed", SideKind::fixed},       {"free", SideKind::free},
    {"periodic", SideKind::periodic}, {"extended", SideKind::extended}, {"nmbc", SideKind::nmbc},
    {"higdon", SideKind::higdon},     {"sponge", SideKind::sponge}};

/// The keys that count for it, `kind` aside.
std::vector<std::string_view> keys_of(SideKind kind) {
    switch (kind) {
        case SideKind::nmbc:
            return {"order", "stride", "as_printed"};
        case SideKind::extended:
            return {"layer"};
        case SideKind::sponge:
            return {"layer", "profile", "target"};
        default:
            return {};
    }
}

constexpr std::array<std::string_view, 4> side_names{"left", "right", "bottom", "top"};

/// An exact number, which may be below 0.
std::optional<nmbcgen::Rational> read_signed(SceneReader& reader, const std::string& key) {
    const auto given = reader.number_or_text(key);
    if (!given) {
        return std::nullopt;
    }
    try {
        return nmbcgen::parse_signed_rational(*given);
    } catch (const std::invalid_argument&) {
        reader.fail(
            key, fmt::format(R"(must be an exact number, such as 0.25 or "-1/4", not {})", *given));
    }
}

/// The family, its material and G, which the runtime knows how to refuse.
void read_model(SceneReader& reader, PlaneScene& scene) {
    const std::string family = reader.text("model.family").value_or("nopd2d");
    if (family != "nopd2d") {
        reader.fail("model.family",
                    R"(must be "nopd2d" where domain.nodes is [nx, ny], not ")" + family + '"');
    }
    scene.radius_squared =
        unsigned(reader.required("model.radius2", reader.whole_number("model.radius2", 1, 100)));
    scene.nu = reader.required("model.nu", read_signed(reader, "model.nu"));
    scene.state =
        read_choice<nmbc::StressState>(reader, "model.state",
                                       {{"plane stress", nmbc::StressState::plane_stress},
                                        {"plane strain", nmbc::StressState::plane_strain}})
            .value_or(nmbc::StressState::plane_stress);
    const auto G = reader.is_text("model.G") ? read_signed(reader, "model.G") : std::nullopt;
    scene.G = G ? nmbcgen::nearest_double(*G)
                : reader.required("model.G", reader.number("model.G", not_negative));
    try {
        nmbc::nopd2d(scene.radius_squared, nmbcgen::nearest_double(scene.nu), scene.G, scene.state);
    } catch (const std::invalid_argument& error) {
        reader.fail("model", "is no material: " + std::string(error.what()));
    }
}

std::size_t read_component(const KeyGroup& group) {
    return group.choice<std::size_t>("component", {{"x", 0}, {"y", 1}});
}

std::array<double, 2> read_point(const KeyGroup& group, const char* name, const Bounds& bounds) {
    SceneReader& reader = group.reader();
    return reader.required(group.key(name), reader.pair(group.key(name), bounds));
}

PlaneInitial read_initial(const KeyGroup& group) {
    constexpr Bounds wave_numbers{0, std::numbers::pi, false, "a number above 0, up to pi"};
    enum class Of { displacement, velocity };
    enum class Polarisation { P, S };
    PlaneInitial initial;
    initial.shape = group.choice<PlaneShape>("shape", {{"gaussian", PlaneShape::gaussian},
                                                       {"cosine", PlaneShape::cosine},
                                                       {"packet", PlaneShape::packet}});
    initial.amplitude = group.not_zero("amplitude");
    initial.centre = read_point(group, "centre", any_number);
    initial.width = group.number("width", positive);
    if (initial.shape == PlaneShape::packet) {
        group.refuse({"component", "of"}, "a packet, whose wave has a displacement and a velocity");
        initial.wave_number = group.number("wave_number", wave_numbers);
        initial.angle = group.number("angle", any_number);
        initial.is_P = group.choice<Polarisation>(
                           "polarisation", {{"P", Polarisation::P}, {"S", Polarisation::S}}) ==
                       Polarisation::P;
        return initial;
    }
    group.refuse({"wave_number", "angle", "polarisation"}, "this shape");
    initial.of_velocity = read_choice<Of>(group.reader(), group.key("of"),
                                          {{"displacement", Of::displacement},
                                           {"velocity", Of::velocity}}) == Of::velocity;
    initial.component = read_component(group);
    return initial;
}

PlaneForcing read_force(const KeyGroup& group) {
    const History history = history_of(group);
    PlaneForcing force{.history = {},
                       .component = read_component(group),
                       .centre = read_point(group, "centre", any_number),
                       .half_width = group.number_or("half_width", not_negative, 0)};
    force.history = read_history(group, history);
    return force;
}

PlaneDrive read_drive(const KeyGroup& group) {
    return {.amplitude = group.not_zero("amplitude"),
            .duration = group.number("duration", positive),
            .component = read_component(group),
            .centre = read_point(group, "centre", any_number),
            .half_width = read_point(group, "half_width", not_negative)};
}

void read_plane_sources(SceneReader& reader, const std::string& path, PlaneScene& scene) {
    if (reader.has("initial")) {
        scene.initial = read_initial({reader, "initial", path});
    }
    if (reader.has("force")) {
        scene.force = read_force({reader, "force", path});
    }
    if (reader.has("drive")) {
        scene.drive = read_drive({reader, "drive", path});
    }
    if (!scene.initial && !scene.force && !scene.drive) {
        throw SceneError(path +
                         ": nothing starts or drives the scene: it needs at least one of the "
                         "tables initial, force and drive");
    }
}

/// A shape is 1e-16 of its height beyond 6.5 widths.
void require_sources_inside(const SceneReader& reader, const PlaneScene& scene) {
    if (!scene.initial) {
        return;
    }
    const double reach =
        scene.initial->width * (scene.initial->shape == PlaneShape::cosine ? 1 : 6.5);
    for (const std::size_t axis : {0U, 1U}) {
        const double last = double(scene.nodes[axis]) * scene.spacing;
        const double centre = scene.initial->centre[axis];
        if (centre + reach < scene.spacing || centre - reach > last) {
            reader.fail("initial.centre",
                        fmt::format("puts it outside of the plane, whose nodes are at {:g} to {:g} "
                                    "along {}",
                                    scene.spacing, last, axis == 0 ? 'x' : 'y'));
        }
    }
}

PlaneSideChoice read_side(SceneReader& reader, const std::string& group,
                          const PlaneSideChoice& otherwise) {
    PlaneSideChoice side = otherwise;
    side.kind = read_choice(reader, group + ".kind", side_kinds).value_or(side.kind);
    if (side.kind != otherwise.kind) {
        side.layer = 0;  // of another kind
    }
    if (const auto layer = reader.whole_number(group + ".layer", 1, most_layer)) {
        side.layer = std::size_t(*layer);
    }
    side.order = int(reader.whole_number(group + ".order", 1, 10).value_or(side.order));
    side.stride = int(reader.whole_number(group + ".stride", 1, 1000).value_or(side.stride));
    side.as_printed = reader.truth(group + ".as_printed").value_or(side.as_printed);
    side.profile = reader.number(group + ".profile", up_to_10).value_or(side.profile);
    side.target = reader.number(group + ".target", between_0_and_1).value_or(side.target);
    return side;
}

/// Keys of a group that count for none of its sides; a file's may stay where an override changes a
/// kind.
void refuse_idle_keys(SceneReader& reader, const std::string& group,
                      std::span<const PlaneSideChoice> sides) {
    const bool kind_is_overridden =
        reader.is_overridden("boundary.kind") || reader.is_overridden(group + ".kind");
    for (const std::string_view name :
         {"order", "stride", "as_printed", "layer", "profile", "target"}) {
        const std::string key = fmt::format("{}.{}", group, name);
        const bool counts = std::ranges::any_of(sides, [&](const PlaneSideChoice& side) {
            const auto keys = keys_of(side.kind);
            return std::ranges::find(keys, name) != keys.end();
        });
        if (!counts && reader.has(key) && (reader.is_overridden(key) || !kind_is_overridden)) {
            reader.fail(key, fmt::format("does not count for kind \"{}\"", name_of(sides[0].kind)));
        }
    }
}

void read_sides(SceneReader& reader, PlaneScene& scene) {
    const PlaneSideChoice all = read_side(reader, "boundary", {});
    for (std::size_t i = 0; i < scene.sides.size(); ++i) {
        scene.sides[i] = read_side(reader, fmt::format("boundary.{}", side_names[i]), all);
    }
    refuse_idle_keys(reader, "boundary", scene.sides);
    for (std::size_t i = 0; i < scene.sides.size(); ++i) {
        const std::string group = fmt::format("boundary.{}", side_names[i]);
        refuse_idle_keys(reader, group, {&scene.sides[i], 1});
        const PlaneSideChoice& side = scene.sides[i];
        if (side.kind == SideKind::sponge && side.layer == 0) {
            reader.fail("boundary", "has a sponge, which needs boundary.layer, its nodes");
        }
        if (side.as_printed && (side.order != 1 || side.stride != 1)) {
            reader.fail("boundary",
                        "has as_printed, which is (81), beside another order or stride than 1");
        }
    }
    for (const std::size_t low : {0U, 2U}) {
        if ((scene.sides[low].kind == SideKind::periodic) !=
            (scene.sides[low + 1].kind == SideKind::periodic)) {
            reader.fail("boundary", fmt::format("has a periodic side opposite one that is not: {} "
                                                "and {} have to be periodic both, or neither",
                                                side_names[low], side_names[low + 1]));
        }
    }
}

/// The nodes nearest to the points.
std::vector<std::array<std::size_t, 2>> read_plane_probes(SceneReader& reader,
                                                          const PlaneScene& scene) {
    std::vector<std::array<std::size_t, 2>> probes;
    for (const std::array<double, 2>& point : reader.pairs("output.probes")) {
        std::array<std::size_t, 2> node{};
        for (const std::size_t axis : {0U, 1U}) {
            const double place = std::round(point[axis] / scene.spacing);
            if (!(place >= 1 && place <= double(scene.nodes[axis]))) {
                reader.fail(
                    "output.probes",
                    fmt::format("has [{}, {}], but the nodes are at {} to {} along {}", point[0],
                                point[1], scene.spacing, double(scene.nodes[axis]) * scene.spacing,
                                axis == 0 ? 'x' : 'y'));
            }
            node[axis] = std::size_t(place) - 1;
        }
        probes.push_back(node);
    }
    return probes;
}

}  // namespace

std::string_view name_of(SideKind kind) {
    return std::ranges::find(side_kinds, kind, &std::pair<std::string_view, SideKind>::second)
        ->first;
}

bool may_grow(SideKind kind) {
    return kind == SideKind::nmbc || kind == SideKind::higdon;
}

bool is_artificial(SideKind kind) {
    return kind != SideKind::fixed && kind != SideKind::free && kind != SideKind::periodic;
}

std::string heading_of(const PlaneSideChoice& side) {
    switch (side.kind) {
        case SideKind::nmbc:
            return side.as_printed
                       ? std::string("NMBC1 as printed, (81)")
                       : fmt::format("NMBC{} by component, stride {}", side.order, side.stride);
        case SideKind::higdon:
            return "higdon of the P and S speeds";
        case SideKind::sponge:
            return fmt::format("sponge of {} nodes, profile {}, target {}", side.layer,
                               side.profile, side.target);
        default:
            return std::string(name_of(side.kind));
    }
}

bool has_open_layer(const PlaneScene& scene) {
    return std::ranges::any_of(scene.sides, [](const PlaneSideChoice& side) {
        return side.kind == SideKind::extended && side.layer == 0;
    });
}

bool PlaneScene::has(SideKind kind) const {
    return std::ranges::any_of(sides,
                               [kind](const PlaneSideChoice& side) { return side.kind == kind; });
}

bool is_plane_scene(const std::string& text, const std::string& path, const Overrides& overrides) {
    SceneReader reader(text, path, overrides);
    return reader.is_list("domain.nodes") || reader.has("model.radius2");
}

PlaneScene read_plane_scene(const std::string& text, const std::string& path,
                            const Overrides& overrides) {
    SceneReader reader(text, path, overrides);
    reader.refuse_other_tables({"title", "model", "material", "domain", "boundary", "boundary.left",
                                "boundary.right", "boundary.bottom", "boundary.top", "time",
                                "output", "initial", "force", "drive"});
    PlaneScene scene;
    scene.name = read_name(reader, path);
    if (scene.name.find_first_of("\"'&<>") != std::string::npos) {  // it stands in XML
        reader.fail("output.name", "must be without \" ' & < >");
    }
    scene.title = printable(reader.text("title").value_or(scene.name));
    read_model(reader, scene);
    scene.density = reader.number("material.density", positive).value_or(scene.density);
    scene.youngs_modulus =
        reader.number("material.youngs_modulus", positive).value_or(scene.youngs_modulus);
    require_wave_speed(reader, std::sqrt(scene.youngs_modulus / scene.density));
    const auto nodes = reader.required("domain.nodes", reader.pair("domain.nodes", positive));
    for (const std::size_t axis : {0U, 1U}) {
        if (nodes[axis] != std::floor(nodes[axis]) || nodes[0] * nodes[1] > double(most_nodes)) {
            reader.fail("domain.nodes",
                        fmt::format("must be [nx, ny], two whole numbers whose product is at most "
                                    "{}, not [{}, {}]",
                                    most_nodes, nodes[0], nodes[1]));
        }
        scene.nodes[axis] = std::size_t(nodes[axis]);
    }
    scene.spacing = reader.number("domain.spacing", positive).value_or(scene.spacing);
    read_plane_sources(reader, path, scene);
    read_sides(reader, scene);
    scene.allow_unstable = reader.truth("boundary.allow_unstable").value_or(false);
    scene.end = reader.required("time.end", reader.number("time.end", positive));
    scene.step = reader.number("time.step", positive);
    scene.cfl = reader.number("time.cfl", positive);
    scene.every =
        std::size_t(reader.whole_number("output.every", 1, most_nodes).value_or(long(scene.every)));
    scene.field = reader.truth("output.field").value_or(false);
    scene.probes = read_plane_probes(reader, scene);
    scene.snapshots =
        std::size_t(reader.whole_number("output.snapshots", 1, most_nodes).value_or(0));
    scene.checkpoint = reader.number("output.checkpoint", positive).value_or(scene.checkpoint);
    scene.given = reader.given();
    reader.refuse_unknown_keys();
    require_sources_inside(reader, scene);
    settle_step(reader, scene.step, scene.cfl);
    return scene;
}

}  // namespace nmbcrun
