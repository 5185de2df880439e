// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/bonds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "generator/bonds/chain_bonds.hpp"
#include "generator/bonds/contour_bonds.hpp"
#include "generator/bonds/square_bonds.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rounded_text.hpp"
#include "generator/families/bond_lattice.hpp"
#include "generator/families/family.hpp"
#include "generator/families/influence.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
namespace {

constexpr const char* given = "given";

/// Coefficients that were given.
std::vector<BondCoefficient> as_given(const std::vector<Rational>& alpha) {
    std::vector<BondCoefficient> coefficients(alpha.size());
    std::ranges::transform(alpha, coefficients.begin(), rational_coefficient);
    return coefficients;
}

using Json = nlohmann::ordered_json;

struct Bond {
    std::string name;
    Json key;  ///< the name in JSON
    BondCoefficient alpha;
    std::string weight;  ///< of bond1d or bond2d
};

/// What both outputs say.
struct Report {
    std::string lattice;
    std::string_view method_name;
    std::string method;
    std::string_view model;  ///< what alpha scales
    std::vector<Bond> bonds{};
    std::string family{};   ///< the options of nmbcgen for this lattice, but for --weights
    std::string refusal{};  ///< why other commands refuse it; empty: they do not
    bool is_stable = false;
    double residual_over_original = 0;
    double largest_frequency = 0;
    double chain_speed = 0;                     ///< of long waves, of a chain
    std::array<double, 2> chain_speed_error{};  ///< at listed_wave_numbers, likewise
    std::optional<SquareFigures> square{};
};

/// The shortest decimals, without an exponent, that this double is nearest to; 0 where nmbcgen
/// would not read as many.
std::string decimals_of(double value) {
    constexpr int most = 38;
    for (int places = 1; places <= most; ++places) {
        std::string text = fmt::format("{:.{}f}", value, places);
        if (std::stod(text) == value) {
            return text;
        }
    }
    return "0";
}

std::vector<Rational> weights_of(const Report& report) {
    std::vector<Rational> weights;
    for (const Bond& bond : report.bonds) {
        weights.push_back(parse_signed_rational(bond.weight));
    }
    return weights;
}

std::string weights_list(const Report& report) {
    std::string list;
    for (const Bond& bond : report.bonds) {
        list += (list.empty() ? "" : ",") + bond.weight;
    }
    return list;
}

/// describe: of the family with these weights; it decides whether waves grow. A bond that is left
/// out is no weight of a family's, and harms no wave.
template <class Describe>
void settle_stability(Report& report, double least_squared_speed, const Describe& describe) {
    const std::vector<Rational> weights = weights_of(report);
    if (std::ranges::count(weights, Rational(0)) > 0) {
        report.refusal = "a bond has the weight 0";
        report.is_stable = least_squared_speed > 0;
        return;
    }
    try {
        describe(weights);
        report.is_stable = true;
    } catch (const NoSuchModel& reason) {
        report.refusal = reason.what();
    }
}

Report chain_report(const BondsTask& task) {
    const bool is_given = !task.alpha.empty();
    const auto alpha = is_given ? as_given(task.alpha) : chain_bonds(*task.method, task.horizon);
    Report report{.lattice = fmt::format("chain, horizon {} dX", task.horizon),
                  .method_name = is_given ? given : bond_method_name(*task.method),
                  .method = is_given ? "as given" : std::string(equation_of(*task.method, 1)),
                  .model = "omega^2 = sum_j 4 alpha_j/(N^2 j) (1 - cos(j xi)), (10)",
                  .family = fmt::format("--family bond1d --horizon {}", task.horizon)};
    std::vector<double> values;
    for (std::size_t j = 1; j <= task.horizon; ++j) {
        values.push_back(alpha[j - 1].value);
        report.bonds.push_back(
            {std::to_string(j), {{"length", j}}, alpha[j - 1], decimals_of(values.back())});
    }
    const ChainBand band = band_of_chain(values);
    settle_stability(report, band.least_squared_speed, [&](const std::vector<Rational>& weights) {
        make_model("bond1d", task.horizon, 0, normalised(weights));
    });
    report.residual_over_original =
        residual_of_chain(values) / residual_of_chain(std::vector<double>(task.horizon, 1.0));
    report.largest_frequency = band.largest_frequency;
    double speed_squared = 0;  // (33)
    for (std::size_t j = 1; j <= values.size(); ++j) {
        speed_squared += 2 * double(j) * values[j - 1] / double(values.size() * values.size());
    }
    report.chain_speed = std::sqrt(speed_squared);
    std::ranges::transform(listed_wave_numbers, report.chain_speed_error.begin(),
                           [&](double xi) { return speed_error_of_chain(values, xi); });
    return report;
}

Report square_report(const BondsTask& task) {
    const bool is_given = !task.alpha.empty();
    const SquareBonds bonds = is_given ? given_square_bonds(task.horizon, task.alpha)
                              : task.method == BondMethod::bz_ls
                                  ? square_bonds(task.horizon, task.bound)
                                  : contour_bonds(*task.method, task.horizon);
    const unsigned radius_squared = task.horizon * task.horizon;
    Report report{
        .lattice =
            fmt::format("square lattice, horizon {} dX, nu = 1/4 in plane strain", task.horizon),
        .method_name = is_given ? given : bond_method_name(*task.method),
        .method =
            is_given
                ? "as given"
                : std::string(equation_of(*task.method, 2)) +
                      (task.bound ? fmt::format(", all alpha >= {}", to_string(*task.bound)) : ""),
        .model = "D = sum over bonds b of 48 alpha/(5 pi N^3 |b|^3) b b^T (1 - cos k.b), (13)",
        .family = fmt::format("--family bond2d --radius2 {}", radius_squared)};
    for (std::size_t a = 0; a < bonds.classes.size(); ++a) {
        const auto [i, j] = bonds.classes[a];
        report.bonds.push_back({fmt::format("({}, {})", i, j),
                                {{"bond", {i, j}}},
                                bonds.alpha[a],
                                decimals_of(bonds.weights[a])});
    }
    settle_stability(
        report,
        BondLattice(bond_classes_in_plane(radius_squared), bonds.weights).least_squared_speed(),
        [&](const std::vector<Rational>& weights) {
            bond2d({.radius_squared = radius_squared, .weights = weights});
        });
    report.square = figures_of(bonds);
    const std::vector<Rational> ones(bonds.classes.size(), Rational(1));
    report.residual_over_original =
        report.square->residual / figures_of(given_square_bonds(task.horizon, ones)).residual;
    report.largest_frequency = report.square->largest_frequency;
    return report;
}

Report report_of(const BondsTask& task) {
    return task.dimension == 1 ? chain_report(task) : square_report(task);
}

bool has_mixed_sign(const Report& report) {
    return std::ranges::any_of(report.bonds, [](const Bond& bond) { return bond.alpha.value < 0; });
}

constexpr std::size_t widest_closed_form = 100;

}  // namespace

