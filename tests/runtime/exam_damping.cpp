// SPDX-License-Identifier: GPL-2.0-or-later
/// A damped lattice: what it takes from a wave, where that energy is counted, and in what units.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <numbers>
#include <random>

namespace {

using nmbc::generated::nopd1d_n1_order1;

/// n = 1, tau = 1/4: sigma = 2 (1 - cos xi)^2 = 3 - 2 (z + 1/z) + (z^2 + z^-2)/2, of order xi^4,
/// so that a_1 .. a_3 and with them NMBC1 are those of the undamped lattice.
constexpr nmbc::RationalFunction quarter_sigma[]{{"3", "4"}, {"-1", "2"}, {"1", "8"}};

constexpr nmbc::LatticeTable damped_bonds = [] {
    nmbc::LatticeTable lattice = *nopd1d_n1_order1.lattice;
    lattice.name = "nopd1d_n1_tau1o4";
    lattice.tau = "1/4";
    lattice.damping = quarter_sigma;
    return lattice;
}();

constexpr nmbc::MatchingTable damped_table = [] {
    nmbc::MatchingTable table = nopd1d_n1_order1;
    table.name = "nopd1d_n1_order1_tau1o4";
    table.lattice = &damped_bonds;
    table.contractive = {};
    table.least_nodes = 50;
    return table;
}();

/// The lattice at G with the damping tau times what the symbol gains from G = 0 to 1.
nmbc::Lattice damped_lattice(int horizon, double G, double tau) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1);
    REQUIRE(table != nullptr);
    nmbc::Lattice lattice = nmbc::make_lattice(*table, G);
    lattice.table = nullptr;
    const auto at_0 = nmbc::make_lattice(*table, 0).symbol;
    lattice.damping = nmbc::make_lattice(*table, 1).symbol;
    for (std::size_t m = 0; m < at_0.size(); ++m) {
        lattice.damping[m] = tau * (lattice.damping[m] - at_0[m]);
    }
    return lattice;
}

/// (41) without its strain part, at G = 1.
double sigma(int n, double xi) {
    double S = 0;
    double C = 0;
    for (int m = 1; m <= n; ++m) {
        S += m * std::sin(m * xi);
        C += std::cos(m * xi) - 1;
    }
    const double A = n * (n + 1) * (2 * n + 1) / 3.0;
    return -4 / std::pow(n, 4) * (C + S * S / A);
}

/// The root next to the upper half of the unit circle of
/// zeta^2 - (2 - dt^2 omega^2 - dt tau sigma) zeta + (1 - dt tau sigma) = 0.
std::complex<double> growth_factor(double dt, double omega_squared, double tau_sigma) {
    const double half = (2 - dt * dt * omega_squared - dt * tau_sigma) / 2;
    return half + std::sqrt(std::complex<double>(half * half - (1 - dt * tau_sigma)));
}

void fill_randomly(nmbc::Chain& chain) {
    std::mt19937_64 random(20180417);
    std::normal_distribution<double> normal;
    for (auto values : {chain.displacement(), chain.velocity()}) {
        std::ranges::generate(values, [&] { return normal(random); });
    }
}

const nmbc::ChainEnd fixed_end = nmbc::FixedEnd{};
const nmbc::ChainEnd unloaded = nmbc::FreeEnd{};

TEST_CASE("the damping of a table") {
    CHECK(nmbc::make_lattice(damped_table, 0.5).damping == std::vector<double>{0.75, -0.5, 0.125});
    CHECK(nmbc::make_lattice(damped_table, 7).damping == std::vector<double>{0.75, -0.5, 0.125});
    CHECK(nmbc::make_lattice(nopd1d_n1_order1, 0.5).damping.empty());
    for (int n = 1; n <= 5; ++n) {
        const auto lattice = damped_lattice(n, 0.7, 0.3);
        for (double xi = 0; xi < 3.2; xi += 0.1) {
            // Differences of sums of at most 11 terms below 8.
            CHECK(nmbc::detail::symbol_at(lattice.damping, xi) ==
                  doctest::Approx(0.3 * sigma(n, xi)).scale(1).epsilon(1e-14));
        }
    }
}

