// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane_compare/side_candidates.hpp"

#include <fmt/format.h>

namespace nmbcrun {

std::vector<SideCandidate> side_candidates(const PlaneScene& scene) {
    std::vector<SideCandidate> all{
        {"passive", {.kind = SideKind::passive}},
        {"higdon", {.kind = SideKind::higdon}},
        {"NMBC1", {.kind = SideKind::nmbc}},
        {"(81)", {.kind = SideKind::nmbc, .as_printed = true}},
    };
    if (!scene.is_bond_based()) {
        const auto horizon = int(nmbc::horizon_of(scene.radius_squared));
        all.push_back({"NMBC2", {.kind = SideKind::nmbc, .order = 2, .stride = horizon}});
    }
    for (const SideKind kind : {SideKind::sponge, SideKind::pml, SideKind::extended}) {
        for (const std::size_t layer : {5U, 10U, 20U, 40U}) {
            if (kind != SideKind::pml || !scene.is_bond_based()) {
                all.push_back(
                    {fmt::format("{} {}", name_of(kind), layer), {.kind = kind, .layer = layer}});
            }
        }
    }
    all.push_back({"extended", {.kind = SideKind::extended}});
    all.push_back({"free", {.kind = SideKind::free}});
    all.push_back({"fixed", {.kind = SideKind::fixed}});
    return all;
}

PlaneScene with_sides(PlaneScene scene, const PlaneSideChoice& side) {
    scene.allow_unstable = true;
    for (PlaneSideChoice& one : scene.sides) {
        if (is_artificial(one.kind)) {
            one = side;
        }
    }
    return scene;
}

}  // namespace nmbcrun
