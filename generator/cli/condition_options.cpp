// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/condition_options.hpp"

#include "generator/cli/model_options.hpp"
#include "generator/cli/option_values.hpp"
#include "generator/cli/parsed_option.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {

void require_one_of(CLI::App& app, CLI::Option* horizon, CLI::Option* radius) {
    horizon->excludes(radius);
    app.parse_complete_callback([horizon, radius] {
        if (horizon->count() + radius->count() == 0) {
            throw CLI::RequiredError("--horizon (or --radius2)");
        }
    });
}

SpecificationOptions add_specification(CLI::App& app, Request& request, Pending& pending) {
    Specification& what = request.specification;
    const SpecificationOptions options{
        .family = add_parsed(
            app, "--family", what.family, parse_family,
            "lattice model: " + family_names() + " (default nopd1d, with --radius2 nopd2d)"),
        .order =
            add_parsed(app, "--order", what.order, parse_count, "order N of the condition, >= 1"),
        .match =
            add_parsed(app, "--match", pending.matching, parse_matching,
                       "with --G, in place of --order: XI:ROWS,.. matches the residual and its "
                       "derivatives, ROWS in all, at the wave numbers XI in 1/dX, such as "
                       "0:5,1.2:2 or 0:3,pi/3:1"),
        .horizon = add_parsed(app, "--horizon", what.horizon, parse_count,
                              "horizon n in units of dX, >= 1"),
        .radius = add_plane(app, pending.plane),
        .weights = add_weights(app, pending.weights),
        .stride = add_parsed(app, "--stride", what.stride, parse_count,
                             "node offsets of the condition are 0, s, 2s, .. Ns (default 1)"),
        .damping = add_parsed(app, "--damping", what.damping, parse_rational,
                              "tau, viscous damping of the stabilisation at G = 1 (of nopd2d: g = "
                              "1), an exact number in c/dX "
                              "such as 1/10 (default 0)"),
        .time_step =
            add_parsed(app, "--time-step", what.time_step, parse_rational,
                       "dt of the leapfrog scheme to match in, an exact number in dX/c such "
                       "as 1/2 (default 0: continuous time)"),
        .cfl = add_parsed(app, "--cfl", request.cfl, parse_cfl,
                          "with --G: --time-step by cfl = dt omega_max/2, as the largest multiple "
                          "of 1/1000 dX/c that is not above"),
        .G =
            add_parsed(app, "--G", what.stabilisation, parse_rational,
                       "fix the stabilisation G (of nopd2d: g = G/pi), an exact number such as 1/2 "
                       "or 0.3 (default: coefficients are functions of G)"),
    };
    options.cfl->excludes(options.time_step);
    options.match->excludes(options.order);
    options.horizon->excludes(options.radius);
    return options;
}

void require_condition(const SpecificationOptions& options, const std::string& otherwise) {
    const bool has_condition = options.order->count() + options.match->count() > 0;
    const bool has_lattice = options.horizon->count() + options.radius->count() > 0;
    const std::string condition = "--order (or --match)";
    const std::string lattice = "--horizon (or --radius2)";
    if (!has_condition && !has_lattice) {
        throw CLI::RequiredError(condition + " and " + lattice + otherwise);
    }
    if (!has_condition || !has_lattice) {
        throw CLI::RequiredError(has_condition ? lattice : condition);
    }
}

}  // namespace nmbcgen
