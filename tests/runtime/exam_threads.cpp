// SPDX-License-Identifier: GPL-2.0-or-later
/// With OpenMP, where threads share a sweep, every bit is as without.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nmbc/nmbc.hpp>
#include <nmbc/plane.hpp>
#include <nmbc/tables/tables.hpp>
#include <variant>
#include <vector>

#ifndef _OPENMP
#error "this test is about OpenMP"
#endif
#include <omp.h>

#include "tests/runtime/plane_bodies.hpp"

namespace {

TEST_CASE_TEMPLATE("threads change no bit", Real, double, float) {
    for (int horizon = 1; horizon <= 3; ++horizon) {
        for (const std::size_t nodes : {1U, 30U, 1000U, 50000U}) {
            CAPTURE(horizon);
            CAPTURE(nodes);
            const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1);
            REQUIRE(table != nullptr);
            const auto run = [&](std::size_t threaded_nodes) {
                nmbc::detail::threaded_nodes = threaded_nodes;
                nmbc::BasicChain<Real> chain(nmbc::make_lattice(*table, 0.9), nmbc::FixedEnd{4},
                                             nmbc::FixedEnd{}, {.nodes = nodes, .time_step = 0.1});
                std::vector<Real> u(chain.nodes());
                for (std::size_t node = 0; node < u.size(); ++node) {
                    u[node] = static_cast<Real>(std::sin(double(node * node)));
                }
                chain.start(u, u);
                chain.advance(10);
                chain.step();
                return chain.state();
            };
            const auto threaded = run(0);
            const auto alone = run(std::numeric_limits<std::size_t>::max());
            CHECK(std::ranges::any_of(alone.displacement, [](Real u) { return u != 0; }));
            CHECK(threaded.displacement == alone.displacement);
            CHECK(threaded.velocity == alone.velocity);
        }
    }
}

TEST_CASE_TEMPLATE("threads change no bit of a plane, whose bonds may break", Real, double, float) {
    omp_set_num_threads(4);  // whatever the machine has: some pieces are between others
    const nmbc::SpongeSide sponge{{0.3, 0.2, 0.1}};
    const nmbc::PassiveSide passive = some_passive_side(0);
    for (const nmbc::PlaneSides& sides :
         {nmbc::PlaneSides::all(nmbc::FreeSide{}), nmbc::PlaneSides::all(nmbc::FixedSide{}),
          nmbc::PlaneSides::all(nmbc::PeriodicSide{}), nmbc::PlaneSides::all(nmbc::MirrorSide{}),
          nmbc::PlaneSides{sponge, sponge, nmbc::MirrorSide{}, sponge},
          nmbc::PlaneSides{passive, nmbc::FreeSide{}, passive, passive}}) {
        for (const nmbc::PlaneModel& model : {nmbc::PlaneModel(nmbc::bond2d(4, {1, 0.7, 0.3})),
                                              nmbc::PlaneModel(nmbc::nopd2d(4, 0.25, 1))}) {
            const auto run = [&](std::size_t threaded_nodes) {
                nmbc::detail::threaded_nodes = threaded_nodes;
                nmbc::BasicPlane<Real> plane(model, sides,
                                             {.nx = 260, .ny = 260, .time_step = 0.1});
                if (std::holds_alternative<nmbc::BondModel>(model.law())) {
                    plane.break_above(1.5, [](auto, auto) { return false; });
                }
                for (const std::size_t a : {0U, 1U}) {
                    for (std::size_t i = 0; i < plane.displacement(a).size(); ++i) {
                        plane.displacement(a)[i] = static_cast<Real>(std::sin(double(i * (i + a))));
                    }
                }
                plane.start();
                plane.advance(10);
                return plane.state();
            };
            const auto threaded = run(0);
            const auto alone = run(std::numeric_limits<std::size_t>::max());
            CHECK(threaded.displacement == alone.displacement);
            CHECK(threaded.velocity == alone.velocity);
            CHECK(threaded.bonds == alone.bonds);
            CHECK(threaded.broken == alone.broken);
            CHECK(threaded.released == alone.released);
            CHECK((alone.broken > 100) == std::holds_alternative<nmbc::BondModel>(model.law()));
        }
    }
}

}  // namespace
