// SPDX-License-Identifier: GPL-2.0-or-later
/// Scenes with exact ends: energy, certificate, limits.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/tables/tables.hpp>
#include <string>
#include <utility>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/certificate.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"

namespace {

using nmbcrun::BoundaryKind;

/// The drive of (57) in the middle of 60 nodes.
nmbcrun::Scene scene_of(int horizon, double G, BoundaryKind kind, double cfl) {
    nmbcrun::Scene scene;
    scene.horizon = horizon;
    scene.G = G;
    scene.nodes = 60;
    scene.drive = {.amplitude = 1, .duration = 20, .centre = 30, .half_width = 1};
    scene.left.kind = kind;
    scene.left.layer = 1000;  // of an extended one
    scene.right = scene.left;
    scene.end = 300;
    scene.cfl = cfl;
    return scene;
}

TEST_CASE("after the drive the interior has never more energy than when it is let go") {
    // From one step to the next its energy can rise: by dispersion the slow ends of a pulse, and
    // backward waves, come back in from outside, in a chain without ends as well.
    for (const int n : {1, 2, 3}) {
        for (const double G : {0.0, 0.3, 1.0}) {
            for (const double cfl : {0.3, 0.95}) {
                nmbcrun::Simulation exact(scene_of(n, G, BoundaryKind::exact, cfl));
                nmbcrun::Simulation extended(scene_of(n, G, BoundaryKind::extended, cfl));
                CAPTURE(n);
                CAPTURE(G);
                CAPTURE(cfl);
                double let_go = 0;
                double highest = 0;
                double error = 0;
                while (!exact.is_done()) {
                    exact.step();
                    extended.step();
                    const double energy = exact.energies().staggered;
                    error = std::max(error, std::abs(energy - extended.energies().staggered));
                    if (exact.is_driven(exact.chain().time())) {
                        let_go = energy;
                    } else {
                        highest = std::max(highest, energy);
                    }
                }
                // Sums over 60 nodes: 60 eps at most, and as much of each for the difference.
                CHECK(highest <= let_go * (1 + 2e-14));
                CHECK(error < 2e-14 * let_go);
            }
        }
    }
}

TEST_CASE("which kinds add no energy") {
    CHECK(nmbcrun::adds_no_energy(BoundaryKind::exact));
    CHECK(nmbcrun::adds_no_energy(BoundaryKind::free));
    CHECK_FALSE(nmbcrun::adds_no_energy(BoundaryKind::nmbc));
}

std::string objection_to(const nmbcrun::Scene& scene, double cfl) {
    const auto table = [&](const nmbcrun::Boundary& end) -> const nmbc::MatchingTable& {
        return *nmbc::find_table(nmbc::generated::tables, "nopd1d", scene.horizon, end.order,
                                 end.stride);
    };
    const double omega_max =
        nmbc::maximum_frequency(nmbc::make_lattice(table(scene.left), scene.G));
    return objection(scene, table(scene.left), table(scene.right), 2 * cfl / omega_max, cfl);
}

TEST_CASE("what is certified opposite an exact end") {
    for (const auto kind : {BoundaryKind::fixed, BoundaryKind::free, BoundaryKind::extended,
                            BoundaryKind::exact, BoundaryKind::nmbc}) {
        auto scene = scene_of(1, 0.5, kind, 0.5);
        scene.right.kind = BoundaryKind::exact;
        CHECK(objection_to(scene, 0.5) == "");
        std::swap(scene.left, scene.right);
        CHECK(objection_to(scene, 0.5) == "");
    }
    auto scene = scene_of(1, 0.5, BoundaryKind::exact, 0.5);
    scene.left.kind = BoundaryKind::nmbc;
    scene.left.order = 2;
    const double certified =
        nmbc::certified_cfl(*nmbc::find_table(nmbc::generated::tables, "nopd1d", 1, 2), scene.G,
                            nmbc::GhostRule::midpoint, nmbc::Opposite::any);
    REQUIRE(certified > 0.1);
    CHECK(objection_to(scene, certified) == "");
    const std::string above = objection_to(scene, certified + 0.01);
    CHECK_MESSAGE(above.starts_with("NMBC2 is certified against an exact end up to cfl = "), above);
    CHECK_MESSAGE(above.find(" only at n = 1, G = 0.5; cfl = ") != std::string::npos, above);
    scene.left.ghosts = nmbc::GhostRule::explicit_rule;
    CHECK(objection_to(scene, 0.01)
              .find("NMBC2 with explicit ghosts is certified against an exact end at no time step "
                    "at n = 1, G = 0.5; cfl = 0.01") == 0);
    CHECK_THROWS_AS(nmbcrun::Simulation{scene}, nmbcrun::Unstable);
    scene.allow_unstable = true;
    CHECK(nmbcrun::Simulation(scene).plan().objection != "");
}

TEST_CASE("the automatic step, and a run that is too long") {
    auto scene = scene_of(2, 1, BoundaryKind::exact, 0.5);
    scene.cfl.reset();
    scene.drive->duration = 200;
    CHECK(nmbcrun::Simulation(scene).plan().cfl == doctest::Approx(0.99).epsilon(1e-12));
    scene.left.kind = BoundaryKind::fixed;
    CHECK(nmbcrun::Simulation(scene).plan().cfl == doctest::Approx(0.99).epsilon(1e-12));
    scene.end = 1e7;
    CHECK_THROWS_WITH_AS(
        nmbcrun::Simulation{scene},
        doctest::Contains("200000 at most: take a longer time step, or kind \"extended\""),
        nmbcrun::SceneError);
}

}  // namespace
