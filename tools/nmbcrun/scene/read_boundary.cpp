// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/read_boundary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "generator/table/table.hpp"
#include "tools/nmbcrun/scene/boundary.hpp"
#include "tools/nmbcrun/scene/read_choice.hpp"
#include "tools/nmbcrun/scene/read_exact.hpp"
#include "tools/nmbcrun/scene/read_sources.hpp"

namespace nmbcrun {

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

Boundary read_boundary(SceneReader& reader, const std::string& group, const Boundary& others) {
    const auto kind = read_choice(reader, group + ".kind", boundary_kinds());
    const auto order = reader.whole_number(group + ".order", 1, nmbcgen::highest_count);
    const auto stride = reader.whole_number(group + ".stride", 1, nmbcgen::highest_count);
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

}  // namespace nmbcrun
