// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/print_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "generator/bonds/square_lattice.hpp"
#include "generator/cli/comma_list.hpp"
#include "generator/cli/model_options.hpp"
#include "generator/cli/option_values.hpp"
#include "generator/cli/parsed_option.hpp"
#include "generator/cli/whole_number.hpp"
#include "generator/closures/surface_node.hpp"
#include "generator/coupling/assembly.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

std::optional<BondMethod> parse_bond_method(const std::string& text) {
    const auto method = bond_method(text);
    if (!method) {
        throw std::invalid_argument(
            fmt::format("'{}' is not a method; allowed: of a chain {}; of a square lattice {}",
                        text.substr(0, 60), bond_method_names(1), bond_method_names(2)));
    }
    return method;
}

std::vector<Rational> parse_alpha(const std::string& text) {
    std::vector<Rational> alpha;
    for (const std::string& item : items_of(text)) {
        alpha.push_back(parse_signed_rational(item));
    }
    return alpha;
}

bool parse_is_json(const std::string& text) {
    if (text != "text" && text != "json") {
        throw std::invalid_argument(
            fmt::format("'{}' is not a format; allowed: text, json", text.substr(0, 60)));
    }
    return text == "json";
}

void require_fit(const BondsTask& task) {
    const bool is_chain = task.dimension == 1;
    const unsigned least = is_chain ? 1 : 2;
    const unsigned most = is_chain ? most_chain_bonds : most_square_bonds;
    if (task.horizon < least || task.horizon > most) {
        throw CLI::ValidationError("--horizon",
                                   fmt::format("in {} dimension{} it is {} to {}", task.dimension,
                                               is_chain ? "" : "s", least, most));
    }
    if (!task.alpha.empty()) {
        const std::size_t needed =
            is_chain ? task.horizon : square_bond_classes(task.horizon).size();
        if (task.alpha.size() != needed) {
            throw CLI::ValidationError("--alpha",
                                       fmt::format("{} coefficients, where horizon {} needs {}",
                                                   task.alpha.size(), task.horizon, needed));
        }
        return;
    }
    if (!has_method(task.dimension, *task.method)) {
        throw CLI::ValidationError(
            "--method", fmt::format("not in {} dimension{}; there: {}", task.dimension,
                                    is_chain ? "" : "s", bond_method_names(task.dimension)));
    }
    if (task.bound && *task.method != BondMethod::bz_ls) {
        throw CLI::ValidationError("--positive", "is of --method bz-ls");
    }
}

/// Logarithms of numbers with small prime factors are exact.
Rational parse_short_number(const std::string& text, const Rational& lowest,
                            const Rational& highest) {
    Rational value = parse_rational(text);
    constexpr unsigned most = 1000;
    if (value < lowest || value > highest || denominator(value) > most) {
        throw std::invalid_argument(
            fmt::format("'{}' is not a number from {} to {} with a denominator up to {}",
                        text.substr(0, 60), to_string(lowest), to_string(highest), most));
    }
    return value;
}

Rational parse_element_horizon(const std::string& text) {
    return parse_short_number(text, 0, largest_coupling_horizon);
}

Rational parse_wave_horizon(const std::string& text) {
    return parse_short_number(text, 0, largest_wave_horizon);
}

Rational parse_element_length(const std::string& text) {
    return parse_short_number(text, Rational(1, 4), 4);
}

/// Of summation by parts.
std::vector<Rational> parts_weights(const WeightChoice& choice, unsigned horizon) {
    if (std::ranges::any_of(choice.values, [](const Rational& weight) { return weight < 0; })) {
        throw CLI::ValidationError("--weights", "they must be above 0");
    }
    try {
        const std::vector<Rational> weights = weights_at(choice, horizon);
        return weights.empty() ? std::vector<Rational>(horizon, Rational(1)) : weights;
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError("--weights", error.what());
    }
}

}  // namespace

CLI::Option* add_format(CLI::App& command, Request& request) {
    auto* const format = add_parsed(command, "--format", request.as_json, parse_is_json,
                                    "text or json (default text)");
    command.add_flag("--stdout", request.to_stdout, "print it, as is done in any case");
    return format;
}

