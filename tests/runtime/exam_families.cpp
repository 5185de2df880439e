// SPDX-License-Identifier: GPL-2.0-or-later
/// Lattices of other families in the runtime, by tables made while the tests are built: everything
/// behind the symbol works for them.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/bond1d_n2_order1.hpp>
#include <nmbc/tables/chain1d_n1_order2.hpp>
#include <nmbc/tables/nopd1d_n2_w_1o1_1o2_order1.hpp>

namespace {

/// The part of its energy that a Gaussian leaves in a chain of 200 nodes after t = 600.
double energy_left(const nmbc::MatchingTable& table, double G) {
    const double cfl = nmbc::certified_cfl(table, G);
    REQUIRE(cfl > 0.2);
    const nmbc::Lattice lattice = nmbc::make_lattice(table, G);
    const double dt = 0.95 * 2 * cfl / nmbc::maximum_frequency(lattice);
    nmbc::Chain chain(lattice, nmbc::MatchingEnd{nmbc::boundary_coefficients(table, G)},
                      {.nodes = 200, .time_step = dt});
    for (std::size_t i = 0; i < chain.nodes(); ++i) {
        const double x = (double(i) - 99.5) / 10;
        chain.displacement()[i] = std::exp(-x * x);
    }
    const double first = nmbc::energies(chain).total();
    for (double t = 0; t < 600; t += dt) {
        chain.step();
    }
    return nmbc::energies(chain).total() / first;
}

}  // namespace

TEST_CASE("waves leave lattices of every family") {
    using namespace nmbc::generated;
    CHECK(chain1d_n1_order2.ghost_layers() == 1);
    CHECK(bond1d_n2_order1.ghost_layers() == 2);
    CHECK(nopd1d_n2_w_1o1_1o2_order1.ghost_layers() == 4);
    // A pulse of half-width 10 has its energy at xi near 0.2, where by `nmbcgen recommend` less
    // than 1e-6 of it is reflected; a thousandth would be what a fixed end leaves after a hundred
    // reflections of 90 %.
    CHECK(energy_left(chain1d_n1_order2, 0) < 1e-6);
    CHECK(energy_left(bond1d_n2_order1, 0) < 1e-6);
    CHECK(energy_left(nopd1d_n2_w_1o1_1o2_order1, 1) < 1e-6);
}

TEST_CASE("without stabilisation every G is the same") {
    using nmbc::generated::chain1d_n1_order2;
    CHECK(nmbc::certified_cfl(chain1d_n1_order2, 0) == nmbc::certified_cfl(chain1d_n1_order2, 1e6));
    CHECK(nmbc::certified_cfl(chain1d_n1_order2, 0) > 0.5);
}
