// SPDX-License-Identifier: MIT
/// pulses: the energy that boundaries leave of a free Gaussian pulse (docs/pulses.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "tools/number_between.hpp"
#include "tools/pulses/fraction.hpp"
#include "tools/pulses/report.hpp"

namespace {

// The project's exit codes; the others are not for this program.
enum ExitCode { done = 0, bad_input = 2, file_failed = 5 };

/// What is wrong with a G, for CLI11; empty: nothing.
std::string fault_of_G(const std::string& text) {
    const auto value = pulses::fraction(text);
    constexpr double most = 1e6;
    return value && *value >= 0 && *value <= most
               ? std::string()
               : fmt::format("{} is no G: 0 to {:g}, as in 1/4 or 0.25, is allowed", text, most);
}

}  // namespace

int main(int argc, char** argv) {
    pulses::Question question{{1, 2, 3, 4}, {"0", "1/4", "1/2", "1", "3/2", "2"}, {4, 10, 20}};
    CLI::App app("pulses: the energy that boundaries leave of a free Gaussian pulse, as Markdown.",
                 "pulses");
    app.set_version_flag("--version", "pulses " NMBC_VERSION);
    app.add_option("--horizons", question.horizons, "horizons n, 1 to 5 (default 1 to 4)")
        ->check(CLI::Range(1, 5))
        ->delimiter(',');
    app.add_option("--G", question.values, "values of G, >= 0 (default 0,1/4,1/2,1,3/2,2)")
        ->check(CLI::Validator(fault_of_G, "G"))
        ->delimiter(',');
    app.add_option("--half-widths", question.half_widths,
                   "w of u = exp(-(x/w)^2) in dX, 2 to 50 (default 4,10,20)")
        ->check(tools::number_between(2, 50))
        ->delimiter(',');
    app.add_option("--cfl", question.cfl,
                   "steps of this cfl, 0.01 to 1, where 0.95 of the certified one is not less "
                   "(default 1: always 0.95 of the certified one)")
        ->check(tools::number_between(0.01, 1));
    app.add_flag("--matched", question.matched,
                 "order 2 or more matched in time steps of n/2 dX/c, NMBC1 in the same steps")
        ->excludes("--cfl");
    app.footer("Exit codes: 0 done; 2 wrong arguments; 5 the output could not be written.");
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help, std::cout, std::cerr);
    } catch (const CLI::ParseError& error) {
        std::cerr << "pulses: " << error.what() << "\nSee pulses --help.\n";
        return bad_input;
    }
    std::cout << pulses::report(question) << std::flush;
    if (!std::cout) {
        std::cerr << "pulses: standard output could not be written\n";
        return file_failed;
    }
    return done;
}
