// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/read_sources.hpp"

#include <fmt/format.h>

#include <numbers>
#include <optional>

#include "tools/nmbcrun/scene/read_choice.hpp"

namespace nmbcrun {
namespace {

constexpr Bounds wave_numbers{0, std::numbers::pi, true, "a number from 0 to pi"};

Drive read_drive(const KeyGroup& group) {
    Drive drive;
    drive.amplitude = group.not_zero("amplitude");
    drive.duration = group.number("duration", positive);
    drive.centre = group.number("centre", any_number);
    drive.half_width = group.number_or("half_width", not_negative, drive.half_width);
    return drive;
}

Pulse read_pulse(const KeyGroup& group, Shape shape) {
    Pulse pulse{.shape = shape, .amplitude = group.not_zero("amplitude")};
    pulse.width = group.number("width", positive);
    if (shape == Shape::packet) {
        pulse.wave_number = group.number("wave_number", wave_numbers);
    } else {
        group.refuse({"wave_number"}, "this shape");
    }
    return pulse;
}

/// A file has none of the three shapes.
const std::vector<std::pair<std::string_view, std::optional<Shape>>> shapes_and_file{
    {"gaussian", Shape::gaussian},
    {"ricker", Shape::ricker},
    {"packet", Shape::packet},
    {"csv", std::nullopt}};

InitialKind read_initial_kind(const KeyGroup& group) {
    enum class Of { displacement, velocity };
    const auto of =
        read_choice<Of>(group.reader(), group.key("of"),
                        {{"displacement", Of::displacement}, {"velocity", Of::velocity}});
    const auto direction = read_choice<InitialKind>(group.reader(), group.key("direction"),
                                                    {{"both", InitialKind::displacement},
                                                     {"right", InitialKind::to_the_right},
                                                     {"left", InitialKind::to_the_left}})
                               .value_or(InitialKind::displacement);
    if (of != Of::velocity) {
        return direction;
    }
    if (direction != InitialKind::displacement) {
        group.reader().fail(group.key("direction"),
                            "must be \"both\" of a velocity: a wave that goes one way is given by "
                            "its displacement");
    }
    return InitialKind::velocity;
}

Initial read_initial(const KeyGroup& group) {
    const auto shape = group.choice("shape", shapes_and_file);
    if (!shape) {
        group.refuse({"of", "direction", "amplitude", "centre", "width", "wave_number"},
                     "a csv, which has its own u and v");
        return {.kind = InitialKind::file, .pulse = {}, .centre = 0, .file = group.file()};
    }
    group.refuse({"file"}, "this shape");
    const InitialKind kind = read_initial_kind(group);
    const Pulse pulse = read_pulse(group, *shape);
    return {.kind = kind, .pulse = pulse, .centre = group.number("centre", any_number), .file = {}};
}

Force read_force(const KeyGroup& group) {
    const History history = history_of(group);
    const double centre = group.number("centre", any_number);
    const double half_width = group.number_or("half_width", not_negative, 0);
    return {read_history(group, history), centre, half_width};
}

Incoming read_incoming(const KeyGroup& group) {
    const auto end =
        group.choice<nmbc::End>("end", {{"left", nmbc::End::left}, {"right", nmbc::End::right}});
    const auto shape = group.choice<Shape>(
        "shape",
        {{"gaussian", Shape::gaussian}, {"ricker", Shape::ricker}, {"packet", Shape::packet}});
    const Pulse pulse = read_pulse(group, shape);
    return {.end = end, .pulse = pulse, .arrival = group.number("arrival", not_negative)};
}

Preload read_preload(const KeyGroup& group) {
    return {.strain = group.number("strain", any_number)};
}

void require_begun(const SceneReader& reader, const std::string& key, double start, double end) {
    if (start > end) {
        reader.fail(key,
                    fmt::format("lets it begin at t = {:.4g}, after time.end = {:g}", start, end));
    }
}

template <class Source>
void read(std::optional<Source>& source, Source (*read_group)(const KeyGroup&),
          const KeyGroup& group, const std::string& name) {
    if (group.reader().has(name)) {
        source = read_group(group);
    }
}

/// Of a pulse, which has a duration.
void refuse_frequency(const KeyGroup& group, History history) {
    const std::string key = group.key("frequency");
    const auto frequency = group.reader().number(key, positive);
    if (!frequency) {
        return;
    }
    const std::string duration = group.key("duration");
    group.reader().fail(
        key, history == History::gaussian
                 ? fmt::format("has no meaning for a gaussian, exp(-((t - time)/duration)^2): give "
                               "{}",
                               duration)
                 : fmt::format("has no meaning for a ricker: {} = {:.4g}, 1/(pi frequency), makes "
                               "its spectrum largest there",
                               duration, 1 / (std::numbers::pi * *frequency)));
}

}  // namespace

History history_of(const KeyGroup& group) {
    return group.choice<History>("history", {{"gaussian", History::gaussian},
                                             {"ricker", History::ricker},
                                             {"sine", History::sine},
                                             {"csv", History::file},
                                             {"hdf5", History::file}});
}

ForceHistory read_history(const KeyGroup& group, History history) {
    ForceHistory force;
    force.history = history;
    if (force.history == History::file) {
        force.amplitude = group.reader().has(group.key("amplitude")) ? group.not_zero("amplitude")
                                                                     : force.amplitude;
        force.file = group.file();
        force.format = group.format_in("history");
    } else {
        force.amplitude = group.not_zero("amplitude");
        group.refuse({"file"}, "this history");
    }
    if (force.history == History::gaussian || force.history == History::ricker) {
        refuse_frequency(group, force.history);
        force.duration = group.number("duration", positive);
        force.time = group.number("time", any_number);
    } else {
        group.refuse({"duration"}, force.history == History::sine
                                       ? "a sine, which has a frequency and cycles"
                                       : "this history");
        force.time = group.number_or("time", any_number, force.time);
    }
    if (force.history == History::sine) {
        force.frequency = group.number("frequency", positive);
        force.cycles = group.number_or("cycles", positive, force.cycles);
    } else {
        group.refuse({"frequency", "cycles"}, "this history");
    }
    return force;
}

void read_sources(SceneReader& reader, const std::string& path, Scene& scene) {
    const auto group = [&](const char* name) { return KeyGroup(reader, name, path); };
    read(scene.drive, read_drive, group("drive"), "drive");
    read(scene.initial, read_initial, group("initial"), "initial");
    read(scene.force, read_force, group("force"), "force");
    read(scene.incoming, read_incoming, group("incoming"), "incoming");
    read(scene.preload, read_preload, group("preload"), "preload");
}

void require_a_source(const std::string& path, const Scene& scene) {
    if (!scene.drive && !scene.initial && !scene.force && !scene.incoming && !scene.preload &&
        !has_loaded_surface(scene)) {
        throw SceneError(path +
                         ": nothing starts or drives the scene: it needs at least one of the "
                         "tables drive, initial, force, incoming and preload, or a value on a "
                         "surface");
    }
}

void require_physical_sources(const SceneReader& reader, const Scene& scene) {
    if (!scene.auto_horizon && !scene.auto_G) {
        return;
    }
    const std::string beside =
        scene.auto_horizon ? "model.horizon = \"auto\"" : "model.G = \"auto\"";
    if (scene.auto_horizon && scene.drive && scene.drive->half_width != 0) {
        reader.fail("drive.half_width",
                    "is in horizons: beside " + beside + " it has to be given as 0, one node");
    }
    if (scene.drive && (scene.initial || scene.force || scene.incoming)) {
        reader.fail("drive", "has to be the only source beside " + beside +
                                 ": what it makes of the others' waves is not predicted");
    }
    if (scene.initial && scene.initial->kind == InitialKind::file) {
        reader.fail("initial.shape", "must not be \"csv\" beside " + beside +
                                         ": that is the field of one lattice and time step");
    }
    if (has_loaded_surface(scene)) {
        reader.fail(scene.left.value ? "boundary.left.value" : "boundary.right.value",
                    "must not be there beside " + beside +
                        ": what it makes of the surface's waves is not predicted");
    }
    if (scene.tau != "0") {
        reader.fail("model.damping", "must be 0 beside " + beside +
                                         ": the wave equation, whose waves are sought, has none");
    }
}

void require_in_run(const SceneReader& reader, const std::string& group, const ForceHistory& force,
                    double end) {
    const std::string key = group + ".time";
    const bool has_middle = force.duration > 0;
    const double rest = has_middle ? widths_of_pulse * force.duration
                                   : force.cycles / force.frequency;  // of a file: inf
    require_begun(reader, key, has_middle ? force.time - rest : force.time, end);
    if (force.time + rest < 0) {
        reader.fail(key, "lets it end before the run begins, at t = 0");
    }
}

void require_sources_in_run(const SceneReader& reader, const Scene& scene) {
    if (scene.initial && scene.initial->kind != InitialKind::file) {
        const double reach = widths_of_pulse * scene.initial->pulse.width;
        const double first = scene.spacing;
        const double last = double(scene.nodes) * scene.spacing;
        const double centre = scene.initial->centre;
        if ((centre + reach < first && !has_layer(scene.left.kind)) ||
            (centre - reach > last && !has_layer(scene.right.kind))) {
            reader.fail_beside(
                "initial.centre", "domain.nodes",
                fmt::format("puts it outside of the bar, whose nodes are at {:g} to {:g}", first,
                            last));
        }
    }
    if (scene.force) {
        require_in_run(reader, "force", *scene.force, scene.end);
    }
    if (scene.left.value) {
        require_in_run(reader, "boundary.left.value", *scene.left.value, scene.end);
    }
    if (scene.right.value) {
        require_in_run(reader, "boundary.right.value", *scene.right.value, scene.end);
    }
    if (scene.incoming) {
        const bool from_left = scene.incoming->end == nmbc::End::left;
        const BoundaryKind kind = from_left ? scene.left.kind : scene.right.kind;
        if (is_physical(kind)) {
            reader.fail_beside("incoming.end",
                               from_left ? "boundary.left.kind" : "boundary.right.kind",
                               fmt::format("is where the body ends, by kind \"{}\": waves come in "
                                           "through artificial ends",
                                           name_of(kind)));
        }
        const double way = widths_of_pulse * scene.incoming->pulse.width / wave_speed(scene);
        require_begun(reader, "incoming.arrival", scene.incoming->arrival - way, scene.end);
    }
}

}  // namespace nmbcrun
