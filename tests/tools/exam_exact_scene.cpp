// SPDX-License-Identifier: GPL-2.0-or-later
/// Scenes with exact ends: energy, certificate, limits.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/tables/tables.hpp>
#include <string>
#include <utility>

#include "tools/nmbcrun/certification/certificate.hpp"
#include "tools/nmbcrun/errors.hpp"
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
    return nmbcrun::PairOfEnds(scene, table(scene.left), table(scene.right))
        .objection(2 * cfl / omega_max, cfl);
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
    // What comes back from a pml is not known, so that an nmbc must not amplify any wave.
    auto scene = scene_of(3, 4, BoundaryKind::exact, 0.5);
    scene.left = {.order = 2, .stride = 3};
    const double certified =
        nmbc::certified_cfl(*nmbc::find_table(nmbc::generated::tables, "nopd1d", 3, 2, 3), scene.G,
                            nmbc::Opposite::any);
    REQUIRE(certified > 0.1);
    for (const double cfl : {0.1, certified, certified + 0.01, 0.5}) {
        for (const auto kind : {BoundaryKind::exact, BoundaryKind::extended}) {
            scene.right = {.kind = kind};
            CHECK(objection_to(scene, cfl) == "");
        }
        scene.right = {.kind = BoundaryKind::pml, .layer = 10};
        const std::string above = objection_to(scene, cfl);
        CHECK(above.empty() == (cfl <= certified));
        CHECK_MESSAGE(
            (above.empty() ||
             (above.starts_with("NMBC2 of stride 3 is certified against a pml end up to "
                                "cfl = ") &&
              above.find(" only at n = 3, G = 4; the step has cfl = ") != std::string::npos)),
            above);
    }
}

/// NMBC2 at the left end of 20 nodes; a pulse so short that it has waves of the whole band.
nmbcrun::Scene second_order(double G, const nmbcrun::Boundary& right) {
    auto scene = scene_of(1, G, BoundaryKind::nmbc, 0.4);
    scene.left = {.order = 2};
    scene.right = right;
    scene.nodes = 20;
    scene.drive.reset();
    scene.initial = {.kind = nmbcrun::InitialKind::displacement,
                     .pulse = {.amplitude = 1, .width = 0.7},
                     .centre = 5,
                     .file = {}};
    return scene;
}

TEST_CASE("an end that amplifies waves is stable where none of them comes back") {
    constexpr std::size_t steps = 100'000;
    auto like = second_order(0.2, {.order = 2});
    CHECK(objection_to(like, 0.4).find("NMBC2 at both ends is not stable") == 0);
    CHECK(objection_to(second_order(0.2, {.kind = BoundaryKind::fixed}), 0.4)
              .find("NMBC2 on the left and a fixed end on the right are not stable together") == 0);
    like.allow_unstable = true;
    nmbcrun::Simulation pair(like);
    const double at_first = pair.energies().total();
    for (std::size_t step = 0; step < steps / 10; ++step) {
        pair.step();
    }
    CHECK(pair.energies().total() > 10 * at_first);

    auto scene = second_order(0.2, {.kind = BoundaryKind::exact});
    scene.end = double(steps) * pair.plan().time_step;
    CHECK(objection_to(scene, 0.4) == "");
    nmbcrun::Simulation half_line(scene);
    CHECK(half_line.plan().objection == "");
    double highest = 0;
    while (!half_line.is_done()) {
        half_line.step();
        if (half_line.chain().steps() > steps / 10) {
            highest = std::max(highest, half_line.energies().total());
        }
    }
    // What was left after a tenth of the steps are waves that hardly move: 0.03 of the start.
    CHECK(highest < 0.1 * at_first);
    CHECK(half_line.energies().total() <= highest);

    // As far as the waves come: a layer of that width will do, and none of a fifth of it.
    scene.end = 300;
    for (const auto& [layer, is_enough] : {std::pair(400U, true), {80U, false}}) {
        scene.right = {.kind = BoundaryKind::extended, .layer = layer};
        CHECK(objection_to(scene, 0.4).empty() == is_enough);
    }
}

TEST_CASE("a growing mode is refused, whatever is opposite") {
    // s = 18.1 in continuous time (docs/explanation/stability.md).
    auto scene = scene_of(2, 1, BoundaryKind::nmbc, 0.4);
    scene.left.order = 2;
    for (const auto kind : {BoundaryKind::exact, BoundaryKind::extended, BoundaryKind::fixed}) {
        scene.right = {.kind = kind};
        CHECK(objection_to(scene, 0.4)
                  .find("NMBC2 is not stable at n = 2, G = 1, cfl = 0.4: a mode "
                        "at that end grows as exp(") == 0);
        CHECK_THROWS_AS(nmbcrun::Simulation{scene}, nmbcrun::Unstable);
    }
    scene = scene_of(1, 0.5, BoundaryKind::nmbc, 0.4);
    scene.right = {.kind = BoundaryKind::exact};
    CHECK(objection_to(scene, 0.3) == "");
    scene.left.ghosts = nmbc::GhostRule::explicit_rule;
    CHECK(objection_to(scene, 0.3) == "there is no certificate for explicit ghosts");
}

TEST_CASE("the automatic step, and a run that is too long") {
    auto scene = scene_of(2, 1, BoundaryKind::exact, 0.5);
    scene.cfl.reset();
    scene.drive->duration = 200;
    CHECK(nmbcrun::Simulation(scene).plan().cfl == doctest::Approx(0.99).epsilon(1e-12));
    scene.left.kind = BoundaryKind::fixed;
    CHECK(nmbcrun::Simulation(scene).plan().cfl == doctest::Approx(0.99).epsilon(1e-12));
    // An nmbc for which there is none with its like: from 0.99 down in steps of 0.05.
    auto like = second_order(0.2, {.order = 2});
    like.cfl.reset();
    CHECK_THROWS_AS(nmbcrun::Simulation{like}, nmbcrun::Unstable);
    like.right = {.kind = BoundaryKind::exact};
    CHECK(nmbcrun::Simulation(like).plan().cfl == doctest::Approx(0.39).epsilon(1e-12));
    scene.end = 1e7;
    CHECK_THROWS_WITH_AS(
        nmbcrun::Simulation{scene},
        doctest::Contains("200000 at most: take a longer time step, or kind \"extended\""),
        nmbcrun::SceneError);
}

}  // namespace
