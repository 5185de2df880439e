// SPDX-License-Identifier: GPL-2.0-or-later
/// generator_bench: how long the generator takes to derive a condition. tools/bench/generator sets
/// it beside algebra systems.
#include <CLI/CLI.hpp>
#include <ctime>
#include <functional>
#include <iostream>

#include "generator/matching/symbolic_system.hpp"
#include "generator/pipeline.hpp"
#include "generator/support/exit_code.hpp"

namespace {

using enum nmbcgen::ExitCode;

/// Prints the processor time of one call, the mean of as many as take a fifth of a second.
void time(const std::function<void()>& work) {
    constexpr double enough = 0.2;
    const std::clock_t start = std::clock();
    int calls = 0;
    double seconds = 0;
    do {
        work();
        ++calls;
        seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    } while (seconds < enough);
    std::cout << "seconds " << seconds / calls << "\n";
}

void solve(unsigned order) {
    nmbcgen::SymbolicSystem system(order);
    time([&system] { system.solve(); });
    for (const nmbcgen::Rational& value : system.values()) {
        std::cout << "value " << value << "\n";
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("generator_bench: processor time of deriving a condition.", "generator_bench");
    app.require_subcommand(1);
    unsigned order = 1;
    nmbcgen::Specification what;
    auto* const symbolic =
        app.add_subcommand("solve", "system (49), everything symbolic; prints c and b at numbers");
    auto* const table = app.add_subcommand("derive", "a table of nopd1d, with its proof");
    for (CLI::App* command : {symbolic, table}) {
        command->add_option("--order", order, "order N, 1 to 32")
            ->check(CLI::Range(1, 32))
            ->required();
    }
    table->add_option("--horizon", what.horizon, "horizon n, 1 to 5")->check(CLI::Range(1, 5));
    bool fixed = false;
    table->add_flag("--fixed", fixed, "at G = 9/7 instead of every G");
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help, std::cout, std::cerr);
    } catch (const CLI::ParseError& error) {
        std::cerr << "generator_bench: " << error.what() << "\nSee generator_bench --help.\n";
        return bad_input;
    }
    if (symbolic->parsed()) {
        solve(order);
        return done;
    }
    what.order = order;
    if (fixed) {
        what.stabilisation = nmbcgen::Rational(9, 7);
    }
    try {
        time([&what] { nmbcgen::derive(what); });
    } catch (const nmbcgen::NoSuchBoundary& reason) {
        std::cerr << "generator_bench: " << reason.what() << "\n";
        return no_such_boundary;
    }
    return done;
}
