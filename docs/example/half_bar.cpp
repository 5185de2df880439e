// SPDX-License-Identifier: MIT
/// Half of a bar: its left end is a physical one, free, and its right end is where the model stops
/// and the bar does not. The library's own chain runs it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/nopd1d_n2_order1_s2.hpp>
#include <vector>

namespace {

constexpr double G = 1.5;
constexpr std::size_t half = 300;  // nodes
const nmbc::MatchingTable& table = nmbc::generated::nopd1d_n2_order1_s2;

/// Starts a pulse at a distance [dX] from the first interior node, on all nodes.
void start(nmbc::Chain& chain, double middle) {
    std::vector<double> u(chain.nodes());
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double x = double(i) - double(chain.first_interior()) - middle;
        u[i] = std::exp(-x * x / 200);
    }
    chain.start(u, std::vector<double>(u.size()));
}

}  // namespace

int main() {
    const nmbc::Lattice lattice = nmbc::make_lattice(table, G);
    const nmbc::ChainEnd free_end = nmbc::FreeEnd{};

    // Most conditions are certified with their like at the other end. Here a free end is there, off
    // which every wave comes back: ask for a condition that is stable opposite any end which adds
    // no energy, and for the time step of that. The chain refuses the other kind.
    using nmbc::Opposite;
    const double dt = nmbc::stable_time_step(table, G, 1, 1, Opposite::any);
    const nmbc::ChainParameters parameters{.nodes = half, .time_step = dt};
    try {
        const nmbc::MatchingEnd like{nmbc::boundary_coefficients(table, G)};
        nmbc::Chain(lattice, free_end, like, parameters);
    } catch (const nmbc::NotCertified& reason) {
        std::printf("refused: %s\n", reason.what());
    }
    const nmbc::MatchingEnd absorbing{nmbc::boundary_coefficients(table, G, Opposite::any)};

    // A free end is a mirror, half a spacing outside of the first node. So this is also half of a
    // symmetric bar that is twice as long, and the pulse on the mirror is half of one in its
    // middle.
    nmbc::Chain bar(lattice, free_end, absorbing, parameters);
    start(bar, -0.5);
    nmbc::Chain whole(lattice, absorbing, {.nodes = 2 * half, .time_step = dt});
    start(whole, half - 0.5);

    const double first = nmbc::energies(bar).total();
    double apart = 0;
    for (const double t : {100.0, 200.0, 400.0, 800.0}) {
        const std::size_t steps = std::size_t(t / dt) - bar.steps();
        bar.advance(steps);
        whole.advance(steps);
        for (std::size_t i = 0; i < half; ++i) {
            apart = std::max(apart, std::abs(bar.displacement()[bar.ghosts() + i] -
                                             whole.displacement()[bar.ghosts() + half + i]));
        }
        std::printf("t = %3.0f dX/c: %.0e of the energy is left\n", t,
                    nmbc::energies(bar).total() / first);
    }
    std::printf("half and whole bar differ by %s\n", apart < 1e-13 ? "roundings" : "more");
}
