// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/question_options.hpp"

#include "generator/cli/condition_options.hpp"
#include "generator/cli/model_options.hpp"
#include "generator/cli/option_values.hpp"
#include "generator/cli/parsed_option.hpp"
#include "generator/cli/print_options.hpp"
#include "generator/cli/whole_number.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {

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

CLI::App* add_prove(CLI::App& app, Request& request, Pending& pending) {
    auto* const prove = app.add_subcommand(
        "prove", "say what of a certificate is proved by enclosures (docs/explanation/proofs.md)");
    const SpecificationOptions options = add_specification(*prove, request, pending);
    prove->remove_option(options.match);
    auto* const up_to =
        add_parsed(*prove, "--up-to", request.proof.cfl, parse_fraction,
                   "prove all steps up to this cfl, too (default: continuous time alone)")
            ->excludes(options.G)
            ->excludes(options.time_step);
    prove
        ->add_flag("--steps", request.proof.steps,
                   "prove every certified step at the G it is certified for; seconds at n = 1, "
                   "minutes above")
        ->excludes(options.G)
        ->excludes(options.time_step)
        ->excludes(up_to);
    add_parsed(*prove, "--finest", request.proof.finest, parse_fraction,
               "least width of the pieces of G that are tried (default 1e-4, or a thousandth of "
               "the window)")
        ->excludes(options.G);
    auto* const format = add_format(*prove, request);
    auto* const all = prove->add_flag("--all", request.proof.all,
                                      "how much is proved for the committed tables; 50 minutes of "
                                      "processor time, with --steps more");
    for (CLI::Option* other : {options.family, options.order, options.horizon, options.radius,
                               options.weights, options.stride, options.damping, options.time_step,
                               options.cfl, options.G, up_to, format}) {
        all->excludes(other);
    }
    prove->parse_complete_callback([options, all] {
        if (all->count() > 0) {
            return;
        }
        if (options.order->count() == 0) {
            throw CLI::RequiredError("--order (or --all)");
        }
        if (options.horizon->count() + options.radius->count() == 0) {
            throw CLI::RequiredError("--horizon (or --radius2)");
        }
    });
    return prove;
}

CLI::App* add_dispersion(CLI::App& app, Curves& curves, Pending& pending) {
    auto* const dispersion = app.add_subcommand(
        "dispersion",
        "print dispersion relations over the band as CSV (docs/explanation/dispersion.md)");
    add_parsed(*dispersion, "--family", curves.family, parse_family,
               "lattice model: " + family_names() + " (default nopd1d, with --radius2 nopd2d)");
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

CLI::App* add_passive(CLI::App& app, Request& request, Pending& pending) {
    Question& question = request.question;
    auto* const passive = app.add_subcommand(
        "passive",
        "design an end of a chain, or a side of a plane lattice, that is stable by "
        "construction; JSON");
    add_parsed(*passive, "--family", question.family, parse_family,
               "lattice model: nopd1d (default), chain1d, nopd2d (default with --radius2), bond2d");
    const auto parse_horizon = [](const std::string& text) {
        return parse_whole_number(text, largest_designed_horizon);
    };
    CLI::Option* const horizon = add_parsed(*passive, "--horizon", question.horizon, parse_horizon,
                                            "of a chain: horizon n in units of dX, 1 to 6");
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

CLI::App* add_recommend(CLI::App& app, Request& request, Pending& pending) {
    Question& question = request.question;
    auto* const recommend = app.add_subcommand(
        "recommend", "say which boundary to use at a horizon and a G, and why not another one");
    add_parsed(*recommend, "--family", question.family, parse_family,
               "lattice model: " + family_names() + " (default nopd1d, with --radius2 nopd2d)");
    CLI::Option* const horizon = add_parsed(*recommend, "--horizon", question.horizon, parse_count,
                                            "horizon n in units of dX, >= 1");
    CLI::Option* const radius = add_plane(*recommend, pending.plane);
    require_one_of(*recommend, horizon, radius);
    add_weights(*recommend, pending.weights);
    add_parsed(*recommend, "--absorb", request.absorbed, parse_absorbed,
               "of the side of a plane lattice: a row more for NMBC1 matched to this wave, or for "
               "the product of two: P or S, and the angle from the normal in degrees or as X:Y, "
               "such as P:45, P:30,S:60 or S:3:4")
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
               "this order only (default: 1 to 6)");
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

}  // namespace nmbcgen
