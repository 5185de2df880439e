// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/tables/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nmbc/coefficients.hpp>
#include <nmbc/tables/tables.hpp>
#include <set>
#include <string_view>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/tables/making_command.hpp"

namespace nmbcrun {

namespace {

void require_stabilisation(const nmbc::MatchingTable& table, double G) {
    const auto energy = table.lattice->energy;
    const bool is_stabilised = std::ranges::find(energy, nmbc::EnergyPart::stabilisation,
                                                 &nmbc::EnergySquare::part) != energy.end();
    if (G != 0 && !is_stabilised) {
        throw SceneError(why_no_G(table.lattice->family, G));
    }
}

/// Calls use(table) for the scene's own tables and the committed ones, in this order, as far as
/// they have its influence.
template <class Use>
void for_each_of_the_influence(const Scene& scene, Use use) {
    const std::string weights = fmt::format("{}", fmt::join(scene.weights, ","));
    for (const auto& file : scene.own_tables) {
        for (const OwnTable& own : file->tables()) {
            if (own.table.lattice->weights == weights) {
                use(own.table);
            }
        }
    }
    if (scene.weights.empty()) {
        for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
            use(*table);
        }
    }
}

bool is_for(const nmbc::MatchingTable& table, const Scene& scene) {
    return table.lattice->family == scene.family && table.lattice->horizon == scene.horizon &&
           table.lattice->tau == scene.tau &&
           (table.fixed_G.empty() || nmbc::detail::nearest_to_fraction(table.fixed_G) == scene.G);
}

/// Whether a Boundary cannot tell the one from the other.
bool is_same_choice(const nmbc::MatchingTable& one, const nmbc::MatchingTable& other) {
    return one.order == other.order && one.stride == other.stride &&
           one.time_step == other.time_step;
}

void require_one_lattice(const nmbc::MatchingTable& one, const nmbc::MatchingTable& other) {
    if (!is_same_lattice(*one.lattice, *other.lattice)) {
        throw SceneError(fmt::format(
            "the tables {} and {} are of different lattices: their symbols differ, though both are "
            "of {}",
            one.name, other.name, one.lattice->name));
    }
}

void require_settled(const Scene& scene) {
    if (scene.auto_horizon || scene.auto_G) {
        throw SceneError(
            fmt::format("{} is \"auto\", which advise and run --tolerance choose "
                        "(docs/how-to/meet-a-tolerance.md): give a "
                        "number, such as one of the settings that advise prints",
                        scene.auto_horizon ? "model.horizon" : "model.G"));
    }
}

/// Of the scene's family, which nmbcgen need not know then.
bool has_own_table(const Scene& scene) {
    return std::ranges::any_of(scene.own_tables, [&](const auto& file) {
        return std::ranges::any_of(file->tables(), [&](const OwnTable& own) {
            return own.table.lattice->family == scene.family;
        });
    });
}

/// Of the scene's family, horizon and influence, or else which of those there are.
std::string what_there_is(const Scene& scene) {
    std::string names;
    std::set<std::string_view> families;
    std::set<int> horizons;  // of its own
    for_each_of_the_influence(scene, [&](const nmbc::MatchingTable& table) {
        families.insert(table.lattice->family);
        if (table.lattice->family != scene.family) {
            return;
        }
        horizons.insert(table.lattice->horizon);
        if (table.lattice->horizon == scene.horizon) {
            names += (names.empty() ? "" : ", ") + std::string(table.name);
        }
    });
    if (!names.empty()) {
        return "of this family and horizon there are " + names;
    }
    if (!horizons.empty()) {
        return fmt::format("there are the horizons {} of this family", fmt::join(horizons, ", "));
    }
    return families.empty() ? "there is nothing of this influence"
                            : fmt::format("there are, of this influence, the families {}",
                                          fmt::join(families, ", "));
}

/// Whether both have the same coefficients at G, to roundings.
bool is_same_condition(const nmbc::MatchingTable& one, const nmbc::MatchingTable& other, double G) {
    const auto alike = [](double a, double b) {
        constexpr double roundings = 1e-12;
        return std::abs(a - b) <= roundings * (1 + std::abs(a));
    };
    const auto of_one = nmbc::boundary_coefficients(one, G, nmbc::allow_unstable);
    const auto of_other = nmbc::boundary_coefficients(other, G, nmbc::allow_unstable);
    return std::ranges::equal(of_one.c, of_other.c, alike) &&
           std::ranges::equal(of_one.b, of_other.b, alike);
}

}  // namespace

