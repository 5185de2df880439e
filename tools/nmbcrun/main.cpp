// SPDX-License-Identifier: MIT
/// nmbcrun: runs scenes and compares their ends.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <nmbc/coefficients.hpp>
#include <optional>
#include <system_error>

#include "generator/names/printable.hpp"
#include "generator/support/command_line_problem.hpp"
#include "generator/support/exit_code.hpp"
#include "generator/support/number_between.hpp"
#include "tools/nmbcrun/advise/advise.hpp"
#include "tools/nmbcrun/chart/chart.hpp"
#include "tools/nmbcrun/output/gnuplot.hpp"
#include "tools/nmbcrun/plane/plane_run.hpp"
#include "tools/nmbcrun/plane_compare/plane_advice.hpp"
#include "tools/nmbcrun/plane_compare/plane_chart.hpp"
#include "tools/nmbcrun/run.hpp"
#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"
#include "tools/nmbcrun/verify.hpp"

namespace {

using enum nmbcgen::ExitCode;

struct Arguments {
    std::string scene;
    std::vector<std::string> settings;
    std::string folder = "results";
    bool quiet = false;
    double tolerance = 0;
    std::optional<std::size_t> long_run;
    bool resume = false;
    bool plot = false;
    bool keep_checkpoint = false;
    bool finer = false;
};

void stop_where_interrupted() {
    if (nmbcrun::interrupted()) {
        throw nmbcrun::Interrupted("stopped; nothing was advised");
    }
}

constexpr const char* exit_codes =
    "Exit codes: 0 done; 1 verify: the error is above the tolerance, advise and run --tolerance:\n"
    "nothing meets it; 2 wrong arguments or scene, or a table that nmbcgen has to make first;\n"
    "3 no such boundary condition exists;\n"
    "4 the ends are not stable together or amplify what comes, or the run became non-finite, grew\n"
    "or had no energy;\n"
    "5 a file could not be read or written; 130 stopped by Ctrl-C, SIGTERM or SIGHUP.";

const CLI::Validator not_empty(
    [](const std::string& text) {
        return text.empty() ? std::string("must not be empty") : std::string();
    },
    "", "not_empty");

void require_drawable(const Arguments& arguments) {
    if (arguments.plot) {
        nmbcrun::require_drawable("energy.gp", arguments.folder);  // the others are beside it
    }
}

void run_as_asked(nmbcrun::Scene scene, const Arguments& arguments) {
    require_drawable(arguments);
    if (arguments.tolerance > 0) {
        nmbcrun::note_interrupts();
        scene = nmbcrun::as_advised(scene, arguments.tolerance, arguments.quiet,
                                    stop_where_interrupted);
        std::fflush(stdout);  // through a pipe, too, the advice is read before the run
        nmbcrun::end_at_interrupts(stopped);  // until the run writes
        if (nmbcrun::interrupted()) {
            throw nmbcrun::Interrupted("stopped; nothing was written");
        }
    }
    nmbcrun::run(scene,
                 {arguments.folder, arguments.quiet, arguments.resume, arguments.keep_checkpoint});
    if (arguments.plot) {
        nmbcrun::draw_run(scene, arguments.folder);
    }
}

/// The commands, of a plane scene.
nmbcgen::ExitCode plane_command(const std::string& command, nmbcrun::PlaneScene scene,
                                const Arguments& arguments) {
    if (command == "verify") {
        return nmbcrun::verify_plane(scene, arguments.tolerance, arguments.finer, arguments.quiet)
                   ? done
                   : does_not_hold;
    }
    if (command == "chart") {
        nmbcrun::chart_plane(
            scene,
            {.folder = arguments.folder, .long_run = arguments.long_run, .quiet = arguments.quiet});
        return done;
    }
    if (command == "advise") {
        nmbcrun::advise_plane(scene, arguments.tolerance, arguments.quiet);
        return done;
    }
    require_drawable(arguments);
    if (arguments.tolerance > 0) {
        nmbcrun::note_interrupts();
        scene = nmbcrun::as_advised(scene, arguments.tolerance, arguments.quiet);
        std::fflush(stdout);  // through a pipe, too, the advice is read before the run
    }
    nmbcrun::run_plane(
        scene, {arguments.folder, arguments.quiet, arguments.resume, arguments.keep_checkpoint});
    if (arguments.plot) {
        nmbcrun::draw_plane(scene, arguments.folder);
    }
    return done;
}

/// The exit code of a command, errors told.
template <class Command>
int exit_code_of(Command command) {
    const auto tell = [](const std::string& what) { std::cerr << "nmbcrun: " << what << "\n"; };
    const auto failed = [&](const std::exception& error, nmbcgen::ExitCode code) {
        tell(nmbcgen::printable(error.what()));
        return code;
    };
    const auto failed_in_lines = [&](const std::exception& error, nmbcgen::ExitCode code) {
        tell(nmbcgen::printable_lines(error.what()));
        return code;
    };
    try {
        const nmbcgen::ExitCode code = command();
        if (std::fflush(stdout) != 0) {
            throw nmbcrun::FileError("cannot write to standard output");
        }
        return code;
    } catch (const nmbcrun::NotMet& error) {
        return failed_in_lines(error, does_not_hold);
    } catch (const nmbc::CoefficientError& error) {
        return failed_in_lines(error, no_such_boundary);
    } catch (const nmbcrun::Unstable& error) {
        return failed_in_lines(error, unstable);
    } catch (const nmbcrun::Interrupted& error) {
        return failed(error, stopped);
    } catch (const nmbcrun::FileError& error) {
        return failed(error, file_failed);
    } catch (const std::system_error& error) {  // standard output cannot be written
        return failed(error, file_failed);
    } catch (const std::bad_alloc&) {
        return failed(
            nmbcrun::SceneError("not enough memory for this scene: fewer domain.nodes need less"),
            bad_input);
    } catch (const std::exception& error) {  // SceneError, and what the runtime refuses
        return failed(error, bad_input);
    }
}

/// Threads that wait soon sleep, unless the user has chosen: where other programs keep the cores
/// busy, planes take up to ten times as long while they spin. OpenMP reads its environment when it
/// is loaded, so the program begins anew with another one; where it cannot, it goes on as it is.
void let_threads_sleep(char** argv) {
    if (std::getenv("OMP_WAIT_POLICY") == nullptr && std::getenv("GOMP_SPINCOUNT") == nullptr &&
        setenv("GOMP_SPINCOUNT", "1000", 0) == 0) {
        execv("/proc/self/exe", argv);
    }
}

}  // namespace

