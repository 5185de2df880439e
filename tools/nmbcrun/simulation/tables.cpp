// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
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

void require_settled(const Scene& scene) {
    if (scene.auto_horizon || scene.auto_G) {
        throw SceneError(fmt::format(
            "{} is \"auto\", which advise and run --tolerance choose (docs/advise.md): give a "
            "number, such as one of the settings that advise prints",
            scene.auto_horizon ? "model.horizon" : "model.G"));
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
    require_settled(scene);
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

std::vector<const nmbc::MatchingTable*> tables_of(const Scene& scene) {
    std::vector<const nmbc::MatchingTable*> tables;
    std::ranges::copy_if(nmbc::generated::tables, std::back_inserter(tables),
                         [&](const nmbc::MatchingTable* table) {
                             return table->family == scene.family &&
                                    table->horizon == scene.horizon && table->tau == scene.tau;
                         });
    return tables;
}

std::vector<int> horizons_of(const Scene& scene) {
    std::set<int> horizons;
    for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
        if (table->family == scene.family && table->tau == scene.tau) {
            horizons.insert(table->horizon);
        }
    }
    return {horizons.begin(), horizons.end()};
}

nmbc::Lattice lattice_of(const Scene& scene) {
    return nmbc::make_lattice(table_of(scene, {.kind = BoundaryKind::fixed}), scene.G);
}

}  // namespace nmbcrun
