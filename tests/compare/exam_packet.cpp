// SPDX-License-Identifier: GPL-2.0-or-later
/// Packets measure what the modal analysis predicts, with ends as a scene has them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/ends.hpp>
#include <nmbc/tables/tables.hpp>
#include <numbers>

#include "tools/nmbcrun/compare/packet.hpp"
#include "tools/nmbcrun/prediction/prediction.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace {

using nmbcrun::Boundary;
using nmbcrun::BoundaryKind;

nmbcrun::Scene scene_with(int horizon, double G) {
    nmbcrun::Scene scene;
    scene.horizon = horizon;
    scene.G = G;
    return scene;
}

TEST_CASE("measured and predicted agree, long waves and short ones") {
    constexpr double step = 0.4;
    struct Case {
        int horizon;
        int order;
        int stride;
        double G;
    };
    for (const Case& one : {Case{1, 1, 1, 0.5}, {1, 2, 1, 0.5}, {2, 2, 2, 1.0}, {3, 2, 3, 2.0}}) {
        const auto scene = scene_with(one.horizon, one.G);
        const Boundary boundary{.order = one.order, .stride = one.stride};
        const auto lattice = nmbc::make_lattice(table_of(scene, boundary), one.G);
        for (const double xi : {0.05, 0.3, 0.5}) {
            CAPTURE(one.horizon);
            CAPTURE(one.order);
            CAPTURE(xi);
            const nmbcrun::Packet packet(lattice, xi, step);
            REQUIRE(packet.is_measurable());
            const double measured = packet.reflected_by(chain_end(scene, boundary), 0);
            const double predicted = predicted_reflection(scene, boundary, packet, step).value();
            // The packet's cut-off is 1e-17 of the energy, roundings of 1e4 steps 1e-14 of it.
            CHECK(std::abs(measured - predicted) < std::max(1e-4 * predicted, 1e-14));
        }
    }
}

/// At n = 2, G = 5/2 waves near xi = pi travel from omega(pi) on, that of xi = 1.128, and carry
/// ten times what the other wave does. 49 waves of the packet predict 8.2e-5 to 1.2e-4 for xi =
/// 1.0905 to 1.091, and by the time the packet itself has left the end still holds a tenth more.
TEST_CASE("measured and predicted agree where another wave begins to travel") {
    const auto scene = scene_with(2, 2.5);
    const Boundary boundary{.order = 2, .stride = 1};
    const auto lattice = nmbc::make_lattice(table_of(scene, boundary), 2.5);
    const double step = 2 * 0.6 / nmbc::maximum_frequency(lattice);
    struct Case {
        double xi;
        double reflected;  ///< measured after 64 times the packet's own time
    };
    for (const Case& known : {Case{1.0905, 1.0105e-4}, {1.091, 1.0462e-4}}) {
        CAPTURE(known.xi);
        const nmbcrun::Packet packet(lattice, known.xi, step);
        REQUIRE(packet.is_measurable());
        const double measured = packet.reflected_by(chain_end(scene, boundary), 0);
        const double predicted = predicted_reflection(scene, boundary, packet, step).value();
        CHECK(std::abs(predicted - known.reflected) < 1e-3 * known.reflected);
        CHECK(std::abs(measured - known.reflected) < 1e-2 * known.reflected);
    }
}

TEST_CASE("layers, thin and wide, send back what their modes say") {
    struct Case {
        int horizon = 0;
        double G = 0;
        Boundary layer{};
        double step = 0;
    };
    const auto sponge = [](std::size_t nodes) {
        return Boundary{.kind = BoundaryKind::sponge, .layer = nodes};
    };
    const auto pml = [](std::size_t nodes) {
        return Boundary{.kind = BoundaryKind::pml, .layer = nodes};
    };
    for (const Case& one : {Case{1, 0.5, sponge(1), 0.4},
                            {1, 0.5, pml(1), 0.9},
                            {2, 1.0, sponge(20), 0.4},
                            {2, 1.0, pml(20), 0.2},
                            {3, 2.0, sponge(3), 0.1},
                            {3, 2.0, pml(7), 0.3}}) {
        const auto scene = scene_with(one.horizon, one.G);
        const auto lattice = nmbc::make_lattice(table_of(scene, {}), one.G);
        for (const double xi : {0.1, 0.3, 0.5}) {
            CAPTURE(one.horizon);
            CAPTURE(one.layer.layer);
            CAPTURE(xi);
            const nmbcrun::Packet packet(lattice, xi, one.step);
            REQUIRE(packet.is_measurable());
            const double measured =
                packet.reflected_by(chain_end(scene, one.layer), one.layer.layer);
            const double predicted =
                predicted_reflection(scene, one.layer, packet, one.step).value();
            CHECK(std::abs(measured - predicted) < std::max(1e-4 * predicted, 1e-14));
        }
    }
}

