// SPDX-License-Identifier: GPL-2.0-or-later
/// Passive ends of the runtime: the end of the atom chain that is exact to fourth order, its energy
/// in long runs, and what is refused.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/passive_end.hpp>  // made by the build
#include <nmbc/tables/tables.hpp>
#include <stdexcept>
#include <vector>

#include "tests/runtime/random_start.hpp"

namespace {

/// nopd1d, n = 1, G = 1/2: neighbours alone, u'' = u_{I-1} - 2 u_I + u_{I+1}.
nmbc::Lattice atom_chain() {
    return nmbc::make_lattice(nmbc::generated::nopd1d_n1_order1, 0.5);
}

const double spring = std::sqrt(8 * (std::sqrt(5.0) - 2));
const double golden = (3 - std::sqrt(5.0)) / 2;

nmbc::PassiveEnd fourth_order() {
    return {.rows = 2,
            .stiffness = {spring, -spring, 0, 0,  //
                          -spring, spring + 1, -1, 0},
            .mass = {golden / spring, 0.5 + (1 - golden) / spring},
            .dashpots = {1, 0, 0, 0},
            .highest_eigenvalue = 6.7330};  // by power iteration
}

template <class Real>
nmbc::BasicChain<Real> chain_of(std::size_t nodes, double step) {
    // E = 12, rho = 3, dX = 1/2: c = 2, so that no unit is 1 by chance.
    return {atom_chain(),
            fourth_order(),
            {.nodes = nodes,
             .spacing = 0.5,
             .youngs_modulus = 12,
             .density = 3,
             .time_step = step / 4}};
}

/// v.M v/2 + u(t+dt).K u(t)/2, in units of dX and c.
template <class Real>
double energy(const nmbc::BasicChain<Real>& chain, const std::vector<double>& before) {
    const std::size_t ghosts = chain.ghosts();
    const std::size_t nodes = chain.nodes() - 2 * ghosts;
    const auto u = [&](std::size_t i) { return double(chain.displacement()[ghosts + i]); };
    const auto v = [&](std::size_t i) { return double(chain.velocity()[ghosts + i]) / 4; };
    const nmbc::PassiveEnd end = fourth_order();
    double sum = 0;
    for (std::size_t i = 0; i < nodes; ++i) {
        const std::size_t from_end = std::min(i, nodes - 1 - i);
        sum += (from_end < 2 ? end.mass[from_end] : 1) * v(i) * v(i) / 2;
        if (i > 0) {
            const double stiffness = i == 1 || i + 1 == nodes ? spring : 1;
            sum +=
                stiffness * (u(i) - u(i - 1)) * (before[ghosts + i] - before[ghosts + i - 1]) / 2;
        }
    }
    return sum;
}

/// The part of the energy that a Gaussian pulse leaves behind.
double left_of_a_pulse(double width, double step) {
    auto chain = chain_of<double>(200, step);
    std::vector<double> u(chain.nodes());
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = std::exp(-std::pow((double(i) - 103) / width, 2));
    }
    chain.start(u, std::vector<double>(u.size()));
    std::vector<double> before(chain.displacement().begin(), chain.displacement().end());
    chain.step();
    const double first = energy(chain, before);
    while (chain.time() * 4 < 300) {
        before.assign(chain.displacement().begin(), chain.displacement().end());
        chain.step();
    }
    return energy(chain, before) / first;
}

TEST_CASE_TEMPLATE("energy never rises, to 0.99 of the largest step", Real, double, float) {
    auto chain = chain_of<Real>(20, 0.99 * 2 / std::sqrt(fourth_order().highest_eigenvalue));
    start_at_random(chain);
    double last = HUGE_VAL;
    double first = 0;
    for (int step = 0; step < 20000; ++step) {
        const std::vector<double> before(chain.displacement().begin(), chain.displacement().end());
        chain.step();
        const double now = energy(chain, before);
        first = step == 0 ? now : first;
        // Some ten roundings a node.
        REQUIRE(now < last + 200 * double(std::numeric_limits<Real>::epsilon()) * first);
        last = now;
    }
    // A rigid shift has no energy, and all else is damped.
    CHECK(last < 1e-3 * first);
}

TEST_CASE("the end of the atom chain is of fourth order") {
    // |R|^2 goes as xi^8 in continuous time: half the wave numbers, 1/256 of the energy. Steps add
    // (omega dt)^2/16 to R.
    constexpr double short_step = 0.02;
    const double one = left_of_a_pulse(4, short_step);
    const double two = left_of_a_pulse(8, short_step);
    CHECK(one < 1e-5);
    CHECK(two < one / 100);
    CHECK(left_of_a_pulse(8, 0.7) > 100 * two);
}

