// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <sstream>

#include "generator/cli/model_options.hpp"
#include "generator/cli/option_values.hpp"
#include "generator/cli/parsed_option.hpp"
#include "generator/cli/print_options.hpp"
#include "generator/cli/settle.hpp"
#include "generator/cli/whole_number.hpp"
#include "generator/exact/rational.hpp"
#include "generator/support/files.hpp"

namespace nmbcgen {
namespace {

/// The size of the neighbourhood, of a chain or of a plane lattice.
void require_one_of(CLI::App& app, CLI::Option* horizon, CLI::Option* radius) {
    horizon->excludes(radius);
    app.parse_complete_callback([horizon, radius] {
        if (horizon->count() + radius->count() == 0) {
            throw CLI::RequiredError("--horizon (or --radius2)");
        }
    });
}

struct SpecificationOptions {
    CLI::Option* family;
    CLI::Option* order;
    CLI::Option* match;
    CLI::Option* horizon;
    CLI::Option* radius;
    CLI::Option* weights;
    CLI::Option* stride;
    CLI::Option* damping;
    CLI::Option* time_step;
    CLI::Option* cfl;
    CLI::Option* G;
};

SpecificationOptions add_specification(CLI::App& app, Request& request, Pending& pending) {
    Specification& what = request.specification;
    const SpecificationOptions options{
        .family = add_parsed(app, "--family", what.family, parse_family,
                             "lattice model: " + family_names() + " (default nopd1d)"),
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
    if (options.order->count() + options.match->count() == 0 ||
        options.horizon->count() + options.radius->count() == 0) {
        throw CLI::RequiredError("--order (or --match) and --horizon (or --radius2)" + otherwise);
    }
}

/// nmbcgen reflect, with the same options for the condition.
CLI::App* add_reflect(CLI::App& app, Request& request, Pending& pending) {
    auto* const reflect = app.add_subcommand(
        "reflect",
        "print the true reflection over the band as CSV (docs/explanation/reflection.md)");
    const SpecificationOptions options = add_specification(*reflect, request, pending);
    reflect->parse_complete_callback([options] { require_condition(options, ""); });
    add_parsed(*reflect, "--samples", request.samples, parse_samples,
               "wave numbers in (0, pi) (default 200)");
    return reflect;
}

/// nmbcgen prove, of what is matched in continuous time and not damped.
CLI::App* add_prove(CLI::App& app, Request& request, Pending& pending) {
    auto* const prove = app.add_subcommand(
        "prove", "say what of a certificate is proved by enclosures (docs/explanation/proofs.md)");
    const SpecificationOptions options = add_specification(*prove, request, pending);
    for (CLI::Option* other : {options.match, options.damping, options.cfl, options.time_step}) {
        prove->remove_option(other);
    }
    options.order->required();
    require_one_of(*prove, options.horizon, options.radius);
    add_parsed(*prove, "--up-to", request.proof.cfl, parse_fraction,
               "prove all steps up to this cfl, too (default: continuous time alone)")
        ->excludes(options.G);
    add_parsed(*prove, "--finest", request.proof.finest, parse_fraction,
               "do not halve intervals of G below this (default: a thousandth of the window)")
        ->excludes(options.G);
    return prove;
}

/// nmbcgen dispersion.
CLI::App* add_dispersion(CLI::App& app, Curves& curves, Pending& pending) {
    auto* const dispersion = app.add_subcommand(
        "dispersion",
        "print dispersion relations over the band as CSV (docs/explanation/dispersion.md)");
    add_parsed(*dispersion, "--family", curves.family, parse_family,
               "lattice model: " + family_names() + " (default nopd1d)");
    CLI::Option* const horizon =
        add_parsed(*dispersion, "--horizon", curves.horizons, parse_counts,
                   "horizons n in units of dX, with commas between, such as 1,2,3");
    CLI::Option* const radius = add_plane_model(*dispersion, pending.plane);
    require_one_of(*dispersion, horizon, radius);
    add_parsed(
        *dispersion, "--angle", pending.plane.angles, parse_angles,
        "of a plane family: directions of the waves against x in degrees, with commas between "
        "(default 0,15,30,45), or as FROM..TO/STEP, such as 0..90/5");
    add_weights(*dispersion, pending.weights);
    add_parsed(*dispersion, "--G", curves.G, parse_rationals,
               "values of the stabilisation G (of nopd2d: g = G/pi), exact numbers with commas "
               "between, such as 0,1/2,1");
    add_parsed(*dispersion, "--samples", curves.samples, parse_samples,
               "wave numbers in 0 < xi <= pi (default 200)");
    dispersion
        ->add_flag("--limit", curves.limit, "add the continuum limit at the same horizon, dX -> 0")
        ->disable_flag_override();
    return dispersion;
}

/// nmbcgen passive.
CLI::App* add_passive(CLI::App& app, Request& request, Pending& pending) {
    Question& question = request.question;
    auto* const passive = app.add_subcommand(
        "passive",
        "design an end of a chain, or a side of a plane lattice, that is stable by "
        "construction; JSON");
    add_parsed(*passive, "--family", question.family, parse_family,
               "lattice model: nopd1d (default), nopd2d, bond2d");
    const auto parse_horizon = [](const std::string& text) {
        return parse_whole_number(text, largest_designed_horizon);
    };
    CLI::Option* const horizon = add_parsed(*passive, "--horizon", question.horizon, parse_horizon,
                                            "of nopd1d: horizon n in units of dX, 1 to 6");
    CLI::Option* const radius = add_plane_model(*passive, pending.plane);
    require_one_of(*passive, horizon, radius);
    add_weights(*passive, pending.weights);
    add_parsed(
        *passive, "--G", question.G, parse_rational,
        "stabilisation G of the model (of nopd2d: g = G/pi), an exact number such as 1/2 or 0.3");
    add_parsed(*passive, "--time-step", pending.passive_step, parse_rational,
               "dt of the leapfrog steps it is for, an exact number in dX/c such as 1/2 (of plane "
               "families in dX sqrt(rho/E); default 0: continuous time)");
    add_parsed(
        *passive, "--layers", pending.layers, parse_count,
        "of a side: outermost layers with numbers of their own, from 2n, the default, to 16; "
        "more reflect less at wide angles, and take longer to design and to run");
    passive
        ->add_flag("--header", request.as_header,
                   "print a C++ header: of an end of a chain an nmbc::PassiveEnd, of a side of "
                   "nopd2d an nmbc::PassiveSide")
        ->disable_flag_override();
    return passive;
}

/// nmbcgen recommend.
CLI::App* add_recommend(CLI::App& app, Request& request, Pending& pending) {
    Question& question = request.question;
    auto* const recommend = app.add_subcommand(
        "recommend", "say which boundary to use at a horizon and a G, and why not another one");
    add_parsed(*recommend, "--family", question.family, parse_family,
               "lattice model: " + family_names() + " (default nopd1d)");
    CLI::Option* const horizon = add_parsed(*recommend, "--horizon", question.horizon, parse_count,
                                            "horizon n in units of dX, >= 1");
    CLI::Option* const radius = add_plane(*recommend, pending.plane);
    require_one_of(*recommend, horizon, radius);
    add_weights(*recommend, pending.weights);
    add_parsed(*recommend, "--absorb", request.absorbed, parse_absorbed,
               "of the side of a plane lattice: a row more for NMBC1 matched at an angle, such as "
               "P:45, or for the product of two, such as P:0,S:45")
        ->needs(radius);
    recommend
        ->add_flag("--csv", request.as_csv,
                   "of the side of a plane lattice: what each boundary sends back against the "
                   "angle, in place of the advice")
        ->needs(radius);
    add_parsed(
        *recommend, "--G", question.G, parse_rational,
        "stabilisation G of the model (of nopd2d: g = G/pi), an exact number such as 1/2 or 0.3");
    add_parsed(*recommend, "--order", question.order, parse_recommended_order,
               "this order only (default: 1 to 4)");
    add_parsed(*recommend, "--tolerance", question.tolerance, parse_fraction,
               "the part of the energy that may be reflected, mean over the band (default 1e-6, or "
               "the next power of ten up to 0.1 that can be kept)");
    add_parsed(*recommend, "--cfl", question.cfl, parse_recommended_cfl,
               "dt omega_max/2 of your steps (default: the largest that reflect no more than the "
               "tolerance)");
    add_parsed(*recommend, "--band", question.band, parse_band,
               "wave numbers LO..HI in 1/dX (default 0.05..0.3)");
    return recommend;
}

/// nmbcgen optimise, with the same options for the condition but --match.
CLI::App* add_optimise(CLI::App& app, Request& request, Pending& pending) {
    auto* const optimise =
        app.add_subcommand("optimise",
                           "find the matching points that reflect least over a band (docs/"
                           "how-to/match-inside-a-band.md)");
    const SpecificationOptions options = add_specification(*optimise, request, pending);
    for (CLI::Option* other : {options.match, options.order, options.stride}) {
        optimise->remove_option(other);
    }
    add_parsed(*optimise, "--order", request.specification.order, parse_recommended_order,
               "order N of the condition, 1 to 8")
        ->required();
    add_parsed(*optimise, "--stride", request.aim.stride, parse_count,
               "this stride only (default: 1 to 2n, or to 4)");
    add_parsed(*optimise, "--band", request.aim.band, parse_wide_band,
               "wave numbers LO..HI in 1/dX over which the reflected energy is averaged")
        ->required();
    require_one_of(*optimise, options.horizon, options.radius);
    return optimise;
}

/// nmbcgen closed-forms.
CLI::App* add_closed_forms(CLI::App& app, Request& request) {
    auto* const closed_forms = app.add_subcommand(
        "closed-forms",
        "print the Taylor coefficients for all horizons at once (docs/reference/closed-forms.md)");
    add_parsed(*closed_forms, "--order", request.specification.order, parse_closed_order,
               "N: a_1 to a_{2N+1}, 1 to 12")
        ->required();
    add_parsed(*closed_forms, "--family", request.specification.family, parse_chain_family,
               "lattice model: " + chain_family_names() + " (default nopd1d)");
    add_parsed(*closed_forms, "--format", request.closed_format, parse_closed_format,
               closed_format_names() + " (default text)");
    return closed_forms;
}

/// What CLI11 says, but of what is no part of coupling: that, and not that one is required.
std::string problem_of(const CLI::ParseError& error, const CLI::App& coupling) {
    const auto unknown = coupling.remaining();
    return coupling.parsed() && coupling.get_subcommands().empty() && !unknown.empty()
               ? "coupling: '" + unknown.front().substr(0, 60) +
                     "' is no part of it; allowed: stencil, cases, waves"
               : error.what();
}

}  // namespace

std::variant<Request, int> parse_command_line(int argc, char** argv) {
    Request request;
    bool all = false;
    bool check = false;

    CLI::App app(
        "nmbcgen: derives a nonlocal matching boundary condition in exact arithmetic and writes "
        "it as a table.\nExample: nmbcgen --order 3 --horizon 2",
        "nmbcgen");
    app.set_version_flag("--version", "nmbcgen " NMBC_VERSION);
    Pending pending;
    const SpecificationOptions single = add_specification(app, request, pending);
    auto* const format = add_parsed(app, "--format", request.format, parse_format,
                                    format_names() + " (default header)");
    auto* const to_stdout =
        app.add_flag("--stdout", request.to_stdout, "print the table instead of writing a file");
    auto* const require_stable =
        app.add_flag("--require-stable", request.require_stable,
                     "with --G: write the table only where it is certified to be stable; with "
                     "--polarisation, found so as a side of the plane, too");
    bool uncertified_given = false;
    auto* const uncertified = app.add_flag(
        "--uncertified", uncertified_given,
        "leave out the certificate of stability, which takes minutes at orders above 8");
    auto* const folder = add_parsed(app, "--out", request.folder, parse_folder,
                                    "folder to write to (default generated/nmbc/tables)");
    add_parsed(app, "--cache", request.cache, parse_folder,
               "folder to keep certificates in from one run to the next")
        ->envname("NMBCGEN_CACHE");
    auto* const all_flag =
        app.add_flag("--all", all, "write the committed set, with tables.hpp and tables.json");
    auto* const check_flag = app.add_flag(
        "--check", check,
        "compare the committed set in the folder with a fresh one; exit code 1 if it is stale");
    for (CLI::Option* whole_set : {all_flag, check_flag}) {
        for (CLI::Option* other :
             {single.family, single.order, single.match, single.horizon, single.radius,
              single.weights, single.stride, single.damping, single.time_step, single.cfl, single.G,
              format, to_stdout, require_stable, uncertified}) {
            whole_set->excludes(other);
        }
    }
    all_flag->excludes(check_flag);
    to_stdout->excludes(folder);
    require_stable->excludes(uncertified);
    auto* const reflect = add_reflect(app, request, pending);
    auto* const prove = add_prove(app, request, pending);
    auto* const recommend = add_recommend(app, request, pending);
    auto* const passive = add_passive(app, request, pending);
    auto* const optimise = add_optimise(app, request, pending);
    auto* const dispersion = add_dispersion(app, request.curves, pending);
    auto* const closed_forms = add_closed_forms(app, request);
    auto* const bonds = add_bonds(app, request);
    auto* const closure = add_closure(app, request);
    auto* const coupling = add_coupling(app, request);
    auto* const influence = add_influence(app, request);
    auto* const taylor = add_taylor(app, request, pending);
    auto* const oblique = add_oblique(app, request, pending);
    app.footer(
        "Exit codes: 0 done; 1 the committed set is stale; 2 wrong arguments; 3 there is no such "
        "boundary\ncondition; 4 it is not certified to be stable (--require-stable); 5 a file "
        "could not "
        "be read or written.");

    app.require_subcommand(0, 1);
    try {
        app.parse(argc, argv);
        if (!all && !check && app.get_subcommands().empty()) {
            require_condition(single, " (or --all, or --check)");
        }
        request.certified = !uncertified_given;
        if (all) {
            request.action = Action::all_tables;
        } else if (check) {
            request.action = Action::check;
        } else if (reflect->parsed()) {
            request.action = Action::reflect;
        } else if (prove->parsed()) {
            request.action = Action::prove;
        } else if (recommend->parsed()) {
            request.action = Action::recommend;
        } else if (passive->parsed()) {
            request.action = Action::passive;
        } else if (optimise->parsed()) {
            request.action = Action::optimise;
        } else if (dispersion->parsed()) {
            request.action = Action::dispersion;
        } else if (closed_forms->parsed()) {
            request.action = Action::closed_forms;
        } else if (bonds->parsed()) {
            request.action = Action::bonds;
        } else if (closure->parsed()) {
            request.action = Action::closure;
        } else if (coupling->parsed()) {
            request.action = Action::coupling;
        } else if (influence->parsed()) {
            request.action = Action::influence;
        } else if (taylor->parsed()) {
            request.action = Action::taylor;
        } else if (oblique->parsed()) {
            request.action = Action::oblique;
        }
        settle(request, pending, app);
    } catch (const CLI::Success& help) {
        std::ostringstream text;
        const int exit_code = app.exit(help, text, text);
        print(text.str());
        return exit_code;
    } catch (const CLI::ParseError& error) {
        std::cerr << "nmbcgen: " << problem_of(error, *coupling) << "\nSee nmbcgen --help.\n";
        return 2;
    }
    return request;
}

}  // namespace nmbcgen