TEST_CASE("a damped table is found by its tau only") {
    const nmbc::MatchingTable* const tables[]{&damped_table, &nopd1d_n1_order1};
    CHECK(nmbc::find_table(tables, "nopd1d", 1, 1) == &nopd1d_n1_order1);
    CHECK(nmbc::find_table(tables, "nopd1d", 1, 1, 1, "1/4") == &damped_table);
    CHECK(nmbc::find_table(tables, "nopd1d", 1, 1, 1, "1/2") == nullptr);
    // What is certified instead is of the same lattice.
    CHECK(nmbc::certified_choices(damped_table, 0.5, tables) ==
          "NMBC1 with stride 1 and tau 1/4 is certified for G from 0 and above; at this G: "
          "NMBC1 with stride 1 and tau 1/4");
    CHECK(nmbc::certified_choices(nopd1d_n1_order1, 0.5, tables).find("tau") == std::string::npos);
}

TEST_CASE("a damped boundary is certified for long chains only") {
    CHECK(nmbc::certified_grade(damped_table, 0.5) == nmbc::Grade::paired);
    const auto lattice = nmbc::make_lattice(damped_table, 0.5);
    const auto coefficients = nmbc::boundary_coefficients(damped_table, 0.5);
    CHECK(coefficients.certificate->least_nodes == 50);
    CHECK_THROWS_WITH_AS(
        nmbc::Chain(lattice, nmbc::MatchingEnd{coefficients}, {.nodes = 49, .time_step = 0.1}),
        doctest::Contains("from 50 interior nodes on, and has 49"), nmbc::NotCertified);
    CHECK_THROWS_AS(nmbc::Chain(lattice, unloaded, nmbc::MatchingEnd{coefficients},
                                {.nodes = 49, .time_step = 0.1}),
                    nmbc::NotCertified);
    CHECK_NOTHROW(
        nmbc::Chain(lattice, nmbc::MatchingEnd{coefficients}, {.nodes = 50, .time_step = 0.1}));
    const auto any = nmbc::boundary_coefficients(damped_table, 0.5, nmbc::allow_unstable);
    CHECK_NOTHROW(nmbc::Chain(lattice, nmbc::MatchingEnd{any}, {.nodes = 10, .time_step = 0.1}));
}

TEST_CASE("a plane wave decays as the discrete dispersion relation says") {
    constexpr int steps = 40;
    constexpr double dt = 0.3;  // [dX/c]
    constexpr double tau = 0.4;
    constexpr double spacing = 0.5;
    for (int n = 1; n <= 5; ++n) {
        const auto lattice = damped_lattice(n, 0.6, tau);
        // What the ends do wrong comes in by 2n nodes per step.
        const std::size_t nodes = std::size_t(2 * (2 * n) * steps) + 20;
        nmbc::Chain chain(lattice, fixed_end, fixed_end,
                          {.nodes = nodes,
                           .spacing = spacing,
                           .youngs_modulus = 3,
                           .density = 2,
                           .time_step = dt * spacing / std::sqrt(1.5)});
        for (const double xi : {0.1, 0.5, 1.0, 1.7, 2.4, std::numbers::pi}) {
            CAPTURE(n);
            CAPTURE(xi);
            const auto zeta =
                growth_factor(dt, nmbc::omega_squared(lattice, xi), tau * sigma(n, xi));
            REQUIRE(std::abs(zeta) < 1);
            const auto wave = [&](std::size_t node, int level) {
                return std::real(std::polar(1.0, xi * double(node)) * std::pow(zeta, level));
            };
            for (std::size_t node = 0; node < chain.nodes(); ++node) {
                chain.displacement()[node] = wave(node, 0);
                chain.velocity()[node] =
                    (wave(node, 0) - wave(node, -1)) / chain.parameters().time_step;
            }
            for (int i = 0; i < steps; ++i) {
                chain.step();
            }
            for (std::size_t node = chain.nodes() / 2 - 5; node < chain.nodes() / 2 + 5; ++node) {
                // zeta has an error of eps/(dt omega) = eps/0.03 at xi = 0.1, its 40th power 3e-13
                CHECK(chain.displacement()[node] ==
                      doctest::Approx(wave(node, steps)).scale(1).epsilon(3e-13));
            }
        }
    }
}