std::string bonds_text(const BondsTask& task) {
    const Report report = report_of(task);
    std::string text =
        fmt::format("lattice   {}\nmethod    {}\nmodel     {}\n\n{:<8}  {:>12}  {}\n",
                    report.lattice, report.method, report.model, "bond", "alpha", "closed form");
    for (const auto& [name, key, alpha, weight] : report.bonds) {
        std::string closed_form = alpha.closed_form ? to_text(*alpha.closed_form) : "-";
        if (closed_form.size() > widest_closed_form) {
            closed_form = "in JSON";
        }
        text += fmt::format("{:<8}  {:>12.6f}  {}\n", name, alpha.value, closed_form);
    }
    text += fmt::format("\nresidual  {:.4f} of that of alpha = 1, ({})\n",
                        report.residual_over_original, task.dimension == 1 ? 49 : 51);
    if (!report.is_stable) {
        return text + "warning   this lattice has waves that grow: omega^2 is not above 0\n";
    }
    constexpr int digits_of_step = 4;
    text += fmt::format("steps     stable below dt = {} dX sqrt(rho/E): omega_max = {:.4f}\n",
                        rounded_down(2 / report.largest_frequency, digits_of_step),
                        report.largest_frequency);
    if (!report.square) {
        text += fmt::format("speed     long waves, over the solid's: {:.4f}\n", report.chain_speed);
    } else {
        const auto& P = report.square->speed_P;
        const auto& S = report.square->speed_S;
        text += fmt::format(
            "speeds    long waves at 0 and 45 degrees, over the solid's: P {:.3f} {:.3f}, "
            "S {:.3f} {:.3f}\n",
            P[0], P[1], S[0], S[1]);
    }
    for (std::size_t i = 0; i < listed_wave_numbers.size(); ++i) {
        const double xi = listed_wave_numbers[i];
        const std::string off =
            report.square
                ? fmt::format("P {:.1f}, S {:.1f}", 100 * report.square->speed_error[i][0],
                              100 * report.square->speed_error[i][1])
                : fmt::format("{:.1f}", 100 * report.chain_speed_error[i]);
        text += fmt::format(
            "{:<10}{} % off the solid's phase velocity at xi = {:.1f}, {:.1f} dX long\n",
            i == 0 ? "waves" : "", off, xi, 2 * std::numbers::pi / xi);
    }
    text += report.refusal.empty()
                ? fmt::format("options   {} --weights {}\n", report.family, weights_list(report))
                : fmt::format("refused   by other commands: {}\n", report.refusal);
    if (has_mixed_sign(report)) {
        text +=
            "warning   this set has bonds below 0: where others break, the energy may lose its "
            "lower "
            "bound. For cracks take a positive set\n";
    }
    return text;
}

