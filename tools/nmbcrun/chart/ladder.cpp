// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/ladder.hpp"

#include <fmt/format.h>

#include <nmbc/tables/tables.hpp>

namespace nmbcrun {

std::vector<Rung> ladder(const Scene& scene) {
    std::vector<Rung> rungs{{"fixed", {.kind = BoundaryKind::fixed}},
                            {"free", {.kind = BoundaryKind::free}}};
    for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
        if (table->family == scene.family && table->horizon == scene.horizon &&
            table->tau == scene.tau && table->time_step == "0") {
            rungs.push_back({fmt::format("NMBC{} s{}", table->order, table->stride),
                             {.order = table->order, .stride = table->stride}});
        }
    }
    return rungs;
}

Scene with_ends(Scene scene, const Boundary& boundary) {
    scene.left = boundary;
    scene.right = boundary;
    scene.allow_unstable = true;
    return scene;
}

}  // namespace nmbcrun
