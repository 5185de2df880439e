// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <sstream>

#include "generator/cli/condition_options.hpp"
#include "generator/cli/option_values.hpp"
#include "generator/cli/parsed_option.hpp"
#include "generator/cli/print_options.hpp"
#include "generator/cli/question_options.hpp"
#include "generator/cli/settle.hpp"
#include "generator/names/printable.hpp"
#include "generator/support/command_line_problem.hpp"
#include "generator/support/files.hpp"

namespace nmbcgen {
std::variant<Request, int> parse_command_line(int argc, char** argv) {
    Request request;
    bool all = false;
    bool check = false;

    CLI::App app(
        "nmbcgen: derives a nonlocal matching boundary condition in exact arithmetic and writes "
        "it as a table.\nExample: nmbcgen --order 3 --horizon 2",
        "nmbcgen");
    app.option_defaults()->disable_flag_override();  // of subcommands, too: --stdout=no is none
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
               "folder to keep certificates, and designs and recommendations of sides, in from one "
               "run to the next")
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
        std::cerr << "nmbcgen: " << printable(problem_of(error, app)) << "\nSee nmbcgen --help.\n";
        return 2;
    }
    return request;
}

}  // namespace nmbcgen
