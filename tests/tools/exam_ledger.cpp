// SPDX-License-Identifier: GPL-2.0-or-later
/// The energy ledger closes, whatever the ends, the sources and the damping.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "tools/nmbcrun/simulation/ledger.hpp"

namespace {

const nmbc::MatchingTable& table_of(int horizon) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1, 1);
    REQUIRE(table != nullptr);
    return *table;
}

nmbc::Lattice lattice_of(int horizon, double G, bool damped) {
    nmbc::Lattice lattice = nmbc::make_lattice(table_of(horizon), G);
    if (damped) {  // by (v_{I-1} - 2 v_I + v_{I+1})/10; any symmetric stencil will do here
        lattice.damping.assign(lattice.symbol.size(), 0);
        lattice.damping[0] = 0.2;
        lattice.damping[1] = -0.1;
    }
    return lattice;
}

/// A fixed end that takes a tenth of the velocity of the three outermost interior nodes away.
struct DampingEnd {
    class Condition final : public nmbc::BoundaryCondition<double> {
      public:
        explicit Condition(std::size_t ghosts) : ghosts_(ghosts) {}
        std::size_t least_interior_nodes() const override { return 3; }
        void start(nmbc::NodeLine<double> u, nmbc::NodeLine<double> v,
                   std::size_t /*step*/) override {
            for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
                u[ghost] = v[ghost] = 0;
            }
        }
        void after_kick(nmbc::NodeLine<const double> /*u*/, nmbc::NodeLine<double> v,
                        std::size_t /*step*/) override {
            for (std::size_t node = ghosts_; node < ghosts_ + 3; ++node) {
                v[node] *= 0.9;
            }
        }

      private:
        std::size_t ghosts_;
    };

    static std::unique_ptr<nmbc::BoundaryCondition<double>> make(
        const nmbc::Lattice& lattice, const nmbc::ChainParameters& /*p*/,
        std::type_identity<double> /*real*/) {
        return std::make_unique<Condition>(lattice.reach());
    }
};

struct Named {
    std::string name;
    nmbc::ChainEnd end;
};

std::vector<Named> ends_of(int horizon, double G) {
    return {{"matching", nmbc::MatchingEnd{nmbc::boundary_coefficients(table_of(horizon), G,
                                                                       nmbc::allow_unstable)}},
            {"fixed", nmbc::FixedEnd{}},
            {"free", nmbc::FreeEnd{}},
            {"extended", nmbc::FixedEnd{7}},
            {"damping", DampingEnd{}}};
}

/// Drives node 20 by its displacement to step 200 and pushes nodes 24 to 26 to step 300.
void sources(std::span<const double> u, std::span<double> v, std::size_t first, double time,
             double time_step) {
    if (time < 200.5 * time_step) {
        v[first + 20] = (0.01 * std::sin(0.3 * time) - u[first + 20]) / time_step;
    }
    if (time < 300.5 * time_step) {
        for (std::size_t node = 24; node < 27; ++node) {
            v[first + node] += 1e-4 * std::cos(time);
        }
    }
}

/// The nodes they act on in a chain of `parameters`, and in one with 100 more nodes on its left.
constexpr std::array<std::size_t, 4> driven{20, 24, 25, 26};
constexpr std::array<std::size_t, 4> driven_further_in{120, 124, 125, 126};

constexpr auto no_sources = [](const auto& /*u*/, const auto& /*v*/, double /*time*/) {};

struct Outcome {
    double drift = 0;  ///< its largest, over the largest energy
    double peak = 0;
    nmbcrun::Balance last;
};

Outcome run(nmbc::Chain& chain, nmbcrun::Ledger& ledger, int steps) {
    Outcome outcome;
    double drift = 0;
    for (int i = 0; i < steps; ++i) {
        ledger.advance(chain, 1, [&](auto u, auto v, double time) {
            sources(u, v, chain.first_interior(), time, chain.parameters().time_step);
        });
        outcome.last = ledger.balance(chain, nmbc::energies(chain));
        outcome.peak = std::max(outcome.peak, outcome.last.energy);
        drift = std::max(drift, std::abs(outcome.last.drift));
    }
    outcome.drift = drift / outcome.peak;
    return outcome;
}

constexpr nmbc::ChainParameters parameters{
    .nodes = 40, .spacing = 0.5, .youngs_modulus = 3, .density = 2, .time_step = 0.1};

TEST_CASE("the ledger closes: ends, horizons, damping, sources") {
    const double G = 0.9;
    for (int horizon = 1; horizon <= 5; ++horizon) {
        for (const bool damped : {false, true}) {
            for (const Named& left : ends_of(horizon, G)) {
                for (const Named& right : ends_of(horizon, G)) {
                    CAPTURE(horizon);
                    CAPTURE(damped);
                    CAPTURE(left.name);
                    CAPTURE(right.name);
                    nmbc::Chain chain(lattice_of(horizon, G, damped), left.end, right.end,
                                      parameters);
                    nmbcrun::Ledger ledger(chain, driven);
                    const Outcome outcome = run(chain, ledger, 1000);
                    // 1000 steps of 40 nodes and some 10 operations: sqrt(4e5) eps = 1.4e-13 if
                    // all roundings were as large as the peak. Between free ends the chain flies
                    // away, to displacements a hundred times those of its waves.
                    const bool flies = left.name == "free" && right.name == "free";
                    CHECK(outcome.drift < (flies ? 3e-12 : 1e-13));
                    CHECK(outcome.peak > 0);
                    CHECK((left.name != "free" || outcome.last.left == 0));
                    CHECK((right.name != "free" || outcome.last.right == 0));
                    CHECK((ledger.totals().work > 0.5 * outcome.peak));
                }
            }
        }
    }
}