TEST_CASE("between free ends the staggered energy loses what the damping takes") {
    for (int n = 1; n <= 5; ++n) {
        nmbc::Chain chain(
            damped_lattice(n, 0.8, 0.2), unloaded, unloaded,
            {.nodes = 30, .spacing = 0.5, .youngs_modulus = 3, .density = 2, .time_step = 0.05});
        fill_randomly(chain);
        const std::vector<double> u(chain.displacement().begin(), chain.displacement().end());
        const std::vector<double> v(chain.velocity().begin(), chain.velocity().end());
        chain.start(u, v);
        chain.step();
        const auto first = nmbc::energies(chain);
        for (int i = 0; i < 1000; ++i) {
            chain.step();
        }
        const auto last = nmbc::energies(chain);
        CAPTURE(n);
        CHECK(last.staggered < 0.8 * first.staggered);
        // 1000 steps of 30 nodes: roundings add up as sqrt(3e5) eps = 1.2e-13
        CHECK(last.staggered + last.damped ==
              doctest::Approx(first.staggered + first.damped).scale(0).epsilon(2e-12));
        // By parts of the chain, too.
        CHECK(nmbc::energies(chain, 0, 12).damped + nmbc::energies(chain, 12, 30).damped ==
              doctest::Approx(last.damped).scale(0).epsilon(1e-14));
        chain.start(u, v);
        CHECK(nmbc::energies(chain).damped == 0);
    }
}

TEST_CASE("prescribed velocities do work on a damped chain; the rest of the ledger is as before") {
    nmbc::Chain chain(damped_lattice(2, 0.8, 0.2), unloaded, unloaded,
                      {.nodes = 30, .spacing = 0.5, .density = 2, .time_step = 0.05});
    chain.step();
    double work = 0;
    for (int i = 0; i < 200; ++i) {
        const double old = chain.velocity()[15];
        chain.step([&](std::span<const double>, std::span<double> v, double time) {
            const double free = v[15];
            v[15] = std::sin(3 * time);
            work += 2 * 0.5 * (v[15] - free) * (old + v[15]) / 2;  // rho dX = 2 * 0.5
        });
    }
    const auto last = nmbc::energies(chain);
    CHECK(work > 0.1);
    CHECK(last.damped > 0.1 * work);
    CHECK(last.staggered + last.damped == doctest::Approx(work).scale(0).epsilon(1e-13));
}

TEST_CASE("a damped chain is the same in any units") {
    const auto lattice = nmbc::make_lattice(damped_table, 0.3);
    const auto coefficients = nmbc::boundary_coefficients(damped_table, 0.3);
    nmbc::Chain plain(lattice, nmbc::MatchingEnd{coefficients}, {.nodes = 60, .time_step = 0.4});
    const nmbc::ChainParameters units{.nodes = 60,
                                      .spacing = 0.07,
                                      .youngs_modulus = 210,
                                      .density = 7.8,
                                      .time_step = 0.4 * 0.07 / std::sqrt(210 / 7.8)};
    nmbc::Chain other(lattice, nmbc::MatchingEnd{coefficients}, units);
    fill_randomly(plain);
    std::vector<double> rates(plain.velocity().begin(), plain.velocity().end());
    for (double& rate : rates) {
        rate *= units.wave_speed() / units.spacing;
    }
    const std::vector<double> u(plain.displacement().begin(), plain.displacement().end());
    plain.start(u, std::vector<double>(plain.velocity().begin(), plain.velocity().end()));
    other.start(u, rates);
    for (int i = 0; i < 100; ++i) {
        plain.step();
        other.step();
    }
    for (std::size_t node = 0; node < plain.nodes(); ++node) {
        // 100 steps of some 10 terms, of displacements of order 1
        CHECK(other.displacement()[node] ==
              doctest::Approx(plain.displacement()[node]).scale(1).epsilon(1e-12));
    }
    const double unit = units.youngs_modulus / units.spacing;  // of energy per area, at dX = 1
    const auto e = nmbc::energies(plain);
    CHECK(e.damped > e.total());
    CHECK(nmbc::energies(other).damped == doctest::Approx(unit * e.damped).scale(0).epsilon(1e-12));
    CHECK(nmbc::energies(other).staggered ==
          doctest::Approx(unit * e.staggered).scale(0).epsilon(1e-12));
}

