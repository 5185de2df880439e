// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/side_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace nmbcrun {
namespace {

/// "P at 30 and S at 60 degrees"
std::string text_of_waves(const std::vector<ObliqueWave>& waves) {
    std::string text;
    for (const ObliqueWave& wave : waves) {
        text += fmt::format("{}{} at {:g}", text.empty() ? "" : " and ", wave.is_P ? 'P' : 'S',
                            wave.degrees);
    }
    return text + " degrees";
}

}  // namespace

const std::vector<std::pair<std::string_view, SideKind>>& side_kinds() {
    static const std::vector<std::pair<std::string_view, SideKind>> kinds{
        {"passive", SideKind::passive},   {"fixed", SideKind::fixed},
        {"free", SideKind::free},         {"sbp", SideKind::sbp},
        {"kernel", SideKind::kernel},     {"mirror", SideKind::mirror},
        {"periodic", SideKind::periodic}, {"extended", SideKind::extended},
        {"nmbc", SideKind::nmbc},         {"higdon", SideKind::higdon},
        {"sponge", SideKind::sponge},     {"pml", SideKind::pml}};
    return kinds;
}

std::string_view name_of(SideKind kind) {
    return std::ranges::find(side_kinds(), kind, &std::pair<std::string_view, SideKind>::second)
        ->first;
}

bool may_grow(SideKind kind) {
    return kind == SideKind::nmbc || kind == SideKind::higdon || kind == SideKind::pml;
}

bool has_layer(SideKind kind) {
    return kind == SideKind::sponge || kind == SideKind::pml;
}

bool is_closed(SideKind kind) {
    return kind == SideKind::sbp || kind == SideKind::kernel;
}

bool ends_body(SideKind kind) {
    return is_closed(kind) || kind == SideKind::free;
}

bool is_artificial(SideKind kind) {
    return !ends_body(kind) && kind != SideKind::fixed && kind != SideKind::mirror &&
           kind != SideKind::periodic;
}

std::string heading_of(const PlaneSideChoice& side) {
    switch (side.kind) {
        case SideKind::nmbc:
            return side.as_printed
                       ? std::string("NMBC1 as printed, (81)")
                       : fmt::format("NMBC{} by component, stride {}", side.order, side.stride);
        case SideKind::higdon:
            return "higdon for " + text_of_waves(side.absorb);
        case SideKind::sbp:
            return "summation by parts";
        case SideKind::kernel:
            return "convex kernels";
        case SideKind::mirror:
            return side.is_odd ? "odd mirror" : "mirror";
        case SideKind::sponge:
        case SideKind::pml:
            return fmt::format("{} of {} nodes, profile {}, target {}", name_of(side.kind),
                               side.layer, side.profile, side.target);
        case SideKind::passive:
            return side.layer == 0 ? "passive" : fmt::format("passive of {} layers", side.layer);
        default:
            return std::string(name_of(side.kind));
    }
}

}  // namespace nmbcrun
