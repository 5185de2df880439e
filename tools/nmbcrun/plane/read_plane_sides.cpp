// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/read_plane_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/names/printable.hpp"
#include "generator/passive/plane_side.hpp"
#include "generator/table/table.hpp"
#include "tools/nmbcrun/plane/matched_layers.hpp"
#include "tools/nmbcrun/scene/read_choice.hpp"

namespace nmbcrun {
namespace {

/// The keys that count for it, `kind` aside.
std::vector<std::string_view> keys_of(SideKind kind) {
    switch (kind) {
        case SideKind::nmbc:
            return {"order", "stride", "as_printed"};
        case SideKind::higdon:
            return {"absorb"};
        case SideKind::mirror:
            return {"odd"};
        case SideKind::passive:
        case SideKind::extended:
            return {"layer"};
        case SideKind::sponge:
        case SideKind::pml:
            return {"layer", "profile", "target"};
        default:
            return {};
    }
}

/// Of "30", or of "3:4", whose angle has this cosine and sine but for a factor.
std::optional<double> degrees_of(std::string_view text) {
    const auto number = [](std::string_view part) -> std::optional<double> {
        double value = 0;
        const char* const end = part.data() + part.size();
        const auto [stop, error] = std::from_chars(part.data(), end, value);
        return error == std::errc() && stop == end && value >= 0 ? std::optional(value)
                                                                 : std::nullopt;
    };
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) {
        return number(text);
    }
    const auto x = number(text.substr(0, colon));
    const auto y = number(text.substr(colon + 1));
    return x && y && *x + *y > 0 ? std::optional(std::atan2(*y, *x) * 180 / std::numbers::pi)
                                 : std::nullopt;
}

/// "P:30"
std::optional<ObliqueWave> oblique_wave(const std::string& text) {
    if (text.size() < 3 || (text[0] != 'P' && text[0] != 'S') || text[1] != ':') {
        return std::nullopt;
    }
    const auto degrees = degrees_of(std::string_view(text).substr(2));
    return degrees && *degrees < 90
               ? std::optional(ObliqueWave{.is_P = text[0] == 'P', .degrees = *degrees})
               : std::nullopt;
}

std::vector<ObliqueWave> read_waves(SceneReader& reader, const std::string& key) {
    std::vector<ObliqueWave> waves;
    for (const std::string& text : reader.texts(key)) {
        const auto wave = oblique_wave(text);
        if (!wave) {
            reader.fail(key,
                        fmt::format("has \"{}\": a wave is P or S and the angle from the normal "
                                    "at which it comes, 0 or more and below 90 degrees or X:Y, "
                                    "such as \"P:30\" or \"S:3:4\"",
                                    nmbcgen::printable(text.substr(0, 60))));
        }
        waves.push_back(*wave);
    }
    if (waves.empty() || waves.size() > 2) {
        reader.fail(key, R"(must have one wave or two, such as ["P:30", "S:60"])");
    }
    return waves;
}

bool counts(std::string_view key, SideKind kind) {
    const auto keys = keys_of(kind);
    return std::ranges::find(keys, key) != keys.end();
}

PlaneSideChoice read_side(SceneReader& reader, const std::string& group,
                          const PlaneSideChoice& otherwise) {
    PlaneSideChoice side = otherwise;
    side.kind = read_choice(reader, group + ".kind", side_kinds()).value_or(side.kind);
    if (side.kind != otherwise.kind && counts("layer", otherwise.kind)) {
        side.layer = 0;  // of another kind
    }
    if (const auto layer = reader.whole_number(group + ".layer", 1, most_layer)) {
        side.layer = std::size_t(*layer);
    }
    side.order = int(reader.whole_number(group + ".order", 1, 10).value_or(side.order));
    side.stride = int(
        reader.whole_number(group + ".stride", 1, nmbcgen::highest_count).value_or(side.stride));
    if (reader.has(group + ".absorb")) {
        side.absorb = read_waves(reader, group + ".absorb");
    }
    side.as_printed = reader.truth(group + ".as_printed").value_or(side.as_printed);
    side.is_odd = reader.truth(group + ".odd").value_or(side.is_odd);
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
         {"order", "stride", "as_printed", "absorb", "odd", "layer", "profile", "target"}) {
        const std::string key = fmt::format("{}.{}", group, name);
        const bool is_idle = std::ranges::none_of(
            sides, [&](const PlaneSideChoice& side) { return counts(name, side.kind); });
        if (is_idle && reader.has(key) && (reader.is_overridden(key) || !kind_is_overridden)) {
            reader.fail(key, fmt::format("does not count for kind \"{}\"", name_of(sides[0].kind)));
        }
    }
}

