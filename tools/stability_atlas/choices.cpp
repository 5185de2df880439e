// SPDX-License-Identifier: GPL-2.0-or-later
#include "tools/stability_atlas/choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nmbc/tables/tables.hpp>
#include <span>

namespace stability_atlas {
namespace {

bool any_contains(std::span<const nmbc::Window> windows, double G) {
    return std::ranges::any_of(windows,
                               [G](const nmbc::Window& window) { return window.contains(G); });
}

/// The larger one where two pieces meet: each holds at its ends.
double largest_cfl(const nmbc::MatchingTable& table, double G) {
    double cfl = 0;
    for (const nmbc::StableStep& step : table.max_cfl) {
        if (step.window.contains(G)) {
            cfl = std::max(cfl, step.cfl);
        }
    }
    return cfl;
}

std::string cell(const nmbc::MatchingTable& table, double G) {
    if (!any_contains(table.modal, G)) {
        return "";
    }
    const char* const mark = any_contains(table.contractive, G) ? "**" : "";
    return fmt::format("{}{:.2f}{}", mark, largest_cfl(table, G), mark);
}

std::vector<const nmbc::MatchingTable*> tables_of(const std::vector<unsigned>& horizons) {
    std::vector<const nmbc::MatchingTable*> found;
    for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
        if (std::ranges::count(horizons, unsigned(table->horizon)) > 0) {
            found.push_back(table);
        }
    }
    std::ranges::sort(found, {}, [](const nmbc::MatchingTable* table) {
        return std::array{table->horizon, table->order, table->stride};
    });
    return found;
}

}  // namespace

std::string choices(const std::vector<unsigned>& horizons, const std::vector<double>& values) {
    std::string text = "| n | order | stride |";
    std::string rule = "|--:|------:|-------:|";
    for (const double G : values) {
        text += fmt::format(" G = {:g} |", G);
        rule += "------:|";
    }
    text += "\n" + rule + "\n";
    for (const nmbc::MatchingTable* table : tables_of(horizons)) {
        text += fmt::format("| {} | {} | {} |", table->horizon, table->order, table->stride);
        for (const double G : values) {
            text += fmt::format(" {} |", cell(*table, G));
        }
        text += "\n";
    }
    return text;
}

}  // namespace stability_atlas
