// SPDX-License-Identifier: GPL-2.0-or-later
/// Steps and lattices that true ends on the outermost node do not take.
#include <doctest/doctest.h>

#include <nmbc/nmbc.hpp>
#include <stdexcept>

#include "tests/runtime/edge_chains.hpp"

namespace {

using nmbc::Closure;
using nmbc::SurfaceEnd;

}  // namespace

TEST_CASE("steps and lattices that true ends refuse") {
    const nmbc::Lattice lattice = constant_influence(2, 1);
    const SurfaceEnd end{.closure = Closure::sbp};
    auto p = parameters_of(40, Closure::sbp, lattice);
    p.time_step *= 1.2;
    CHECK_THROWS_AS(nmbc::Chain(lattice, end, p), nmbc::NotCertified);
    p.time_step = 2.01 / nmbc::maximum_frequency(lattice) * p.spacing / p.wave_speed();
    for (const nmbc::ChainEnd& whatever :
         {nmbc::ChainEnd(nmbc::FreeEnd{}), nmbc::ChainEnd(nmbc::FixedEnd{}),
          nmbc::ChainEnd(SurfaceEnd{})}) {
        CHECK_THROWS_AS(nmbc::Chain(lattice, whatever, p), nmbc::NotCertified);
    }
    p.time_step /= 4;
    CHECK_NOTHROW(nmbc::Chain(lattice, end, p));
    CHECK_THROWS_AS(nmbc::Chain(lattice, SurfaceEnd{.closure = Closure::kernel}, p),
                    std::invalid_argument);
    nmbc::Lattice damped = lattice;
    damped.damping = {2, -1};
    for (const Closure closure : {Closure::sbp, Closure::cut, Closure::kernel}) {
        CHECK_THROWS_AS(nmbc::Chain(damped, SurfaceEnd{.closure = closure}, p),
                        std::invalid_argument);
    }
    nmbc::Lattice no_energy = bonds_of({1});
    no_energy.energy.clear();
    nmbc::Lattice no_bond = bonds_of({1});
    no_bond.energy[0].stencil = {0, -1, 2};
    for (const nmbc::Lattice& other : {bonds_of({2, -0.1}), no_energy, no_bond}) {
        for (const Closure closure : {Closure::sbp, Closure::cut}) {
            CHECK_THROWS_AS(nmbc::Chain(other, SurfaceEnd{.closure = closure}, p),
                            std::invalid_argument);
        }
    }
    // Bonds to both neighbours that weigh unlike.
    const nmbc::Lattice stabilised = constant_influence(2, 1);
    CHECK_NOTHROW(nmbc::Chain(stabilised, end, p));
    for (std::size_t square = 1; square < stabilised.energy.size(); ++square) {
        nmbc::Lattice unequal = stabilised;
        unequal.energy[square].weight *= 2;
        CHECK_THROWS_AS(nmbc::Chain(unequal, end, p), std::invalid_argument);
    }
    p.nodes = 7;
    CHECK_THROWS_AS(nmbc::Chain(lattice, end, p), std::invalid_argument);
}
