// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/coupling_junction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "generator/commands/coupling.hpp"
#include "generator/coupling/assembly.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::pair<CouplingForm, const char*> named_forms[] = {{CouplingForm::pairs, "pairs"},
                                                                {CouplingForm::rows, "rows"}};

std::string exact_text(const LogNumber& number) {
    constexpr std::size_t readable = 1500;
    std::string exact = to_string(number);
    return exact.size() > readable ? "too long to read" : exact;
}

Json entry_json(const LogNumber& entry) {
    Json logs = Json::object();
    for (const auto& [prime, coefficient] : entry.of_log) {
        logs[std::to_string(prime)] = to_string(coefficient);
    }
    return {{"rational", to_string(entry.rational)},
            {"of_log", logs},
            {"value", nearest_double(entry)}};
}

/// Nodes are numbered from that of the junction, 0.
struct JunctionRow {
    int node;
    std::map<int, LogNumber> entries;
};

/// Of a node of a uniform bar far from its ends, by the distance of columns.
std::map<int, LogNumber> row_inside(const Rational& length, const Medium& medium) {
    const std::vector<LogNumber> stencil = uniform_stencil(medium.horizon / length);
    std::map<int, LogNumber> row;
    for (int m = 0; m < int(stencil.size()); ++m) {
        const LogNumber entry = medium.stiffness / length * stencil[std::size_t(m)];
        row[m] = entry;
        row[-m] = entry;
    }
    return row;
}

/// Of the nodes beside the junction those whose row is not that of a node inside either bar.
std::vector<JunctionRow> junction_rows(const Halves& halves, CouplingForm form) {
    const Rational widest = std::max(halves.left.horizon, halves.right.horizon);
    const auto within = [](const Rational& length, const Rational& of_element) {
        return (-floor(-length / of_element)).convert_to<int>();
    };
    // Of a node's elements and of those that they reach, some may be the other bar's.
    const int first = -within(widest, halves.left_length);
    const int last = within(widest, halves.right_length);
    const auto elements = [&](const Rational& of_element) {
        return static_cast<std::size_t>(within(2 * widest, of_element) + 2);
    };
    const int before = int(elements(halves.left_length));
    const Mesh mesh = mesh_of(halves, std::size_t(before), elements(halves.right_length));
    const std::vector<ExactRow> all =
        exact_rows(mesh, form, std::size_t(before + first), std::size_t(before + last));
    const auto inside_left = row_inside(halves.left_length, halves.left);
    const auto inside_right = row_inside(halves.right_length, halves.right);
    std::vector<JunctionRow> rows;
    for (int node = first; node <= last; ++node) {
        JunctionRow row{node, {}};
        std::map<int, LogNumber> by_distance;
        for (const auto& [column, entry] : all[std::size_t(node - first)]) {
            row.entries.emplace(int(column) - before, entry);
            by_distance.emplace(int(column) - before - node, entry);
        }
        if (by_distance != inside_left && by_distance != inside_right) {
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

std::string horizon_text(const Medium& medium) {
    return medium.horizon == 0 ? "local" : to_string(medium.horizon) + " h";
}

}  // namespace

std::string stencil_text(const Rational& horizon) {
    std::string text = fmt::format("stencil     {}, horizon {} h\nunits       k/h\n\n",
                                   coupling_source, to_string(horizon));
    const std::vector<LogNumber> stencil = uniform_stencil(horizon);
    for (std::size_t m = 0; m < stencil.size(); ++m) {
        text += fmt::format("{:<4}{:< 24.17g}{}\n", m, nearest_double(stencil[m]),
                            exact_text(stencil[m]));
    }
    return text;
}

std::string stencil_json(const Rational& horizon) {
    Json entries = Json::array();
    for (const LogNumber& entry : uniform_stencil(horizon)) {
        entries.push_back(entry_json(entry));
    }
    const Json json{{"coupling", "stencil"}, {"horizon", to_string(horizon)}, {"stencil", entries}};
    return json.dump(2) + "\n";
}

std::string junction_text(const Halves& halves) {
    std::string text = fmt::format(
        "junction    {}, on the right {} h\nhorizons    {} | {}\n"
        "units       k/h; nodes from the one where the bars meet, 0\n",
        coupling_source, to_string(halves.right_length), horizon_text(halves.left),
        horizon_text(halves.right));
    for (const auto& [form, name] : named_forms) {
        const std::vector<JunctionRow> rows = junction_rows(halves, form);
        if (rows.empty()) {
            text += fmt::format("\n{}: none, each row is one of a bar's own\n", name);
            continue;
        }
        text += fmt::format("\n{:<8}column\n", name);
        for (const JunctionRow& row : rows) {
            for (const auto& [column, entry] : row.entries) {
                text += fmt::format("{:<8}{:<8}{:< 24.17g}{}\n", row.node, column,
                                    nearest_double(entry), exact_text(entry));
            }
        }
    }
    return text;
}

std::string junction_json(const Halves& halves) {
    Json json{{"coupling", "junction"},
              {"horizons", {to_string(halves.left.horizon), to_string(halves.right.horizon)}},
              {"lengths", {to_string(halves.left_length), to_string(halves.right_length)}}};
    for (const auto& [form, name] : named_forms) {
        Json rows = Json::array();
        for (const JunctionRow& row : junction_rows(halves, form)) {
            Json entries = Json::array();
            for (const auto& [column, entry] : row.entries) {
                Json one = entry_json(entry);
                one["column"] = column;
                entries.push_back(std::move(one));
            }
            rows.push_back({{"node", row.node}, {"entries", std::move(entries)}});
        }
        json[name] = std::move(rows);
    }
    return json.dump(2) + "\n";
}

}  // namespace nmbcgen