/// Roundings never make it amplify, not where waves stand still nor where two of them merge: at G =
/// 0 omega is 0 at pi, too, at 5/2 waves near it turn back.
TEST_CASE("a layer sends back no more than comes, and all of what stands still") {
    for (const double G : {0.0, 2.5}) {
        const auto scene = scene_with(2, G);
        for (const auto kind : {BoundaryKind::sponge, BoundaryKind::pml}) {
            const Boundary faint{.kind = kind, .layer = 7, .target = 1 - 1e-15};
            const auto energy = *reflected_energy_of(scene, faint, 0.3);
            CHECK(energy(0) == 1);
            CHECK(energy(std::numbers::pi) == 1);
            double most = 0;
            double least = 1;
            for (int i = 1; i < 1000; ++i) {
                const double part = energy(std::numbers::pi * i / 1000);
                most = std::max(most, part);
                least = std::min(least, part);
            }
            CHECK(most <= 1);
            CHECK(least > 1 - 1e-6);
        }
    }
}

TEST_CASE("a passive end reflects what its design says, in steps of any length") {
    constexpr double most = 1e-7;
    struct Case {
        int horizon;
        double G;
    };
    for (const Case& one : {Case{1, 0.6}, {2, 1.0}, {2, 32.0 / 15}}) {
        const auto scene = scene_with(one.horizon, one.G);
        const Boundary boundary{.kind = BoundaryKind::passive};
        const auto lattice = lattice_of(scene);
        for (const double cfl : {0.2, 0.85}) {
            const double step = 2 * cfl / nmbc::maximum_frequency(lattice);
            for (const double xi : {0.3, 0.5}) {
                CAPTURE(one.horizon);
                CAPTURE(cfl);
                CAPTURE(xi);
                const nmbcrun::Packet packet(lattice, xi, step);
                const double measured = packet.reflected_by(chain_end(scene, boundary), 0);
                const double predicted =
                    predicted_reflection(scene, boundary, packet, step).value();
                CHECK(std::abs(measured - predicted) < std::max(1e-4 * predicted, 1e-14));
                CHECK(measured < most);
            }
        }
    }
}

TEST_CASE("fixed and free ends keep a packet") {
    const auto scene = scene_with(2, 1);
    const auto lattice = nmbc::make_lattice(nmbc::generated::nopd1d_n2_order1, 1);
    const nmbcrun::Packet packet(lattice, 0.4, 0.3);
    for (const BoundaryKind kind : {BoundaryKind::fixed, BoundaryKind::free}) {
        const Boundary boundary{.kind = kind};
        CHECK(predicted_reflection(scene, boundary, packet, 0.3) == 1.0);
        // The squares of the ghosts belong to the energy near the end; by then all is far away.
        CHECK(packet.reflected_by(chain_end(scene, boundary), 0) ==
              doctest::Approx(1).epsilon(1e-10));
    }
}

TEST_CASE("packets that take too long") {
    const auto lattice = nmbc::make_lattice(nmbc::generated::nopd1d_n1_order1, 0);
    CHECK(nmbcrun::Packet(lattice, 0.5, 0.5).is_measurable());
    CHECK_FALSE(nmbcrun::Packet(lattice, 0.01, 0.5).is_measurable());  // too long
    CHECK_FALSE(nmbcrun::Packet(lattice, 1.57, 0.5).is_measurable());  // sin(xi) stands still
    CHECK_FALSE(nmbcrun::Packet(lattice, 3.1, 0.5).is_measurable());   // beyond the band
    CHECK(nmbcrun::Packet(lattice, 2.5, 0.5).is_measurable());         // a backward wave
}

}  // namespace