TEST_CASE("the ledger closes: bonds that are counted at one end each have no mirror image") {
    // bonds of one and two spacings, c = 1
    nmbc::Lattice lattice;
    lattice.symbol = {1.25, -0.5, -0.125};
    lattice.energy = {{nmbc::EnergyPart::strain, 0.5, {0, 0, -1, 1, 0}},
                      {nmbc::EnergyPart::strain, 0.125, {0, 0, -1, 0, 1}}};
    nmbc::Chain chain(lattice, nmbc::FreeEnd{}, nmbc::FreeEnd{}, parameters);
    nmbcrun::Ledger ledger(chain, driven);
    CHECK(run(chain, ledger, 1000).drift < 3e-12);  // as above
}

TEST_CASE("the ledger closes: initial data, ends of two kinds") {
    for (int horizon = 1; horizon <= 5; ++horizon) {
        for (const bool damped : {false, true}) {
            nmbc::Chain chain(lattice_of(horizon, 0.9, damped), ends_of(horizon, 0.9)[0].end,
                              DampingEnd{}, parameters);
            std::mt19937_64 random(20180417);
            std::normal_distribution<double> normal;
            std::vector<double> u(chain.nodes());
            std::vector<double> v(chain.nodes());
            for (auto* values : {&u, &v}) {
                std::ranges::generate(*values, [&] { return normal(random); });
            }
            chain.start(u, v);
            nmbcrun::Ledger ledger(chain, driven);
            const nmbcrun::Balance at_start = ledger.balance(chain, nmbc::energies(chain));
            const double start = at_start.energy;
            CHECK(at_start.drift == 0);
            ledger.advance(chain, 1000, no_sources);
            const nmbcrun::Balance last = ledger.balance(chain, nmbc::energies(chain));
            CAPTURE(horizon);
            CHECK(std::abs(last.drift) < 1e-13 * start);  // as above
            CHECK(last.work == 0);
            CHECK(last.left != 0);
            CHECK(last.right > 0);  // the damping only takes
        }
    }
}

TEST_CASE("what leaves through an end is what arrives in the nodes beyond it") {
    // The same chain twice: a part of it between two layers, and the whole, which keeps all.
    for (int horizon = 1; horizon <= 5; ++horizon) {
        const nmbc::ChainEnd extended = nmbc::FixedEnd{100};
        const nmbc::ChainEnd fixed = nmbc::FixedEnd{};
        nmbc::ChainParameters longer = parameters;
        longer.nodes += 200;
        nmbc::Chain part(lattice_of(horizon, 0.9, false), extended, extended, parameters);
        nmbc::Chain whole(lattice_of(horizon, 0.9, false), fixed, fixed, longer);
        nmbcrun::Ledger of_part(part, driven);
        nmbcrun::Ledger of_whole(whole, driven_further_in);
        for (auto* const ledger : {&of_part, &of_whole}) {
            nmbc::Chain& chain = ledger == &of_part ? part : whole;
            ledger->advance(chain, 600, [&](auto u, auto v, double time) {
                sources(u, v, part.first_interior(), time, parameters.time_step);
            });
        }
        const nmbcrun::Balance inner = of_part.balance(part, nmbc::energies(part));
        const nmbcrun::Balance all = of_whole.balance(whole, nmbc::energies(whole));
        CAPTURE(horizon);
        CHECK(inner.work == all.work);
        CHECK(all.left == 0);  // a fixed end's nodes do no work
        CHECK(all.right == 0);
        CHECK(inner.left > 0.1 * all.energy);
        CHECK(inner.right > 0.1 * all.energy);
        // 600 steps: roundings as above
        CHECK(inner.energy + inner.left + inner.right ==
              doctest::Approx(all.energy).scale(0).epsilon(1e-13));
    }
}

TEST_CASE("the ledger closes beside true ends, which take and give what is given on them") {
    for (int horizon = 1; horizon <= 3; ++horizon) {
        for (const auto closure : {nmbc::Closure::sbp, nmbc::Closure::cut}) {
            for (const auto given : {nmbc::OnSurface::traction, nmbc::OnSurface::displacement}) {
                CAPTURE(horizon);
                const nmbc::SurfaceEnd loaded{closure, given,
                                              [](double time) { return 0.01 * std::sin(time); }};
                nmbc::Chain chain(lattice_of(horizon, 0.9, false), loaded,
                                  nmbc::SurfaceEnd{.closure = closure}, parameters);
                nmbcrun::Ledger ledger(chain, driven);
                const Outcome outcome = run(chain, ledger, 1000);
                CHECK(outcome.drift < 3e-12);  // the chain may fly away, as above
                CHECK(outcome.last.left != 0);
                CHECK(outcome.last.right == 0);
            }
        }
    }
}

TEST_CASE("a ledger goes on from its totals bit for bit") {
    const auto ends = ends_of(2, 0.9);
    const auto chain_of_test = [&] {
        return nmbc::Chain(lattice_of(2, 0.9, true), ends[0].end, ends[2].end, parameters);
    };
    nmbc::Chain chain = chain_of_test();
    nmbcrun::Ledger ledger(chain, driven);
    run(chain, ledger, 150);
    nmbc::Chain other = chain_of_test();
    nmbcrun::Ledger resumed(other, driven);
    other.resume(chain.state());
    resumed.resume(other, ledger.totals());
    const nmbcrun::Balance one = run(chain, ledger, 300).last;
    const nmbcrun::Balance two = run(other, resumed, 300).last;
    CHECK(one.energy == two.energy);
    CHECK(one.work == two.work);
    CHECK(one.left == two.left);
    CHECK(one.right == two.right);
    CHECK(one.drift == two.drift);
}

}  // namespace