CLI::App* add_bonds(CLI::App& app, Request& request) {
    auto* const bonds = app.add_subcommand("bonds",
                                           "coefficients of bonds that make waves travel as in the "
                                           "solid (docs/how-to/optimised-bonds.md)");
    const auto parse_dimension = [](const std::string& text) {
        return parse_whole_number(text, 2);
    };
    add_parsed(*bonds, "--dimension", request.bonds.dimension, parse_dimension,
               "1, a chain, or 2, a square lattice")
        ->required();
    const auto parse_bonds = [](const std::string& text) {
        return parse_whole_number(text, most_chain_bonds);
    };
    add_parsed(*bonds, "--horizon", request.bonds.horizon, parse_bonds,
               fmt::format("N, the longest bond in units of dX: 1 to {}, in two dimensions 2 to {}",
                           most_chain_bonds, most_square_bonds))
        ->required();
    CLI::Option* const method =
        add_parsed(*bonds, "--method", request.bonds.method, parse_bond_method,
                   fmt::format("of a chain: {}; of a square lattice: {}", bond_method_names(1),
                               bond_method_names(2)));
    CLI::Option* const alpha =
        add_parsed(*bonds, "--alpha", request.bonds.alpha, parse_alpha,
                   "in place of a method: coefficients of your own, exact numbers with commas "
                   "between, shortest "
                   "bond first, of the square lattice those of (1, 0), (1, 1), (2, 0), (2, 1), ..");
    method->excludes(alpha);
    add_parsed(*bonds, "--positive", request.bonds.bound, parse_rational,
               "with bz-ls: no coefficient below this, an exact number such as 1/2 or 0.3")
        ->excludes(alpha);
    add_format(*bonds, request);
    bonds->parse_complete_callback([&request, method, alpha] {
        if (method->count() + alpha->count() == 0) {
            throw CLI::RequiredError("--method (or --alpha)");
        }
        require_fit(request.bonds);
    });
    return bonds;
}

CLI::App* add_closure(CLI::App& app, Request& request) {
    auto* const closure = app.add_subcommand(
        "closure", "a true end of a chain, in exact numbers (docs/how-to/end-a-body.md)");
    const auto require_known = [](const std::string& text) {
        if (text != "snm" && text != "sbp") {
            throw std::invalid_argument(
                fmt::format("'{}' is no closure whose rows are derived; allowed: snm, sbp",
                            text.substr(0, 60)));
        }
        return text;
    };
    add_parsed(*closure, "METHOD", request.closure.method, require_known,
               "snm, the surface node method of chains of bonds, or sbp, summation by parts for "
               "chains of correspondence")
        ->required();
    const auto parse_horizon = [](const std::string& text) {
        return parse_whole_number(text, largest_closure_horizon);
    };
    add_parsed(*closure, "--horizon", request.closure.horizon, parse_horizon,
               fmt::format("m in units of dX, 1 to {}", largest_closure_horizon))
        ->required();
    auto* const corrected = closure->add_flag(
        "--corrected", request.closure.corrected,
        "of snm: weight 3/2 for the nearest bond in place of the printed 1, which makes the chain "
        "of second order");
    const auto weights = std::make_shared<WeightChoice>(WeightChoice{&influences().front(), {}});
    auto* const weights_option =
        add_parsed(*closure, "--weights", *weights, parse_weights,
                   "of sbp: influence of bonds of 1 .. n dX, " + influence_names() +
                       " or exact numbers with commas between; left out: constant");
    add_format(*closure, request);
    closure->parse_complete_callback([&request, weights, weights_option, corrected] {
        ClosureTask& task = request.closure;
        const bool is_sbp = task.method == "sbp";
        if ((is_sbp ? corrected : weights_option)->count() > 0) {
            throw CLI::ValidationError(fmt::format(
                "{} is not of closure {}", is_sbp ? "--corrected" : "--weights", task.method));
        }
        task.weights = is_sbp ? parts_weights(*weights, task.horizon) : task.weights;
    });
    return closure;
}

CLI::App* add_coupling(CLI::App& app, Request& request) {
    auto* const coupling = app.add_subcommand(
        "coupling",
        "finite elements of bars that are local here, nonlocal there (docs/evidence/coupling.md)");
    coupling->require_subcommand(1);
    CouplingTask& task = request.coupling;
    const auto add_part = [&](const std::string& name, CouplingPart part,
                              const std::string& description) {
        auto* const command = coupling->add_subcommand(name, description);
        command->parse_complete_callback([&task, part] { task.part = part; });
        add_format(*command, request);
        return command;
    };
    auto* const stencil = add_part("stencil", CouplingPart::stencil,
                                   "a row of the stiffness of a uniform bar, exact");
    add_parsed(*stencil, "--horizon", task.horizon, parse_element_horizon,
               fmt::format("delta in units of the element's length, an exact number up to {}, "
                           "such as 3/2; 0: local",
                           largest_coupling_horizon))
        ->required();
    const auto add_bars = [&](CLI::App& command) {
        add_parsed(command, "--horizon", task.horizon, parse_wave_horizon,
                   fmt::format("delta of the left bar in units of its element's length h, an "
                               "exact number up to {}; 0: local",
                               largest_wave_horizon))
            ->required();
        add_parsed(command, "--other-horizon", task.other_horizon, parse_wave_horizon,
                   "likewise of the right bar, in units of h, too (default 0)");
        add_parsed(command, "--other-length", task.other_length, parse_element_length,
                   "length of the right bar's elements in units of h, an exact number from 1/4 to "
                   "4 (default 1)");
    };
    add_bars(*add_part("junction", CouplingPart::junction,
                       "rows of the stiffness where two bars meet, exact"));
    add_part("cases", CouplingPart::cases, "the cases 1 to 4 of Seleson 2011");
    add_bars(*add_part("waves", CouplingPart::waves,
                       "what the junction of two bars reflects, and an NMBC behind it"));
    return coupling;
}