int main(int argc, char** argv) {
    let_threads_sleep(argv);
    nmbcrun::end_at_interrupts(stopped);
    Arguments arguments;
    CLI::App app("nmbcrun: runs scenes with nonlocal matching boundary conditions.", "nmbcrun");
    app.option_defaults()->disable_flag_override();  // of subcommands, too: --quiet=no is none
    app.set_version_flag("--version", "nmbcrun " NMBC_VERSION);
    app.require_subcommand(1);
    app.footer(exit_codes);  // of the subcommands, too, which are added below
    const auto add_command = [&](const std::string& name, const std::string& description) {
        auto* const command = app.add_subcommand(name, description);
        command->add_option("SCENE", arguments.scene, "scene file (TOML, docs/reference/scene.md)")
            ->required()
            ->check(not_empty);
        command
            ->add_option("--set", arguments.settings,
                         "KEY=VALUE, e.g. boundary.order=2: overrides the scene; may be repeated")
            ->allow_extra_args(false);  // the next one is the scene
        command->add_flag("--quiet", arguments.quiet, "no progress bar, only the last lines");
        return command;
    };
    const auto tolerance_of_advice = nmbcgen::number_between(1e-16, 1);  // of all: any end meets it
    auto* const run = add_command("run", "run a scene and report its energies");
    run->add_option("--out", arguments.folder, "folder for the results (default results)")
        ->check(not_empty);
    auto* const resume = run->add_flag("--resume", arguments.resume,
                                       "go on from the checkpoint of a run that was stopped");
    run->add_flag("--plot", arguments.plot,
                  "draw the energies, and what the scene writes of its fields");
    run->add_flag("--keep-checkpoint", arguments.keep_checkpoint,
                  "leave a checkpoint at the end: --resume goes on to a later time.end");
    run->add_option("--tolerance", arguments.tolerance,
                    "take the cheapest ends and time step that advise finds for it, instead of the "
                    "scene's ends")
        ->check(tolerance_of_advice)
        ->excludes(resume);
    auto* const verify = add_command(
        "verify", "compare a scene with the same one without ends (docs/how-to/verify.md)");
    verify
        ->add_option("--tolerance", arguments.tolerance,
                     "largest max |u - u_ref| / max |u_ref| that is right")
        ->required()
        ->check(nmbcgen::number_between(1e-16, 1e16));
    verify->add_flag(
        "--finer", arguments.finer,
        "of a plane: compare with a finer lattice without artificial sides, as is done "
        "where there are none");
    auto* const chart = add_command(
        "chart", "cost and error of every boundary there is for a scene (docs/evidence/chart.md)");
    chart->add_option("--out", arguments.folder, "folder for the results (default results)")
        ->check(not_empty);
    chart
        ->add_option(
            "--long-run", arguments.long_run,
            "steps that each boundary that could add energy is followed through, for its "
            "long-time stability (default 1000000, fewer above 500 nodes; of a plane 20000)")
        ->check(CLI::Range(std::size_t{4000}, std::size_t{1'000'000'000}));
    auto* const advise = add_command(
        "advise", "the smallest model that meets a tolerance (docs/how-to/meet-a-tolerance.md)");
    advise
        ->add_option("--tolerance", arguments.tolerance, "largest error over max |u| that is right")
        ->required()
        ->check(tolerance_of_advice);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return exit_code_of([&] {
            app.exit(help, std::cout, std::cerr);
            std::cout.flush();
            if (!std::cout) {
                throw nmbcrun::FileError("cannot write to standard output");
            }
            return done;
        });
    } catch (const CLI::ParseError& error) {
        std::cerr << "nmbcrun: " << nmbcgen::printable(nmbcgen::problem_of(error, app))
                  << "\nSee nmbcrun --help.\n";
        return bad_input;
    }
    return exit_code_of([&] {
        const std::string text = nmbcrun::read_text(arguments.scene);
        const nmbcrun::Overrides overrides = nmbcrun::split_settings(arguments.settings);
        if (nmbcrun::is_plane_scene(text, arguments.scene, overrides)) {
            return plane_command(app.get_subcommands().front()->get_name(),
                                 nmbcrun::read_plane_scene(text, arguments.scene, overrides),
                                 arguments);
        }
        nmbcrun::Scene scene =
            nmbcrun::with_tables(nmbcrun::read_scene_text(text, arguments.scene, overrides));
        if (verify->parsed()) {
            if (arguments.finer) {
                throw nmbcrun::SceneError("--finer is for planes, and this scene is a chain");
            }
            return nmbcrun::verify(scene, arguments.tolerance, arguments.quiet) ? done
                                                                                : does_not_hold;
        }
        if (run->parsed()) {
            run_as_asked(std::move(scene), arguments);
            return done;
        }
        nmbcrun::note_interrupts();
        if (advise->parsed()) {
            nmbcrun::advise(scene, arguments.tolerance, arguments.quiet, stop_where_interrupted);
        } else {
            nmbcrun::chart(scene, {arguments.folder, arguments.long_run, arguments.quiet});
        }
        return done;
    });
}
