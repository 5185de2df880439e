// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/coupling.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "generator/commands/coupling_junction.hpp"
#include "generator/commands/coupling_waves.hpp"
#include "generator/coupling/equilibrium.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

using Json = nlohmann::ordered_json;

/// A patch test of two bars.
struct Patch {
    unsigned of_case;
    std::string what;
    Halves halves;
};

std::vector<Patch> patches() {
    const Medium wide{1, Rational(3, 2)};
    std::vector<Patch> all{{3, "3/2 | 3/4, h = 1", {1, 1, wide, {1, Rational(3, 4)}}},
                           {3, "3/2 | local, h = 1", {1, 1, wide, {1, 0}}}};
    for (const int length : {1, 2, 4}) {
        all.push_back({4, fmt::format("3/2, h = 1 | {}", length), {1, length, wide, wide}});
    }
    return all;
}

std::vector<Rational> load_horizons() {
    return {Rational(1, 5), Rational(1, 10), Rational(1, 20), Rational(1, 40)};
}

std::vector<Rational> interface_horizons() {
    return {Rational(1, 5), Rational(1, 10), Rational(1, 20)};
}

std::string cases_text() {
    std::string text = fmt::format(
        "cases       Seleson 2011, part IV: linear elements, u = 0 or the local bar's beyond the "
        "bar\n\n"
        "case 1      unit load at 1/2 of a unit bar, k = 1, h = 1/{}: u(1/2), of the local bar "
        "0.25\n"
        "horizon     u\n",
        unit_bar_elements);
    for (const Rational& horizon : load_horizons()) {
        text += fmt::format("{:<12}{:.6f}\n", to_string(horizon), displacement_at_load(horizon));
    }
    text += fmt::format(
        "\ncase 2      k = 1 | 2, meeting at 1/2, h = 1/{}: largest |u - local|\n"
        "horizon     pairs         rows\n",
        unit_bar_elements);
    for (const Rational& horizon : interface_horizons()) {
        text += fmt::format("{:<12}{:<14.6f}{:.6f}\n", to_string(horizon),
                            material_interface_error(horizon, CouplingForm::pairs),
                            material_interface_error(horizon, CouplingForm::rows));
    }
    text += fmt::format(
        "\ncases 3, 4  patch test, {} elements on either side: largest |u - x|; 0 is exact\n"
        "case        horizon                 pairs         rows\n",
        patch_elements);
    for (const Patch& patch : patches()) {
        text += fmt::format("{:<12}{:<24}{:<14.6g}{:.6g}\n", patch.of_case, patch.what,
                            patch_error(patch.halves, CouplingForm::pairs),
                            patch_error(patch.halves, CouplingForm::rows));
    }
    return text;
}

Json cases_json() {
    Json loads = Json::array();
    for (const Rational& horizon : load_horizons()) {
        loads.push_back(
            {{"horizon", to_string(horizon)}, {"displacement", displacement_at_load(horizon)}});
    }
    Json interfaces = Json::array();
    for (const Rational& horizon : interface_horizons()) {
        interfaces.push_back({{"horizon", to_string(horizon)},
                              {"pairs", material_interface_error(horizon, CouplingForm::pairs)},
                              {"rows", material_interface_error(horizon, CouplingForm::rows)}});
    }
    Json tests = Json::array();
    for (const Patch& patch : patches()) {
        const Halves& bars = patch.halves;
        tests.push_back(
            {{"case", patch.of_case},
             {"horizons", {to_string(bars.left.horizon), to_string(bars.right.horizon)}},
             {"lengths", {to_string(bars.left_length), to_string(bars.right_length)}},
             {"pairs", patch_error(bars, CouplingForm::pairs)},
             {"rows", patch_error(bars, CouplingForm::rows)}});
    }
    return {
        {"coupling", "cases"}, {"case_1", loads}, {"case_2", interfaces}, {"patch_tests", tests}};
}

Halves halves_of(const CouplingTask& task) {
    return {1, task.other_length, {1, task.horizon}, {1, task.other_horizon}};
}

}  // namespace

std::string coupling_text(const CouplingTask& task) {
    switch (task.part) {
        case CouplingPart::stencil:
            return stencil_text(task.horizon);
        case CouplingPart::junction:
            return junction_text(halves_of(task));
        case CouplingPart::cases:
            return cases_text();
        case CouplingPart::waves:
            return waves_text(waves_over(halves_of(task)));
    }
    return {};
}

std::string coupling_json(const CouplingTask& task) {
    switch (task.part) {
        case CouplingPart::stencil:
            return stencil_json(task.horizon);
        case CouplingPart::junction:
            return junction_json(halves_of(task));
        case CouplingPart::cases:
            return cases_json().dump(2) + "\n";
        case CouplingPart::waves:
            return waves_json(waves_over(halves_of(task)));
    }
    return {};
}

}  // namespace nmbcgen
