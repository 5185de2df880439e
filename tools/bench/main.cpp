// SPDX-License-Identifier: GPL-2.0-or-later
/// generator_bench: how long the generator takes to derive a condition. tools/bench/generator sets
/// it beside algebra systems.
#include <ginac/ginac.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <functional>
#include <iostream>

#include "generator/matching/matching.hpp"
#include "generator/pipeline.hpp"

namespace {

using nmbcgen::MatchingPolynomials;

// The project's exit codes; the others are not for this program.
enum ExitCode { done = 0, bad_input = 2, no_such_boundary = 3 };

/// System (49) with symbols for a_1, a_3, .. and dX, and the numbers that its answer is checked at,
/// the same as in solve_49.mac, .gp and .py.
struct System {
    explicit System(unsigned order) {
        for (unsigned k = 0; k <= 2 * order; ++k) {
            if (k % 2 == 0) {
                taylor.emplace_back(0);
                continue;
            }
            taylor.emplace_back(GiNaC::symbol("a" + std::to_string(k)));
            numbers[taylor.back()] = GiNaC::numeric(long(k * k % 11) + 1, long(k) + 2);
        }
        numbers[dX] = GiNaC::numeric(3, 7);
    }

    std::vector<GiNaC::ex> taylor;
    GiNaC::ex dX = GiNaC::symbol("dX");
    GiNaC::exmap numbers;
};

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
    const System system(order);
    MatchingPolynomials found;
    time([&] { found = nmbcgen::match(system.taylor, system.dX, order); });
    const GiNaC::ex first = found.C[0].subs(system.numbers);
    for (const auto* list : {&found.C, &found.B}) {
        for (const GiNaC::ex& coefficient : *list) {
            std::cout << "value " << coefficient.subs(system.numbers) / first << "\n";
        }
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