TEST_CASE("an end as nmbcgen prints it: a pulse leaves, opposite a free end that sends it back") {
    nmbc::Chain chain(nmbc::make_lattice(nmbc::generated::nopd1d_n2_order1, 1), nmbc::FreeEnd{},
                      nmbc::generated::passive_nopd1d_n2_G1o1_dt3o2,
                      {.nodes = 100, .time_step = 1.5});
    std::vector<double> u(chain.nodes());
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = std::exp(-std::pow((double(i) - 54) / 8, 2));
    }
    chain.start(u, std::vector<double>(u.size()));
    const double first = nmbc::energies(chain).total();
    chain.advance(200);
    // Nearly all is in waves of xi = 0.05 to 0.2, of which the design sends back 2e-11 to 5e-10.
    CHECK(nmbc::energies(chain).total() < 1e-9 * first);
}

TEST_CASE_TEMPLATE("a rigid shift at rest stays where it is", Real, double, float) {
    nmbc::BasicChain<Real> chain(nmbc::make_lattice(nmbc::generated::nopd1d_n2_order1, 1),
                                 nmbc::generated::passive_nopd1d_n2_G1o1_dt3o2,
                                 {.nodes = 40, .time_step = 1.5});
    chain.start(std::vector<Real>(chain.nodes(), Real{1}), std::vector<Real>(chain.nodes()));
    chain.advance(100);
    const std::size_t ghosts = chain.ghosts();
    for (std::size_t i = ghosts; i + ghosts < chain.nodes(); ++i) {
        // A hundred steps of some ten roundings each.
        CHECK(std::abs(double(chain.displacement()[i]) - 1) <
              1e3 * double(std::numeric_limits<Real>::epsilon()));
    }
}

TEST_CASE("the ends are mirror images, and units are those of the chain") {
    auto chain = chain_of<double>(31, 0.7);
    std::vector<double> u(chain.nodes());
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = std::exp(-std::pow((double(i) - double(u.size() - 1) / 2) / 3, 2));
    }
    chain.start(u, std::vector<double>(u.size()));
    chain.advance(100);
    const auto found = chain.displacement();
    for (std::size_t i = 0; i < u.size(); ++i) {
        CHECK(std::abs(found[i] - found[u.size() - 1 - i]) < 1e-13);  // roundings
    }
}

TEST_CASE("what does not fit is refused") {
    const nmbc::Lattice lattice = atom_chain();
    const nmbc::ChainParameters parameters{.nodes = 20, .time_step = 0.5};
    const auto chain = [&](const nmbc::PassiveEnd& end) {
        return nmbc::Chain(lattice, end, parameters);
    };
    CHECK_NOTHROW(chain(fourth_order()));
    nmbc::PassiveEnd end = fourth_order();
    end.stiffness.pop_back();
    CHECK_THROWS_WITH_AS(chain(end),
                         "a passive end of q masses and m rows, q = 1 .. m, needs q * q dashpots "
                         "and m * (m + 2) entries of the stiffness",
                         std::invalid_argument);
    end = fourth_order();
    end.mass[1] = 0;
    CHECK_THROWS_WITH_AS(chain(end),
                         "the masses and the highest eigenvalue of a passive end must be positive",
                         std::invalid_argument);
    end = fourth_order();
    end.dashpots[0] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH_AS(chain(end), "the matrices of a passive end must be finite",
                         std::invalid_argument);
    end = fourth_order();
    end.highest_eigenvalue = 17;
    CHECK_THROWS_WITH_AS(chain(end),
                         "a chain with this passive end is stable in steps below 0.485071 dX/c, "
                         "and the step is 0.500000 dX/c",
                         nmbc::NotCertified);
    CHECK_THROWS_WITH_AS(
        nmbc::Chain(nmbc::make_lattice(nmbc::generated::nopd1d_n1_order1, 0.501), fourth_order(),
                    parameters),
        "this passive end was made for another lattice: horizon, G or family are not those of the "
        "chain",
        nmbc::NotCertified);
    CHECK_THROWS_AS(
        fourth_order().make(lattice, {.nodes = 20, .time_step = -1}, std::type_identity<double>{}),
        std::invalid_argument);
    nmbc::Lattice damped = lattice;
    damped.damping.assign(lattice.symbol.size(), 0.1);
    CHECK_THROWS_WITH_AS(nmbc::Chain(damped, fourth_order(), parameters),
                         "a passive end needs a lattice without damping", std::invalid_argument);
}

}  // namespace
