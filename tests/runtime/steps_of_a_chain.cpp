// SPDX-License-Identifier: GPL-2.0-or-later
/// So many steps of a chain, for run_instructions.sh to count what they take.
/// Usage: steps_of_a_chain double|float HORIZON ORDER STEPS; order 0: ends that do nothing
#include <cstdlib>
#include <iostream>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <string>

namespace {

template <class Real>
void run(int horizon, int order, std::size_t steps) {
    constexpr double G = 0.9;
    const auto* table =
        nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, order == 0 ? 1 : order);
    if (table == nullptr) {
        throw std::runtime_error("no such table");
    }
    nmbc::BasicChainEnd<Real> end = nmbc::IdleEnd{};
    if (order > 0) {
        end = nmbc::MatchingEnd{nmbc::boundary_coefficients(*table, G, nmbc::allow_unstable)};
    }
    nmbc::BasicChain<Real> chain(nmbc::make_lattice(*table, G), end,
                                 {.nodes = 4000, .time_step = 0.1});
    chain.advance(steps);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::cerr << "usage: steps_of_a_chain double|float HORIZON ORDER STEPS\n";
        return 2;
    }
    const auto steps = std::size_t(std::atoi(argv[4]));
    if (std::string(argv[1]) == "float") {
        run<float>(std::atoi(argv[2]), std::atoi(argv[3]), steps);
    } else {
        run<double>(std::atoi(argv[2]), std::atoi(argv[3]), steps);
    }
}