CLI::App* add_influence(CLI::App& app, Request& request) {
    auto* const influence = app.add_subcommand(
        "influence",
        "bonds whose strength falls as a power of their length (docs/how-to/influence.md)");
    const auto parse_power = [](const std::string& text) {
        return parse_whole_number(text, largest_power, 0);
    };
    add_parsed(*influence, "--power", request.influence.power, parse_power,
               fmt::format("p of (|xi| + eps)^-p, 0 to {}", largest_power))
        ->required();
    const auto parse_smoothing = [](const std::string& text) {
        Rational eps = parse_rational(text);
        if (eps == 0) {
            throw std::invalid_argument("the smoothing length must be above 0");
        }
        if (nearest_double(eps) > largest_smoothing) {
            throw std::invalid_argument(
                fmt::format("the smoothing length must be at most {} dX", largest_smoothing));
        }
        return eps;
    };
    add_parsed(*influence, "--smoothing", request.influence.smoothing, parse_smoothing,
               "eps in units of dX, an exact number above 0 such as 4 or 1/2")
        ->required();
    const auto parse_horizon = [](const std::string& text) {
        return parse_whole_number(text, largest_power_horizon);
    };
    CLI::Option* const horizon =
        add_parsed(*influence, "--horizon", request.influence.horizon, parse_horizon,
                   fmt::format("of a chain: delta in units of dX, 1 to {}", largest_power_horizon));
    CLI::Option* const radius = add_parsed(
        *influence, "--radius2", request.class_influence.radius_squared, parse_radius_squared,
        "of a square or cubic lattice: delta^2 in units of dX^2, in place of --horizon");
    const auto parse_dimension = [](const std::string& text) {
        return std::size_t(parse_whole_number(text, 3, 2));
    };
    add_parsed(*influence, "--dimension", request.class_influence.dimensions, parse_dimension,
               "with --radius2: 2, a square lattice (default), or 3, a cubic one")
        ->needs(radius);
    horizon->excludes(radius);
    add_format(*influence, request);
    influence->parse_complete_callback([&request, horizon, radius] {
        if (horizon->count() + radius->count() == 0) {
            throw CLI::RequiredError("--horizon (or --radius2)");
        }
        request.class_influence.power = request.influence.power;
        request.class_influence.smoothing = request.influence.smoothing;
    });
    return influence;
}

void add_plane_family(CLI::App& command, std::string& family) {
    add_parsed(command, "--family", family, parse_plane_family,
               "plane family: " + plane_family_names() + " (default nopd2d)");
}

CLI::App* add_taylor(CLI::App& app, Request& request, Pending& pending) {
    PlaneSeriesTask& task = request.series;
    auto* const taylor = app.add_subcommand(
        "taylor",
        "Taylor coefficients of waves of a plane lattice in any direction, exact "
        "(docs/how-to/oblique-waves.md)");
    add_plane_family(*taylor, task.family);
    add_plane(*taylor, pending.plane)->required();
    add_weights(*taylor, pending.weights);
    add_parsed(*taylor, "--order", task.order, parse_closed_order, "N: a_1 to a_{2N+1}, 1 to 12")
        ->required();
    add_parsed(*taylor, "--direction", task.direction, parse_direction,
               "of the wave vector against x: 0, 30, 45, 60 or 90 degrees, or X:Y, such as 3:4 "
               "(default: every angle)");
    add_format(*taylor, request);
    return taylor;
}

CLI::App* add_oblique(CLI::App& app, Request& request, Pending& pending) {
    ObliqueTask& task = request.oblique;
    auto* const oblique = app.add_subcommand(
        "oblique",
        "coefficients of NMBC1 of a plane's side matched at an angle, or of the product of two "
        "(docs/how-to/oblique-waves.md)");
    add_plane_family(*oblique, task.family);
    add_plane_model(*oblique, pending.plane)->required();
    add_weights(*oblique, pending.weights);
    add_parsed(
        *oblique, "--absorb", task.waves, parse_oblique_waves,
        "one wave or two: P or S, and the angle from the normal in degrees or as X:Y, such as "
        "P:45, P:30,S:60 or S:3:4; exact are 0, 30, 45, 60 degrees and X:Y")
        ->required();
    add_parsed(*oblique, "--decay", task.decay, parse_rational,
               "e, which keeps a product from drifting, an exact number in sqrt(E/density)/dX "
               "(default 1/500; of one wave 0)");
    add_format(*oblique, request);
    return oblique;
}

}  // namespace nmbcgen
