// SPDX-License-Identifier: GPL-2.0-or-later
/// The reference without ends, and what a run is off it.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <nmbc/ends.hpp>
#include <nmbc/tables/tables.hpp>

#include "tools/nmbcrun/compare/reference.hpp"
#include "tools/nmbcrun/ends/silent_layer.hpp"

namespace {

/// 41 interior nodes with a rough pulse right at the left end, after a run of this duration.
nmbc::Chain run_with_layer(const nmbc::MatchingTable& table, double G, double step, double duration,
                           std::size_t layer) {
    nmbc::Chain chain(nmbc::make_lattice(table, G), nmbc::FixedEnd{layer},
                      {.nodes = 41, .time_step = step});
    std::vector<double> u(chain.nodes());
    u[chain.first_interior()] = 1;  // all wave numbers
    u[chain.first_interior() + 7] = -0.3;
    chain.start(u, std::vector<double>(u.size()));
    while (chain.time() < duration) {
        chain.step();
    }
    return chain;
}

TEST_CASE("nothing returns through a silent layer") {
    for (const auto* table :
         {&nmbc::generated::nopd1d_n1_order1, &nmbc::generated::nopd1d_n2_order1,
          &nmbc::generated::nopd1d_n3_order1}) {
        for (const double G : {0.0, 0.5, 2.0}) {
            for (const double cfl : {0.1, 0.95}) {
                for (const double duration : {3.0, 50.0, 400.0}) {
                    CAPTURE(table->name);
                    CAPTURE(G);
                    CAPTURE(cfl);
                    CAPTURE(duration);
                    const auto lattice = nmbc::make_lattice(*table, G);
                    const double step = cfl * 2 / nmbc::maximum_frequency(lattice);
                    const std::size_t layer = nmbcrun::silent_layer(lattice, step, duration);
                    const auto near = run_with_layer(*table, G, step, duration, layer);
                    const auto far = run_with_layer(*table, G, step, duration, 3 * layer);
                    for (std::size_t i = 0; i < 41; ++i) {
                        // The promised 1e-13 of the wave; roundings are the same in both.
                        REQUIRE(std::abs(nmbcrun::interior(near)[i] - nmbcrun::interior(far)[i]) <
                                1e-13);
                    }
                }
            }
        }
    }
}

TEST_CASE("the reference keeps a physical end") {
    nmbcrun::Scene scene;
    scene.right = {.kind = nmbcrun::BoundaryKind::free};
    const nmbcrun::Scene reference = nmbcrun::endless(scene, 0.1);
    CHECK(reference.left.kind == nmbcrun::BoundaryKind::extended);
    CHECK(reference.right.kind == nmbcrun::BoundaryKind::free);
}

TEST_CASE("the deviation of one run from another") {
    const auto lattice = nmbc::make_lattice(nmbc::generated::nopd1d_n1_order1, 0.5);
    nmbc::Chain one(lattice, nmbc::FixedEnd{}, {.nodes = 10, .time_step = 0.5});
    nmbc::Chain other(lattice, nmbc::FixedEnd{3}, {.nodes = 10, .time_step = 0.5});
    nmbcrun::Deviation deviation;
    deviation.look(one, other);
    CHECK(deviation.relative() == 0);
    other.displacement()[other.first_interior() + 4] = -2;
    one.displacement()[one.first_interior() + 4] = -2;
    one.displacement()[one.first_interior() + 6] = 0.5;
    deviation.look(one, other);
    CHECK(deviation.relative() == 0.25);
    CHECK(deviation.node() == 7);
    one.displacement()[one.first_interior()] = std::numeric_limits<double>::quiet_NaN();
    deviation.look(one, other);
    CHECK(deviation.relative() == std::numeric_limits<double>::infinity());
    CHECK(deviation.node() == 1);
}

}  // namespace
