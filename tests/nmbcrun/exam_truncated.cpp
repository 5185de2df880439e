// SPDX-License-Identifier: GPL-2.0-or-later
/// The matching boundary with the edge effect: its forces are those of the truncated energy.
#include <cmath>

#include "tests/nmbcrun/chains.hpp"
#include "tools/nmbcrun/ends/truncated.hpp"

namespace {

nmbcrun::TruncatedEnd truncated(int horizon, double G) {
    return {nmbc::boundary_coefficients(table_of(horizon), G, nmbc::allow_unstable)};
}

/// The energy [E/dX] of all squares whose family is in the first 4n+1 existing nodes, families cut
/// off at the first of them.
double truncated_energy(const std::vector<double>& u, int n, double G) {
    double energy = 0;
    for (int I = 0; I + n < int(u.size()); ++I) {
        const int first = std::max(I - n, 0);
        double shape = 0;
        double strain = 0;
        for (int J = first; J <= I + n; ++J) {
            shape += (J - I) * (J - I);
            strain += (J - I) * (u[std::size_t(J)] - u[std::size_t(I)]);
        }
        strain /= shape;
        energy += strain * strain / 2;
        for (int J = first; J <= I + n; ++J) {
            const double z = u[std::size_t(J)] - u[std::size_t(I)] - (J - I) * strain;
            energy += 2 * G / (std::pow(n, 3) * (I + n - first)) * z * z / 2;
        }
    }
    return energy;
}

/// v after a step from rest, by dt: the accelerations, of nodes that are no ghosts.
std::vector<double> accelerations_of(nmbc::Chain& chain, const std::vector<double>& u) {
    auto state = chain.state();
    state.displacement = u;
    chain.resume(state);
    chain.step();
    std::vector<double> a(chain.velocity().begin(), chain.velocity().end());
    for (double& value : a) {
        value /= chain.parameters().time_step;
    }
    return a;
}

TEST_CASE("n = 1, G = 0: the outermost interior node has (4 u0 - 5 u1 + u3)/4") {
    nmbc::Chain chain(lattice_of(1, 0), truncated(1, 0), {.nodes = 12, .time_step = 0.1});
    const auto u = random_field(chain.nodes(), 3);  // entry 0 is the ghost that is not used
    const auto a = accelerations_of(chain, u);
    const double derived = (4 * u[1] - 5 * u[2] + u[4]) / 4;
    const double printed = (3 * u[1] - 4 * u[3] + u[4]) / 4;  // (59)
    CHECK(a[2] == doctest::Approx(derived).epsilon(1e-13));   // some 10 roundings
    CHECK(std::abs(a[2] - printed) > 0.1);
}

TEST_CASE("the force on every node is that of the truncated energy, on both sides") {
    for (int n = 1; n <= 5; ++n) {
        for (const double G : {0.0, 0.8}) {
            nmbc::Chain chain(lattice_of(n, G), truncated(n, G), {.nodes = 30, .time_step = 0.1});
            const auto random = random_field(chain.nodes(), 4);
            auto a = accelerations_of(chain, random);
            auto all = random;
            for (const bool right : {false, true}) {
                if (right) {
                    std::ranges::reverse(a);
                    std::ranges::reverse(all);
                }
                const std::vector<double> u(all.begin() + n, all.begin() + std::ptrdiff_t(6) * n);
                for (int node = n; node < 3 * n; ++node) {  // interior; squares in reach of u
                    auto more = u;
                    auto less = u;
                    more[std::size_t(node)] += 1;
                    less[std::size_t(node)] -= 1;
                    // Of a quadratic function the central difference is the derivative.
                    const double force =
                        -(truncated_energy(more, n, G) - truncated_energy(less, n, G)) / 2;
                    CAPTURE(n);
                    CAPTURE(node);
                    // Sums of some 100 terms of size 1 to 10
                    CHECK(std::abs(a[std::size_t(node + n)] - force) < 1e-12);
                }
            }
        }
    }
}

TEST_CASE("lattices that it does not know") {
    const nmbc::ChainParameters parameters{.nodes = 20, .time_step = 0.1};
    auto damped = lattice_of(2, 1);
    damped.damping = damped.symbol;
    auto other = lattice_of(2, 1);
    other.energy.back().stencil[0] += 0.01;
    const nmbc::Lattice atoms{{2, -1}, {{nmbc::EnergyPart::strain, 1, {0, -1, 1}}}, {}};
    for (const auto& lattice : {damped, other, atoms}) {
        CHECK_THROWS_WITH_AS(nmbc::Chain(lattice, truncated(2, 1), parameters),
                             doctest::Contains("of constant model.influence"),
                             std::invalid_argument);
    }
    CHECK_THROWS_AS(nmbc::Chain(lattice_of(3, 1), truncated(3, 1), {.nodes = 2, .time_step = 0.1}),
                    std::invalid_argument);
}

}  // namespace
