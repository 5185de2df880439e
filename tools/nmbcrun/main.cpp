// SPDX-License-Identifier: MIT
/// nmbcrun: runs a scene and reports its energies.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <new>
#include <nmbc/coefficients.hpp>
#include <system_error>

#include "tools/nmbcrun/output/interrupt.hpp"
#include "tools/nmbcrun/run.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace {

// The project's exit codes; 1 (a comparison did not hold) is not for `run`.
enum ExitCode {
    done = 0,
    bad_input = 2,
    no_such_boundary = 3,
    unstable = 4,
    file_failed = 5,
    stopped = 130
};

struct Arguments {
    std::string scene;
    std::vector<std::string> settings;
    std::string folder = "results";
    bool quiet = false;
    bool resume = false;
};

nmbcrun::Overrides split_settings(const std::vector<std::string>& settings) {
    nmbcrun::Overrides overrides;
    for (const std::string& setting : settings) {
        const std::size_t mark = setting.find('=');
        if (mark == 0 || mark == std::string::npos) {
            throw nmbcrun::SceneError("--set needs KEY=VALUE, not '" + setting + "'");
        }
        overrides.emplace_back(setting.substr(0, mark), setting.substr(mark + 1));
    }
    return overrides;
}

int run(const Arguments& arguments) {
    const auto failed = [](const std::exception& error, ExitCode code) {
        std::cerr << "nmbcrun: " << error.what() << "\n";
        return code;
    };
    try {
        nmbcrun::run(nmbcrun::read_scene(arguments.scene, split_settings(arguments.settings)),
                     {arguments.folder, arguments.quiet, arguments.resume});
        if (std::fflush(stdout) != 0) {
            throw nmbcrun::FileError("cannot write to standard output");
        }
        return done;
    } catch (const nmbcrun::SceneError& error) {
        return failed(error, bad_input);
    } catch (const std::invalid_argument& error) {
        return failed(error, bad_input);
    } catch (const nmbc::CoefficientError& error) {
        return failed(error, no_such_boundary);
    } catch (const nmbcrun::Unstable& error) {
        return failed(error, unstable);
    } catch (const nmbcrun::Interrupted& error) {
        return failed(error, stopped);
    } catch (const nmbcrun::FileError& error) {
        return failed(error, file_failed);
    } catch (const std::system_error& error) {  // standard output cannot be written
        return failed(error, file_failed);
    } catch (const std::bad_alloc&) {
        return failed(nmbcrun::SceneError("not enough memory for this scene"), bad_input);
    }
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("nmbcrun: runs scenes with nonlocal matching boundary conditions.", "nmbcrun");
    app.set_version_flag("--version", "nmbcrun " NMBC_VERSION);
    app.require_subcommand(1);
    auto* const command = app.add_subcommand("run", "run a scene and report its energies");
    command->add_option("SCENE", arguments.scene, "scene file (TOML, docs/scenes.md)")->required();
    command
        ->add_option("--set", arguments.settings,
                     "KEY=VALUE, e.g. boundary.order=2: overrides the scene; may be repeated")
        ->expected(1)
        ->take_all();
    command->add_option("--out", arguments.folder, "folder for the results (default results)");
    command->add_flag("--quiet", arguments.quiet, "no progress bar, only the last lines");
    command->add_flag("--resume", arguments.resume,
                      "go on from the checkpoint of a run that was stopped");
    app.footer(
        "Exit codes: 0 done; 2 wrong arguments or scene; 3 there is no such boundary condition;\n"
        "4 the ends are not stable together, or the run became non-finite or had no energy;\n"
        "5 a file could not be read or written.");
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help, std::cout, std::cerr);
    } catch (const CLI::ParseError& error) {
        std::cerr << "nmbcrun: " << error.what() << "\nSee nmbcrun --help.\n";
        return bad_input;
    }
    nmbcrun::note_interrupts();
    return run(arguments);
}
