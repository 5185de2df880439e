// SPDX-License-Identifier: GPL-2.0-or-later
/// stability_atlas: where which boundary condition is stable, which tools/scripts/atlas draws.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <filesystem>
#include <iostream>
#include <system_error>

#include "generator/support/exit_code.hpp"
#include "generator/support/files.hpp"
#include "generator/support/number_between.hpp"
#include "tools/nmbcrun/terminal/progress.hpp"
#include "tools/stability_atlas/atlas.hpp"
#include "tools/stability_atlas/choices.hpp"
#include "tools/stability_atlas/csv.hpp"

namespace {

using enum nmbcgen::ExitCode;

struct Arguments {
    std::vector<unsigned> horizons{1, 2, 3, 4};
    unsigned points = 121;
    std::string folder = "results/atlas";
    std::vector<unsigned> choice_horizons{1, 2, 3, 4, 5};
    std::vector<double> values{0, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4, 6};
};

/// Before the work, not after it.
void require_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && ::access(folder.c_str(), W_OK) != 0) {
        error.assign(errno, std::generic_category());
    }
    if (error) {
        throw nmbcgen::FileError("cannot write to the folder " + folder.string() + ": " +
                                 error.message());
    }
}

void write_atlas(const Arguments& arguments) {
    const std::filesystem::path folder = arguments.folder;
    require_folder(folder);
    nmbcrun::Progress progress(stability_atlas::total_points(arguments.horizons, arguments.points),
                               false);
    const auto methods =
        stability_atlas::atlas(arguments.horizons, arguments.points,
                               [&progress](std::size_t count) { progress.update(count); });
    nmbcgen::write_files({{folder / "points.csv", stability_atlas::points_csv(methods)},
                          {folder / "windows.csv", stability_atlas::windows_csv(methods)}});
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("stability_atlas: where which matching boundary condition is stable.",
                 "stability_atlas");
    app.set_version_flag("--version", "stability_atlas " NMBC_VERSION);
    app.require_subcommand(1);
    auto* const atlas = app.add_subcommand(
        "atlas", "write points.csv and windows.csv: orders 1 to 4, strides 1 and n, G from 0 to 6");
    atlas->add_option("--horizon", arguments.horizons, "horizons n, 1 to 4 (default all)")
        ->check(CLI::Range(1, 4))
        ->delimiter(',');
    atlas->add_option("--points", arguments.points, "values of G (default 121)")
        ->check(CLI::Range(2, 10000));
    atlas->add_option("--out", arguments.folder, "folder to write to (default results/atlas)");
    auto* const choices = app.add_subcommand(
        "choices",
        "print the largest stable cfl of the committed tables as Markdown: empty where unstable, "
        "bold what any other end that adds no energy allows");
    choices->add_option("--horizon", arguments.choice_horizons, "horizons n, 1 to 5 (default all)")
        ->check(CLI::Range(1, 5))
        ->delimiter(',');
    choices->add_option("--G", arguments.values, "values of G, decimal numbers (default 0 to 6)")
        ->check(nmbcgen::number_between(0, 1e6))
        ->delimiter(',');
    app.footer("Exit codes: 0 done; 2 wrong arguments; 5 a file could not be written.");
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help, std::cout, std::cerr);
    } catch (const CLI::ParseError& error) {
        std::cerr << "stability_atlas: " << error.what() << "\nSee stability_atlas --help.\n";
        return bad_input;
    }
    try {
        if (atlas->parsed()) {
            write_atlas(arguments);
        } else {
            nmbcgen::print(stability_atlas::choices(arguments.choice_horizons, arguments.values));
        }
    } catch (const nmbcgen::FileError& error) {
        std::cerr << "stability_atlas: " << error.what() << "\n";
        return file_failed;
    }
    return done;
}
