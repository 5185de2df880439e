// SPDX-License-Identifier: GPL-2.0-or-later
/// What sponges and perfectly matched layers send back of a smooth pulse, by their width.
#include <cmath>
#include <utility>

#include "tests/nmbcrun/chains.hpp"
#include "tools/nmbcrun/ends/pml.hpp"
#include "tools/nmbcrun/ends/sponge.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace {

using nmbcrun::PmlEnd;
using nmbcrun::SpongeEnd;

/// Of u = exp(-(x/10)^2), v = 0 in the middle of 400 nodes, when the echoes from both far ends are
/// back in the interior, 60 dX from where the layers begin.
double energy_left(const nmbc::Lattice& lattice, const nmbc::ChainEnd& end, std::size_t layer) {
    nmbc::Chain chain(lattice, end, {.nodes = 400, .time_step = step_of(lattice, 0.5)});
    std::vector<double> u(chain.nodes());
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double x = (double(i) - double(u.size() - 1) / 2) / 10;
        u[i] = std::exp(-x * x);
    }
    chain.start(u, std::vector<double>(chain.nodes()));
    chain.step();
    const double first = nmbc::energies(chain).total();
    while (chain.time() < 200 + 2 * double(layer) + 60) {
        chain.step();
    }
    return nmbc::energies(chain).total() / first;
}

TEST_CASE("wider layers send less back, and a pml less than a sponge") {
    for (const auto& [horizon, G] : {std::pair(1, 0.5), std::pair(2, 1.0)}) {
        const auto lattice = lattice_of(horizon, G);
        double sponge_before = 1;
        double pml_before = 1;
        for (const std::size_t layer : {5U, 10U, 20U, 50U, 100U}) {
            const double sponge = energy_left(lattice, SpongeEnd{{layer, 2, 1e-2}}, layer);
            const double pml = energy_left(lattice, PmlEnd{{layer, 2, 1e-4}}, layer);
            MESSAGE("n = ", horizon, ", G = ", G, ", ", layer, " nodes: sponge ", sponge, ", pml ",
                    pml);
            // 2.05 times less at least from one width to the next, as measured
            CHECK(sponge < sponge_before / 2);
            // and 4 times; 200 times of 5 nodes to 100 nodes
            CHECK(pml < pml_before / 3);
            CHECK(pml < sponge / 30);
            sponge_before = sponge;
            pml_before = pml;
        }
        CHECK(sponge_before < 1.2e-3);
        CHECK(pml_before < 1e-8);  // target^2
    }
}

TEST_CASE("the default targets leave less than twice as much as the best power of ten") {
    const double sponge_target = nmbcrun::target_of({.kind = nmbcrun::BoundaryKind::sponge});
    const double pml_target = nmbcrun::target_of({.kind = nmbcrun::BoundaryKind::pml});
    for (const auto& [horizon, G] : {std::pair(1, 0.5), std::pair(2, 1.0)}) {
        const auto lattice = lattice_of(horizon, G);
        for (const std::size_t layer : {10U, 20U, 50U}) {
            double best_sponge = 1;
            double best_pml = 1;
            for (double target = 0.1; target > 1e-9; target /= 10) {
                best_sponge = std::min(best_sponge,
                                       energy_left(lattice, SpongeEnd{{layer, 2, target}}, layer));
                best_pml =
                    std::min(best_pml, energy_left(lattice, PmlEnd{{layer, 2, target}}, layer));
            }
            CAPTURE(lattice.reach());
            CAPTURE(layer);
            // As said: 1.14 and 1.83 times at most
            CHECK(energy_left(lattice, SpongeEnd{{layer, 2, sponge_target}}, layer) <
                  2 * best_sponge);
            CHECK(energy_left(lattice, PmlEnd{{layer, 2, pml_target}}, layer) < 2 * best_pml);
        }
    }
}

TEST_CASE("a layer of 100 nodes sends back the target, where that is not small") {
    const auto lattice = lattice_of(1, 0.5);
    // target^2, 8 % less of a pulse whose shortest waves are slower than c, and 10 % more where a
    // sponge scatters long ones
    CHECK(energy_left(lattice, PmlEnd{{100, 2, 0.1}}, 100) ==
          doctest::Approx(0.01).scale(0).epsilon(0.1));
    CHECK(energy_left(lattice, SpongeEnd{{100, 2, 0.1}}, 100) ==
          doctest::Approx(0.01).scale(0).epsilon(0.1));
}

}  // namespace
