// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nmbc/tables/tables.hpp>
#include <set>
#include <string_view>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"

namespace nmbcrun {

namespace {

void require_stabilisation(const nmbc::MatchingTable& table, double G) {
    const bool is_stabilised = std::ranges::find(table.energy, nmbc::EnergyPart::stabilisation,
                                                 &nmbc::EnergySquare::part) != table.energy.end();
    if (G != 0 && !is_stabilised) {
        throw SceneError(fmt::format(
            "the lattice of family {} has no stabilisation: model.G must be absent or 0, not {}",
            table.family, G));
    }
}

/// Of the scene's family and horizon, or else which of those there are.
std::string what_there_is(const Scene& scene) {
    std::string names;
    std::map<std::string_view, std::set<int>> horizons;
    for (const auto* table : nmbc::generated::tables) {
        horizons[table->family].insert(table->horizon);
        if (table->family == scene.family && table->horizon == scene.horizon) {
            names += (names.empty() ? "" : ", ") + std::string(table->name);
        }
    }
    if (!names.empty()) {
        return "of this family and horizon there are " + names;
    }
    std::string families;
    for (const auto& [family, list] : horizons) {
        families += fmt::format("{}{} with horizon {}", families.empty() ? "" : ", ", family,
                                fmt::join(list, ", "));
    }
    return "there is nothing of this family and horizon, but " + families;
}

}  // namespace

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
        require_stabilisation(**found, scene.G);
        return **found;
    }
    throw SceneError(fmt::format(
        "nmbcrun has no table for family {}, horizon {}{}{}{}; it knows the committed set (others: "
        "docs/example), in which {}",
        scene.family, scene.horizon,
        matching ? fmt::format(", order {}, stride {}", boundary.order, boundary.stride) : "",
        matching && boundary.matched_step != "0"
            ? fmt::format(", matched_step {}", boundary.matched_step)
            : "",
        scene.tau == "0" ? "" : fmt::format(", damping tau = {}", scene.tau),
        what_there_is(scene)));
}

nmbc::Lattice lattice_of(const Scene& scene) {
    return nmbc::make_lattice(table_of(scene, {.kind = BoundaryKind::fixed}), scene.G);
}

}  // namespace nmbcrun
