// SPDX-License-Identifier: GPL-2.0-or-later
#include "tools/stability_atlas/choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nmbc/certificate.hpp>
#include <nmbc/tables/tables.hpp>

namespace stability_atlas {
namespace {

std::string cell(const nmbc::MatchingTable& table, double G) {
    const nmbc::Grade grade = nmbc::certified_grade(table, G);
    const double cfl = nmbc::certified_cfl(table, G);
    if (grade == nmbc::Grade::none || cfl == 0) {
        return "";
    }
    const double any = nmbc::certified_cfl(table, G, nmbc::Opposite::any);
    if (any == 0) {
        return fmt::format("{:.2f}", cfl);
    }
    return any < cfl ? fmt::format("{:.2f}, **{:.2f}**", cfl, any) : fmt::format("**{:.2f}**", cfl);
}

std::vector<const nmbc::MatchingTable*> tables_of(const std::vector<unsigned>& horizons) {
    std::vector<const nmbc::MatchingTable*> found;
    for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
        if (table->lattice->family == "nopd1d" &&
            std::ranges::count(horizons, unsigned(table->lattice->horizon)) > 0) {
            found.push_back(table);
        }
    }
    // Stable: of one lattice and condition the committed set has tau ascending.
    std::ranges::stable_sort(found, {}, [](const nmbc::MatchingTable* table) {
        return std::array{table->lattice->horizon, table->order, table->stride,
                          table->time_step == "0" ? 0 : 1};
    });
    return found;
}

}  // namespace

std::string choices(const std::vector<unsigned>& horizons, const std::vector<double>& values) {
    std::string text = "| n | order | stride | tau | dt |";
    std::string rule = "|--:|------:|-------:|----:|---:|";
    for (const double G : values) {
        text += fmt::format(" G = {:g} |", G);
        rule += "------:|";
    }
    text += "\n" + rule + "\n";
    for (const nmbc::MatchingTable* table : tables_of(horizons)) {
        text += fmt::format("| {} | {} | {} | {} | {} |", table->lattice->horizon, table->order,
                            table->stride, table->lattice->tau,
                            table->time_step == "0" ? "" : table->time_step);
        for (const double G : values) {
            text += fmt::format(" {} |", cell(*table, G));
        }
        text += "\n";
    }
    return text;
}

}  // namespace stability_atlas
