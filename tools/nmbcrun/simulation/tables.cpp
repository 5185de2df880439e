// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nmbc/tables/tables.hpp>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"

namespace nmbcrun {

const nmbc::MatchingTable& table_of(const Scene& scene, const Boundary& boundary) {
    const bool matching = takes_table(boundary.kind);
    const auto* const found =
        std::ranges::find_if(nmbc::generated::tables, [&](const nmbc::MatchingTable* table) {
            return table->family == scene.family && table->horizon == scene.horizon &&
                   table->tau == scene.tau &&
                   (!matching ||
                    (table->order == boundary.order && table->stride == boundary.stride &&
                     table->time_step == boundary.matched_step));
        });
    if (found != std::end(nmbc::generated::tables)) {
        return **found;
    }
    std::string known;
    for (const auto* other : nmbc::generated::tables) {
        known += fmt::format(" {}", other->name);
    }
    throw SceneError(fmt::format(
        "nmbcrun has no table for family {}, horizon {}{}{}{}; it knows the committed set (others: "
        "docs/example):{}",
        scene.family, scene.horizon,
        matching ? fmt::format(", order {}, stride {}", boundary.order, boundary.stride) : "",
        matching && boundary.matched_step != "0"
            ? fmt::format(", matched_step {}", boundary.matched_step)
            : "",
        scene.tau == "0" ? "" : fmt::format(", damping tau = {}", scene.tau), known));
}

}  // namespace nmbcrun