TEST_CASE("start moves the velocity back against the damping, too") {
    nmbc::Chain chain(nmbc::make_lattice(damped_table, 0.5), fixed_end, fixed_end,
                      {.nodes = 20, .time_step = 0.1});
    const std::vector<double> u(chain.nodes(), 0.0);
    std::vector<double> v(chain.nodes(), 0.0);
    v[12] = 1;
    chain.start(u, v);
    CHECK(chain.velocity()[12] == 1 + 0.05 * 0.75);
    CHECK(chain.velocity()[11] == -0.05 * 0.5);
    CHECK(chain.velocity()[10] == 0.05 * 0.125);
    CHECK(chain.velocity()[9] == 0);
}

TEST_CASE("a damping of zeros changes no bit") {
    const auto& table = *nmbc::find_table(nmbc::generated::tables, "nopd1d", 2, 3);
    const auto coefficients = nmbc::boundary_coefficients(table, 1.85, nmbc::allow_unstable);
    const nmbc::ChainParameters parameters{.nodes = 60, .spacing = 0.3, .time_step = 0.02};
    nmbc::Chain undamped(nmbc::make_lattice(table, 1.85), nmbc::MatchingEnd{coefficients},
                         parameters);
    nmbc::Lattice lattice = nmbc::make_lattice(table, 1.85);
    lattice.damping.assign(lattice.symbol.size(), 0.0);
    nmbc::Chain zeros(lattice, nmbc::MatchingEnd{coefficients}, parameters);
    fill_randomly(undamped);
    fill_randomly(zeros);
    for (int i = 0; i < 500; ++i) {
        undamped.step();
        zeros.step();
    }
    CHECK(std::ranges::equal(undamped.displacement(), zeros.displacement()));
    CHECK(std::ranges::equal(undamped.velocity(), zeros.velocity()));
    CHECK(nmbc::energies(zeros).damped == 0);
    CHECK(undamped.damped().empty());
}

TEST_CASE("the interior's own limit of the time step") {
    CHECK(nmbc::interior_cfl(nmbc::make_lattice(nopd1d_n1_order1, 0.5)) == 1);
    // n = 1, G = 1/2, tau = 1/4 at xi = pi: omega^2 = 4, tau sigma = 2, p = 1 + sqrt(5).
    CHECK(nmbc::interior_cfl(nmbc::make_lattice(damped_table, 0.5)) ==
          doctest::Approx(2 / (1 + std::sqrt(5.0))).scale(0).epsilon(1e-14));
    for (int n = 1; n <= 5; ++n) {
        for (const double tau : {0.1, 1.0, 5.0}) {
            const auto lattice = damped_lattice(n, 0.4, tau);
            const double limit = nmbc::interior_cfl(lattice) * 2 / nmbc::maximum_frequency(lattice);
            const auto largest = [&](double dt) {
                double factor = 0;
                for (int i = 1; i <= 2000; ++i) {
                    const double xi = i * std::numbers::pi / 2000;
                    const double tau_sigma = tau * sigma(n, xi);
                    const double omega_squared = nmbc::omega_squared(lattice, xi);
                    const auto zeta = growth_factor(dt, omega_squared, tau_sigma);
                    factor =
                        std::max({factor, std::abs(zeta), std::abs((1 - dt * tau_sigma) / zeta)});
                }
                return factor;
            };
            CAPTURE(n);
            CAPTURE(tau);
            // The grid misses the maximum by curvature * (pi/4000)^2, well below 1e-4.
            CHECK(largest(limit * (1 - 1e-12)) <= 1);
            CHECK(largest(limit * (1 + 1e-4)) > 1);
        }
    }
}

}  // namespace
