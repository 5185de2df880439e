// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/bonds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "generator/bonds/square_bonds.hpp"
#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"

namespace nmbcgen {
namespace {

struct NamedMethod {
    std::string_view name;
    ChainMethod method;
    std::string_view equation;
};

constexpr const char* given = "given";

constexpr std::array methods{
    NamedMethod{"point", ChainMethod::point, "point collocation, (40)"},
    NamedMethod{"subdomain", ChainMethod::subdomain, "sub-domain collocation, (42) signed"},
    NamedMethod{"galerkin", ChainMethod::galerkin, "Galerkin, (46) signed"},
    NamedMethod{"least-squares", ChainMethod::least_squares,
                "least squares over 0 .. pi, (44) as one problem"},
    NamedMethod{"taylor", ChainMethod::taylor, "Taylor series at xi = 0"},
};

const NamedMethod& named(ChainMethod method) {
    return *std::ranges::find(methods, method, &NamedMethod::method);
}

/// What both outputs say, in one order.
struct Report {
    std::string lattice;
    std::string method;
    std::string method_name;
    std::string model;  ///< what alpha scales
    std::vector<std::string> names;
    std::vector<nlohmann::ordered_json> bonds;
    std::vector<BondCoefficient> alpha;
    double residual_over_original = 0;
    double largest_frequency = 0;
    bool is_stable = false;  ///< on the wave numbers looked at
    std::optional<SquareFigures> square{};
    std::string family;   ///< the options of nmbcgen for this lattice, but for --weights
    std::string weights;  ///< its argument, to 16 digits
};

void append_weight(std::string& list, double weight) {
    list += fmt::format("{}{:.15f}", list.empty() ? "" : ",", weight);
}

/// Coefficients that were given.
std::vector<BondCoefficient> as_given(const std::vector<Rational>& alpha) {
    std::vector<BondCoefficient> coefficients;
    for (const Rational& value : alpha) {
        coefficients.push_back({nearest_double(value), PiPolynomial{Quadratic(value)}});
    }
    return coefficients;
}

Report chain_report(const BondsTask& task) {
    const NamedMethod method =
        task.alpha.empty() ? named(*task.method) : NamedMethod{given, {}, "as given"};
    Report report{.lattice = fmt::format("chain, horizon {} dX", task.horizon),
                  .method = std::string(method.equation),
                  .method_name = std::string(method.name),
                  .model = "omega^2 = sum_j 4 alpha_j/(N^2 j) (1 - cos(j xi)), (10)",
                  .names = {},
                  .bonds = {},
                  .alpha = task.alpha.empty() ? chain_bonds(*task.method, task.horizon)
                                              : as_given(task.alpha),
                  .family = fmt::format("--family bond1d --horizon {}", task.horizon),
                  .weights = {}};
    std::vector<double> values;
    for (std::size_t j = 1; j <= task.horizon; ++j) {
        report.names.push_back(std::to_string(j));
        report.bonds.push_back({{"length", j}});
        values.push_back(report.alpha[j - 1].value);
        append_weight(report.weights, values.back());
    }
    report.residual_over_original =
        residual_of_chain(values) / residual_of_chain(std::vector<double>(task.horizon, 1.0));
    const ChainBand band = band_of_chain(values);
    report.largest_frequency = band.largest_frequency;
    report.is_stable = band.least_squared_speed > 0;
    return report;
}

Report square_report(const BondsTask& task) {
    const SquareBonds bonds = [&] {
        if (!task.alpha.empty()) {
            return given_square_bonds(task.horizon, task.alpha);
        }
        try {
            return square_bonds(task.horizon, task.bound);
        } catch (const BoundsNotMet& reason) {
            throw NoSuchBoundary(reason.what());
        }
    }();
    Report report{
        .lattice =
            fmt::format("square lattice, horizon {} dX, nu = 1/4 in plane strain", task.horizon),
        .method =
            !task.alpha.empty()
                ? "as given"
                : "least squares of the dynamical matrix over the Brillouin zone" +
                      (task.bound ? fmt::format(", all alpha >= {}", to_string(*task.bound)) : ""),
        .method_name = task.alpha.empty() ? "bz-ls" : given,
        .model = "D = sum over bonds b of 48 alpha/(5 pi N^3 |b|^3) b b^T (1 - cos k.b), (13)",
        .names = {},
        .bonds = {},
        .alpha = bonds.alpha,
        .square = figures_of(bonds),
        .family = fmt::format("--family bond2d --radius2 {}", task.horizon * task.horizon),
        .weights = {}};
    for (const auto& [i, j] : bonds.classes) {
        report.names.push_back(fmt::format("({}, {})", i, j));
        report.bonds.push_back({{"bond", {i, j}}});
        append_weight(report.weights, bonds.weights[report.bonds.size() - 1]);
    }
    const std::vector<Rational> ones(bonds.classes.size(), Rational(1));
    report.residual_over_original =
        report.square->residual / figures_of(given_square_bonds(task.horizon, ones)).residual;
    report.largest_frequency = report.square->largest_frequency;
    report.is_stable = report.square->least_squared_speed > 0;
    return report;
}

Report report_of(const BondsTask& task) {
    return task.dimension == 1 ? chain_report(task) : square_report(task);
}

bool has_mixed_sign(const Report& report) {
    return std::ranges::any_of(report.alpha,
                               [](const BondCoefficient& alpha) { return alpha.value < 0; });
}

constexpr const char* mixed_sign =
    "has bonds below 0: break one of the others, and the energy has no lower bound; for cracks "
    "take a positive set";

}  // namespace

std::optional<ChainMethod> chain_method(std::string_view name) {
    const auto found = std::ranges::find(methods, name, &NamedMethod::name);
    return found == methods.end() ? std::nullopt : std::optional(found->method);
}

std::string chain_method_names() {
    std::string names;
    for (const NamedMethod& method : methods) {
        names += (names.empty() ? "" : ", ") + std::string(method.name);
    }
    return names;
}

std::string bonds_text(const BondsTask& task) {
    const Report report = report_of(task);
    std::string text =
        fmt::format("lattice   {}\nmethod    {}\nmodel     {}\n\n{:<8}  {:>12}  {}\n",
                    report.lattice, report.method, report.model, "bond", "alpha", "closed form");
    for (std::size_t i = 0; i < report.alpha.size(); ++i) {
        const auto& [value, closed_form] = report.alpha[i];
        text += fmt::format("{:<8}  {:>12.6f}  {}\n", report.names[i], value,
                            closed_form ? to_text(*closed_form) : "-");
    }
    text += fmt::format(
        "\nresidual  {:.4f} of that of alpha = 1, ({})\nsteps     stable below dt = {:.4f} dX "
        "sqrt(rho/E): omega_max = {:.4f}\n",
        report.residual_over_original, task.dimension == 1 ? 49 : 51, 2 / report.largest_frequency,
        report.largest_frequency);
    if (report.square) {
        const auto& P = report.square->speed_P;
        const auto& S = report.square->speed_S;
        text += fmt::format(
            "speeds    long waves at 0 and 45 degrees, over the solid's: P {:.3f} {:.3f}, "
            "S {:.3f} {:.3f}\n",
            P[0], P[1], S[0], S[1]);
    }
    text += fmt::format("options   {} --weights {}\n", report.family, report.weights);
    if (!report.is_stable) {
        text += "warning   this lattice has waves that grow: omega^2 < 0\n";
    } else if (has_mixed_sign(report)) {
        text += fmt::format("warning   this set {}\n", mixed_sign);
    }
    return text;
}

std::string bonds_json(const BondsTask& task) {
    using Json = nlohmann::ordered_json;
    const Report report = report_of(task);
    Json alpha = Json::array();
    for (std::size_t i = 0; i < report.alpha.size(); ++i) {
        const auto& [value, closed_form] = report.alpha[i];
        Json entry = report.bonds[i];
        entry["value"] = value;
        entry["closed_form"] = closed_form ? Json(to_text(*closed_form)) : Json(nullptr);
        alpha.push_back(entry);
    }
    Json all{{"bonds", report.method_name},
             {"dimension", task.dimension},
             {"horizon", task.horizon},
             {"bound", task.bound ? Json(to_string(*task.bound)) : Json(nullptr)},
             {"model", report.model},
             {"source", "Alebrahim, Packo, Zaccariotto, Galvanetto 2022; " + report.method},
             {"units", "E, density and dX are 1"},
             {"alpha", alpha},
             {"residual_over_original", report.residual_over_original},
             {"omega_max", report.largest_frequency},
             {"stable", report.is_stable},
             {"positive", !has_mixed_sign(report)}};
    if (report.square) {
        all["speed_ratios"] = {{"P", report.square->speed_P}, {"S", report.square->speed_S}};
    }
    all["options"] = fmt::format("{} --weights {}", report.family, report.weights);
    return all.dump(2) + "\n";
}

}  // namespace nmbcgen