std::string in_place_of_committed(const Scene& scene, const Boundary& boundary) {
    const nmbc::MatchingTable& own = table_of(scene, boundary);
    for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
        if (table != &own && is_for(*table, scene) && is_same_choice(*table, own) &&
            table->lattice->weights == own.lattice->weights &&
            !is_same_condition(own, *table, scene.G)) {
            return fmt::format(
                "{} of model.tables takes the place of the committed {}, whose "
                "coefficients are others",
                own.name, table->name);
        }
    }
    return {};
}

std::vector<const nmbc::MatchingTable*> tables_of(const Scene& scene) {
    std::vector<const nmbc::MatchingTable*> tables;
    for_each_of_the_influence(scene, [&](const nmbc::MatchingTable& table) {
        const auto is_known = [&](const auto* other) { return is_same_choice(table, *other); };
        if (!is_for(table, scene) || std::ranges::any_of(tables, is_known)) {
            return;
        }
        if (tables.empty()) {
            require_stabilisation(table, scene.G);
        } else if (!scene.own_tables.empty()) {
            require_one_lattice(*tables.front(), table);
        }
        tables.push_back(&table);
    });
    return tables;
}

std::vector<int> horizons_of(const Scene& scene) {
    std::set<int> horizons;
    for_each_of_the_influence(scene, [&](const nmbc::MatchingTable& table) {
        if (table.lattice->family == scene.family && table.lattice->tau == scene.tau) {
            horizons.insert(table.lattice->horizon);
        }
    });
    return {horizons.begin(), horizons.end()};
}

const nmbc::MatchingTable& table_of(const Scene& scene, const Boundary& boundary) {
    require_settled(scene);
    const bool matching = takes_table(boundary.kind);
    const auto tables = tables_of(scene);
    const auto found = std::ranges::find_if(tables, [&](const nmbc::MatchingTable* table) {
        return !matching || (table->order == boundary.order && table->stride == boundary.stride &&
                             table->time_step == boundary.matched_step);
    });
    if (found != tables.end()) {
        return **found;
    }
    const std::string why = why_no_lattice(scene);
    if (!why.empty() && !has_own_table(scene)) {
        throw SceneError(why);
    }
    throw SceneError(fmt::format(
        "nmbcrun has no table for family {}, horizon {}{}{}{}{}{}. It knows the committed "
        "set{}, in which {}",
        scene.family, scene.horizon,
        scene.weights.empty() ? "" : fmt::format(", influence {}", fmt::join(scene.weights, ", ")),
        matching ? fmt::format(", order {}, stride {}", boundary.order, boundary.stride) : "",
        matching && boundary.matched_step != "0"
            ? fmt::format(", matched_step {}", boundary.matched_step)
            : "",
        scene.tau == "0" ? "" : fmt::format(", damping tau = {}", scene.tau),
        why.empty()               ? how_to_make(scene, boundary)
        : is_family(scene.family) ? ": " + why
                                  : "",
        scene.own_tables.empty() ? "" : " and those of model.tables", what_there_is(scene)));
}

const TableFile* uncertified_file(const Scene& scene, const nmbc::MatchingTable& table) {
    for (const auto& file : scene.own_tables) {
        for (const OwnTable& own : file->tables()) {
            if (&own.table == &table && !own.is_certified) {
                return file.get();
            }
        }
    }
    return nullptr;
}

nmbc::Lattice lattice_of(const Scene& scene) {
    return nmbc::make_lattice(table_of(scene, {.kind = BoundaryKind::fixed}), scene.G);
}

}  // namespace nmbcrun