/// The table that says of which kind a side is.
std::string group_of_kind(SceneReader& reader, std::size_t side) {
    const std::string own = fmt::format("boundary.{}", plane_side_names[side]);
    return reader.has(own + ".kind") ? own : "boundary";
}

/// Names all that perfectly matched layers need at once.
void require_matched_layers(SceneReader& reader, const PlaneScene& scene) {
    std::string first;
    std::vector<std::string> missing_keys;
    for (std::size_t i = 0; i < scene.sides.size(); ++i) {
        if (scene.sides[i].kind == SideKind::pml) {
            const std::string group = group_of_kind(reader, i);
            const std::string key = group + ".layer";
            first = first.empty() ? group : first;
            if (scene.sides[i].layer == 0 &&
                std::ranges::find(missing_keys, key) == missing_keys.end()) {
                missing_keys.push_back(key);
            }
        }
    }
    if (const std::string lack = lack_of_matched_layers(scene, missing_keys); !lack.empty()) {
        reader.fail(first, "has a pml: " + lack);
    }
}

/// They share one design, and with it the null Lagrangian of the body.
void require_like_passive_sides(SceneReader& reader, const PlaneScene& scene) {
    std::optional<std::size_t> layers;
    for (const PlaneSideChoice& side : scene.sides) {
        if (side.kind == SideKind::passive && layers.value_or(side.layer) != side.layer) {
            reader.fail("boundary", "has passive sides of unlike boundary.layer: they share one");
        }
        layers = side.kind == SideKind::passive ? side.layer : layers;
    }
    if (layers.value_or(0) == 0) {
        return;
    }
    try {
        nmbcgen::side_layers_checked({.radius_squared = scene.radius_squared}, *layers);
    } catch (const std::invalid_argument& reason) {
        reader.fail("boundary.layer", std::string("does not fit: ") + reason.what());
    }
}

}  // namespace

void read_plane_sides(SceneReader& reader, PlaneScene& scene) {
    scene.allow_unstable = reader.truth("boundary.allow_unstable").value_or(false);
    const PlaneSideChoice all = read_side(reader, "boundary", {});
    for (std::size_t i = 0; i < scene.sides.size(); ++i) {
        scene.sides[i] = read_side(reader, fmt::format("boundary.{}", plane_side_names[i]), all);
    }
    refuse_idle_keys(reader, "boundary", scene.sides);
    require_matched_layers(reader, scene);
    for (std::size_t i = 0; i < scene.sides.size(); ++i) {
        const std::string group = fmt::format("boundary.{}", plane_side_names[i]);
        refuse_idle_keys(reader, group, {&scene.sides[i], 1});
        const PlaneSideChoice& side = scene.sides[i];
        if (has_layer(side.kind) && side.layer == 0) {
            const std::string whose = group_of_kind(reader, i);
            reader.fail(whose, fmt::format("has a {}, which needs {}.layer, its nodes",
                                           name_of(side.kind), whose));
        }
        if (side.kind == SideKind::nmbc && side.order > 1 && scene.tau != 0) {
            reader.fail("boundary.order",
                        "must be 1 beside model.damping: higher ones are matched to lattices "
                        "without it, and are none of such order here");
        }
        if (side.as_printed && (side.order != 1 || side.stride != 1)) {
            reader.fail("boundary",
                        "has as_printed, which is (81), beside another order or stride than 1");
        }
    }
    require_like_passive_sides(reader, scene);
    for (const std::size_t low : {0U, 2U}) {
        if ((scene.sides[low].kind == SideKind::periodic) !=
            (scene.sides[low + 1].kind == SideKind::periodic)) {
            reader.fail("boundary", fmt::format("has a periodic side opposite one that is not: {} "
                                                "and {} have to be periodic both, or neither",
                                                plane_side_names[low], plane_side_names[low + 1]));
        }
    }
}

}  // namespace nmbcrun
