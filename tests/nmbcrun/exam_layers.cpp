// SPDX-License-Identifier: GPL-2.0-or-later
/// Sponge and perfectly matched layer: the energy falls, whatever the lattice, and what they
/// refuse.
#include <array>
#include <cmath>
#include <limits>

#include "tests/nmbcrun/chains.hpp"
#include "tools/nmbcrun/ends/pml.hpp"
#include "tools/nmbcrun/ends/sponge.hpp"

namespace {

using nmbc::LossLayer;
using nmbcrun::PmlEnd;
using nmbcrun::SpongeEnd;
using Squares = std::vector<nmbc::Lattice::Square>;

/// sum_i stencil[i] field[node + i - half width], nothing beyond the field.
double apply(const std::vector<double>& stencil, const std::vector<double>& field,
             std::size_t node) {
    const std::size_t half = stencil.size() / 2;
    double sum = 0;
    for (std::size_t i = 0; i < stencil.size(); ++i) {
        const std::size_t at = node + i;
        sum += at < half || at - half >= field.size() ? 0 : stencil[i] * field[at - half];
    }
    return sum;
}

/// sum v^2/2 + sum (p^2/w - dt p L v)/2 of a chain (E = rho = dX = 1) between two perfectly matched
/// layers of so many nodes.
double pml_energy(const nmbc::Chain& chain, const Squares& squares, std::size_t layer) {
    const auto state = chain.state();
    const double dt = chain.parameters().time_step;
    const std::size_t nodes = chain.nodes();
    double energy = 0;
    for (const double v : state.velocity) {
        energy += v * v / 2;
    }
    std::size_t left = layer;  // the velocities come first in what an end remembers
    std::size_t right = layer;
    for (const auto& [part, weight, stencil] : squares) {
        const std::size_t first = chain.ghosts() - stencil.size() / 2;
        const std::size_t interior = chain.first_interior();
        const auto add = [&, w = weight, &entries = stencil](std::size_t node, double p) {
            energy += p * (p / w - dt * apply(entries, state.velocity, node)) / 2;
        };
        for (std::size_t node = first; node < interior; ++node) {
            add(node, state.left[left++]);
        }
        for (std::size_t node = interior; node + interior < nodes; ++node) {
            add(node, weight * apply(stencil, state.displacement, node));
        }
        // The right end has the squares from its own side: the mirror image, at the same place.
        auto mirrored = stencil;
        std::ranges::reverse(mirrored);
        for (std::size_t node = first; node < interior; ++node) {
            const double p = state.right[right++];
            const double rate = apply(mirrored, state.velocity, nodes - 1 - node);
            energy += p * (p / weight - dt * rate) / 2;
        }
    }
    CHECK(left == state.left.size());
    CHECK(right == state.right.size());
    return energy;
}

/// What leapfrog keeps of a chain between fixed ends: v.v/2 + u^k.K u^{k+1}/2, with K u = -a.
double leapfrog_energy(const nmbc::Chain& chain) {
    std::vector<double> a(chain.nodes());
    nmbc::accelerations(chain.lattice(), 1, chain.displacement(), a);
    double energy = 0;
    for (std::size_t i = 0; i < chain.nodes(); ++i) {
        const double v = chain.velocity()[i];
        const double before = chain.displacement()[i] - chain.parameters().time_step * v;
        energy += v * v / 2 - before * a[i] / 2;
    }
    return energy;
}

/// The atom chain, whose only square is not its own mirror image.
nmbc::Lattice atom_chain() {
    return {{2, -1}, {{nmbc::EnergyPart::strain, 1, {0, -1, 1}}}, {}};
}

Squares halves_of_atom_chain() {
    return {{nmbc::EnergyPart::strain, 0.5, {0, -1, 1}},
            {nmbc::EnergyPart::strain, 0.5, {1, -1, 0}}};
}

/// Random motion: in every step the energy falls, up to roundings of the sum. Returns what is left.
template <class Energy>
double left_after(nmbc::Chain& chain, int steps, Energy&& energy_of) {
    start_at_random(chain);
    chain.step();
    const double first = energy_of(chain);
    double before = first;
    int rises = 0;
    for (int step = 1; step < steps; ++step) {
        chain.step();
        const double energy = energy_of(chain);
        // p u and v of some 100 nodes, of the size of the start at most: 1e3 eps = 2e-13
        rises += int(energy > before + 1e-12 * first);
        before = energy;
    }
    CHECK(rises == 0);
    return before / first;
}

constexpr std::array stabilisations{0.0, 0.1, 0.25, 1.0, 3.0};  // at n = 1, 0.1: backward waves
constexpr std::array targets{0.5, 1e-4, 1e-300};

TEST_CASE("every step takes energy from a pml and adds none") {
    for (int horizon = 1; horizon <= 5; ++horizon) {
        for (const double G : stabilisations) {
            for (const double target : targets) {
                for (const std::size_t layer : {1U, 12U}) {
                    for (const double cfl : {0.05, 0.5, 0.99}) {
                        CAPTURE(horizon);
                        CAPTURE(G);
                        CAPTURE(target);
                        CAPTURE(layer);
                        CAPTURE(cfl);
                        const auto lattice = lattice_of(horizon, G);
                        const PmlEnd end{{layer, 2, target}};
                        nmbc::Chain chain(lattice, end,
                                          {.nodes = 30, .time_step = step_of(lattice, cfl)});
                        CHECK(left_after(chain, 200, [&](const nmbc::Chain& now) {
                                  return pml_energy(now, lattice.energy, layer);
                              }) < 1);
                    }
                }
            }
        }
    }
}

TEST_CASE("squares that are not their own mirror image: both images, half of each") {
    for (const double target : targets) {
        nmbc::Chain chain(atom_chain(), PmlEnd{{12, 2, target}},
                          {.nodes = 30, .time_step = step_of(atom_chain(), 0.99)});
        CHECK(left_after(chain, 500, [](const nmbc::Chain& now) {
                  return pml_energy(now, halves_of_atom_chain(), 12);
              }) < 1);
    }
}

TEST_CASE("every step takes energy from a sponge and adds none") {
    for (int horizon = 1; horizon <= 5; ++horizon) {
        for (const double G : stabilisations) {
            for (const double target : targets) {
                const auto lattice = lattice_of(horizon, G);
                nmbc::Chain chain(lattice, SpongeEnd{{12, 2, target}},
                                  {.nodes = 30, .time_step = step_of(lattice, 0.99)});
                CAPTURE(horizon);
                CAPTURE(G);
                CAPTURE(target);
                CHECK(left_after(chain, 500, leapfrog_energy) < 1);
            }
        }
    }
}

/// Whether 1e5 steps from random numbers of size 1 leave them of that size.
void check_bounded(const nmbc::Lattice& lattice, const nmbc::ChainEnd& end, double cfl) {
    nmbc::Chain chain(lattice, end, {.nodes = 12, .time_step = step_of(lattice, cfl)});
    start_at_random(chain);
    for (int step = 0; step < 100000; ++step) {
        chain.step();
    }
    const auto state = chain.state();
    for (std::size_t node = 0; node < chain.nodes(); ++node) {
        // No energy is added, and the velocities of the start are up to 3.
        CHECK(std::abs(state.velocity[node]) < 10);
        // Where u comes to rest in a layer costs no energy: 438 at n = 4, G = 0.
        CHECK(std::abs(state.displacement[node]) < 1000);
    }
}

TEST_CASE("100000 steps from a random state stay bounded") {
    for (int horizon = 1; horizon <= 4; ++horizon) {
        for (const double G : {0.0, 0.1, 3.0}) {
            const auto lattice = lattice_of(horizon, G);
            CAPTURE(horizon);
            CAPTURE(G);
            check_bounded(lattice, PmlEnd{{4, 2, 1e-4}}, 0.99);
            check_bounded(lattice, SpongeEnd{{4, 2, 1e-2}}, 0.99);
        }
    }
}

TEST_CASE("a damped lattice keeps its damping in the layer") {
    auto lattice = lattice_of(2, 1);
    // tau sigma with tau = 1/10: the stabilisation's part of the symbol at G = 1.
    const auto without = lattice_of(2, 0);
    for (std::size_t m = 0; m < lattice.symbol.size(); ++m) {
        lattice.damping.push_back((lattice.symbol[m] - without.symbol[m]) / 10);
    }
    const double cfl = 0.99 * nmbc::interior_cfl(lattice);
    check_bounded(lattice, PmlEnd{{4, 2, 1e-4}}, cfl);
    check_bounded(lattice, SpongeEnd{{4, 2, 1e-2}}, cfl);
}

TEST_CASE("without loss a layer is more of the lattice") {
    std::vector<nmbc::Lattice> lattices{atom_chain()};
    for (int horizon = 1; horizon <= 5; ++horizon) {
        lattices.push_back(lattice_of(horizon, 0.7));
    }
    const LossLayer no_loss{9, 2, 1 - 0x1p-53};
    for (const auto& lattice : lattices) {
        for (const nmbc::ChainEnd& end :
             {nmbc::ChainEnd(PmlEnd{no_loss}), nmbc::ChainEnd(SpongeEnd{no_loss})}) {
            const nmbc::ChainParameters parameters{.nodes = 20,
                                                   .spacing = 0.5,
                                                   .youngs_modulus = 3,
                                                   .density = 2,
                                                   .time_step = step_of(lattice, 0.2)};
            nmbc::Chain chain(lattice, end, parameters);
            nmbc::Chain extended(lattice, nmbc::FixedEnd{9}, parameters);
            start_at_random(chain);
            start_at_random(extended);
            for (int step = 0; step < 200; ++step) {
                chain.step();
                extended.step();
            }
            for (std::size_t node = 0; node < chain.nodes(); ++node) {
                // Loss of 1e-15 and 200 steps of roundings of a sum of some 10 terms
                CHECK(chain.displacement()[node] ==
                      doctest::Approx(extended.displacement()[node]).epsilon(1e-11));
            }
        }
    }
}

TEST_CASE("layers that there cannot be") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto lattice = lattice_of(1, 1);
    const nmbc::ChainParameters parameters{.nodes = 20, .time_step = 0.1};
    for (const LossLayer& layer :
         {LossLayer{0, 2, 0.1}, LossLayer{5, -1, 0.1}, LossLayer{5, nan, 0.1}, LossLayer{5, 2, 0},
          LossLayer{5, 2, 1}, LossLayer{5, 2, nan}}) {
        CHECK_THROWS_AS(nmbc::Chain(lattice, SpongeEnd{layer}, parameters), std::invalid_argument);
        CHECK_THROWS_AS(nmbc::Chain(lattice, PmlEnd{layer}, parameters), std::invalid_argument);
    }
    auto negative = lattice;
    negative.energy.back().weight = -0.1;
    CHECK_THROWS_WITH_AS(nmbc::Chain(negative, PmlEnd{{5, 2, 0.1}}, parameters),
                         doctest::Contains("negative weight"), std::invalid_argument);
    auto none = lattice;
    none.energy.clear();
    CHECK_THROWS_AS(nmbc::Chain(none, PmlEnd{{5, 2, 0.1}}, parameters), std::invalid_argument);
    CHECK_NOTHROW(nmbc::Chain(none, SpongeEnd{{5, 2, 0.1}}, parameters));
}

}  // namespace