std::string bonds_json(const BondsTask& task) {
    const Report report = report_of(task);
    Json bonds = Json::array();
    for (const auto& [name, key, alpha, weight] : report.bonds) {
        Json entry = key;
        entry["value"] = alpha.value;
        entry["weight"] = std::stod(weight);
        entry["closed_form"] =
            alpha.closed_form ? Json(to_text(*alpha.closed_form)) : Json(nullptr);
        bonds.push_back(entry);
    }
    Json all{{"bonds", report.method_name},
             {"dimension", task.dimension},
             {"horizon", task.horizon},
             {"bound", task.bound ? Json(to_string(*task.bound)) : Json(nullptr)},
             {"model", report.model},
             {"source", "Alebrahim, Packo, Zaccariotto, Galvanetto 2022; " + report.method},
             {"units", "E, density and dX are 1"},
             {"alpha", bonds},
             {"residual_over_original", report.residual_over_original},
             {"stable", report.is_stable},
             {"positive", !has_mixed_sign(report)},
             {"omega_max", report.is_stable ? Json(report.largest_frequency) : Json(nullptr)}};
    if (!report.square) {
        all["speed_ratio"] = report.is_stable ? Json(report.chain_speed) : Json(nullptr);
    } else {
        all["speed_ratios"] =
            report.is_stable ? Json{{"P", report.square->speed_P}, {"S", report.square->speed_S}}
                             : Json(nullptr);
    }
    Json errors = Json::array();
    for (std::size_t i = 0; i < listed_wave_numbers.size() && report.is_stable; ++i) {
        Json entry{{"xi", listed_wave_numbers[i]}};
        if (report.square) {
            entry["P"] = report.square->speed_error[i][0];
            entry["S"] = report.square->speed_error[i][1];
        } else {
            entry["error"] = report.chain_speed_error[i];
        }
        errors.push_back(entry);
    }
    all["phase_velocity_errors"] = errors;
    all["options"] = report.refusal.empty()
                         ? Json(fmt::format("{} --weights {}", report.family, weights_list(report)))
                         : Json(nullptr);
    return all.dump(2) + "\n";
}

}  // namespace nmbcgen
