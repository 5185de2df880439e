// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/read_plane_sources.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "tools/nmbcrun/scene/key_group.hpp"
#include "tools/nmbcrun/scene/read_choice.hpp"
#include "tools/nmbcrun/scene/read_sources.hpp"

namespace nmbcrun {
namespace {

std::size_t read_component(const KeyGroup& group) {
    return group.choice<std::size_t>("component", {{"x", 0}, {"y", 1}});
}

std::array<double, 2> read_point(const KeyGroup& group, const char* name, const Bounds& bounds) {
    SceneReader& reader = group.reader();
    return reader.required(group.key(name), reader.pair(group.key(name), bounds));
}

/// The node that is at a point, from 0; it need not be one of the scene's.
std::array<std::ptrdiff_t, 2> read_node(const KeyGroup& group, const char* name,
                                        const std::array<double, 2>& point, double spacing) {
    std::array<std::ptrdiff_t, 2> node{};
    for (const std::size_t axis : {0U, 1U}) {
        constexpr double roundings = 1e-6;  // [dX]
        constexpr auto far = double(most_nodes);
        const double place = point[axis] / spacing;
        if (!(std::abs(place) <= far && std::abs(place - std::round(place)) <= roundings)) {
            group.reader().fail(
                group.key(name),
                fmt::format("has {}, which is no place of a node: they are {} apart, "
                            "the first one at [{}, {}]",
                            point[axis], spacing, spacing, spacing));
        }
        node[axis] = std::ptrdiff_t(std::round(place)) - 1;
    }
    return node;
}

PlaneInitial read_initial_file(const KeyGroup& group, double spacing) {
    group.refuse(
        {"amplitude", "centre", "width", "component", "of", "wave_number", "angle", "polarisation"},
        "a file, which has its own u and v");
    PlaneInitial initial{.shape = PlaneShape::file};
    initial.file = group.file();
    initial.format = group.format_in("shape");
    if (initial.format == FileFormat::csv) {
        group.refuse({"origin"}, "a csv, which has its own x and y");
    } else if (const auto origin = group.reader().pair(group.key("origin"), any_number)) {
        initial.first_node = read_node(group, "origin", *origin, spacing);
    }
    return initial;
}

PlaneInitial read_initial(const KeyGroup& group, double spacing) {
    constexpr Bounds wave_numbers{0, std::numbers::pi, false, "a number above 0, up to pi [1/dX]"};
    enum class Of { displacement, velocity };
    enum class Polarisation { P, S };
    PlaneInitial initial;
    initial.shape = group.choice<PlaneShape>("shape", {{"gaussian", PlaneShape::gaussian},
                                                       {"cosine", PlaneShape::cosine},
                                                       {"packet", PlaneShape::packet},
                                                       {"csv", PlaneShape::file},
                                                       {"hdf5", PlaneShape::file}});
    if (initial.shape == PlaneShape::file) {
        return read_initial_file(group, spacing);
    }
    group.refuse({"file", "origin"}, "this shape");
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

PlaneForcing read_plane_force(const KeyGroup& group) {
    const History history = history_of(group);
    PlaneForcing force{.history = {},
                       .component = read_component(group),
                       .centre = read_point(group, "centre", any_number),
                       .half_width = group.number_or("half_width", not_negative, 0)};
    force.history = read_history(group, history);
    return force;
}

PlaneDrive read_plane_drive(const KeyGroup& group) {
    return {.amplitude = group.not_zero("amplitude"),
            .duration = group.number("duration", positive),
            .component = read_component(group),
            .centre = read_point(group, "centre", any_number),
            .half_width = read_point(group, "half_width", not_negative)};
}

PlaneLoad read_load(const KeyGroup& group, const std::string& name, const PlaneScene& scene) {
    enum class Kind { traction, pressure, force, velocity, displacement };
    SceneReader& reader = group.reader();
    const Kind kind = group.choice<Kind>("kind", {{"traction", Kind::traction},
                                                  {"pressure", Kind::pressure},
                                                  {"force", Kind::force},
                                                  {"velocity", Kind::velocity},
                                                  {"displacement", Kind::displacement}});
    const auto side = read_choice<std::size_t>(
        reader, group.key("side"), {{"left", 0}, {"right", 1}, {"bottom", 2}, {"top", 3}});
    PlaneLoad load{.name = name};
    load.given = kind == Kind::velocity       ? Given::velocity
                 : kind == Kind::displacement ? Given::displacement
                                              : Given::force;
    load.amplitude = load.given == Given::force
                         ? group.not_zero("amplitude")
                         : group.number("amplitude", any_number);  // 0 holds it
    if (kind == Kind::pressure) {
        group.refuse({"component"}, "a pressure, which acts inwards");
    } else {
        load.component = read_component(group);
    }
    if (kind == Kind::traction || kind == Kind::pressure) {
        const PlaneSideChoice& beside = scene.sides[reader.required(group.key("side"), side)];
        if (!ends_body(beside.kind)) {
            reader.fail(
                group.key("side"),
                fmt::format("has no surface: the body does not end there, or is held (side "
                            "{}). A traction or pressure needs boundary.{}.kind = \"free\", "
                            "\"sbp\" or \"kernel\"; loads of other kinds do not",
                            heading_of(beside), plane_side_names[*side]));
        }
        load.amplitude /= scene.spacing;  // of a whole cell
        load.is_traction = true;
    }
    if (side) {
        group.refuse({"centre", "half_width"}, "the nodes of a side");
        load.side = side;
        if (kind == Kind::pressure) {
            load.component = *side / 2;
            load.amplitude *= *side % 2 == 0 ? 1 : -1;
        }
    } else {
        if (!reader.has(group.key("centre"))) {
            reader.fail(group.key("kind"), "needs a side, or a centre and a half_width");
        }
        load.centre = read_point(group, "centre", any_number);
        load.half_width = read_point(group, "half_width", not_negative);
    }
    if (reader.has(group.key("file"))) {
        group.refuse({"rise", "until"}, "a load from a file");
        load.file = group.file();
    }
    load.rise = group.number_or("rise", not_negative, 0);
    if (load.given == Given::displacement && load.file.empty() && load.amplitude != 0 &&
        load.rise == 0) {
        reader.fail(group.key("kind"),
                    fmt::format("needs {} above 0, or a file: to be displaced at once nodes would "
                                "be infinitely fast",
                                group.key("rise")));
    }
    load.until = group.number_or("until", positive, std::numeric_limits<double>::infinity());
    if (load.until < load.rise) {
        reader.fail(group.key("until"), "is before rise, so that the load never has its amplitude");
    }
    return load;
}

}  // namespace

void read_plane_sources(SceneReader& reader, const std::string& path, PlaneScene& scene) {
    if (reader.has("initial")) {
        scene.initial = read_initial({reader, "initial", path}, scene.spacing);
    }
    if (reader.has("force")) {
        scene.force = read_plane_force({reader, "force", path});
    }
    if (reader.has("drive")) {
        scene.drive = read_plane_drive({reader, "drive", path});
    }
    for (const std::string& name : reader.tables_in("load")) {
        scene.loads.push_back(read_load({reader, "load." + name, path}, "load." + name, scene));
    }
    if (!scene.initial && !scene.force && !scene.drive && scene.loads.empty()) {
        throw SceneError(path +
                         ": nothing starts or drives the scene: it needs at least one of the "
                         "tables initial, force, drive and load.NAME");
    }
}

void require_plane_sources_inside(const SceneReader& reader, const PlaneScene& scene) {
    if (scene.force) {
        require_in_run(reader, "force", scene.force->history, scene.end);
    }
    if (!scene.initial || scene.initial->shape == PlaneShape::file) {
        return;
    }
    const double reach =
        scene.initial->width * (scene.initial->shape == PlaneShape::cosine ? 1 : widths_of_pulse);
    for (const std::size_t axis : {0U, 1U}) {
        const double last = double(scene.nodes[axis]) * scene.spacing;
        const double centre = scene.initial->centre[axis];
        if (centre + reach < scene.spacing || centre - reach > last) {
            reader.fail_beside(
                "initial.centre", "domain.nodes",
                fmt::format("puts it outside of the plane, whose nodes are at {:g} to {:g} "
                            "along {}",
                            scene.spacing, last, axis == 0 ? 'x' : 'y'));
        }
    }
}

}  // namespace nmbcrun
