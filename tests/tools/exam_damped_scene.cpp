// SPDX-License-Identifier: GPL-2.0-or-later
/// What nmbcrun says of the ends of a damped scene, with a table made while the tests are built.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/lattice.hpp>
#include <nmbc/tables/nopd1d_n2_order2_s2_tau1o10.hpp>
#include <string>
#include <utility>

#include "tools/nmbcrun/certification/certificate.hpp"

namespace {

constexpr const nmbc::MatchingTable& table = nmbc::generated::nopd1d_n2_order2_s2_tau1o10;

/// NMBC2 of stride 2 at both ends of a bar with c = 2 and dX = 1/2.
nmbcrun::Scene damped_scene(double G, std::size_t nodes) {
    nmbcrun::Scene scene;
    scene.horizon = 2;
    scene.G = G;
    scene.tau = "1/10";
    scene.youngs_modulus = 4;
    scene.spacing = 0.5;
    scene.nodes = nodes;
    scene.left = {nmbcrun::BoundaryKind::nmbc, 2, 2, nmbc::GhostRule::midpoint};
    scene.right = scene.left;
    return scene;
}

std::string objection_at(const nmbcrun::Scene& scene, double cfl) {
    const double rate = std::sqrt(scene.youngs_modulus / scene.density) / scene.spacing;
    const double omega_max = nmbc::maximum_frequency(nmbc::make_lattice(table, scene.G)) * rate;
    return nmbcrun::PairOfEnds(scene, table, table).objection(2 * cfl / omega_max, cfl);
}

TEST_CASE("damped ends are certified at the scene's own length") {
    // A round trip between like ends: 11 times in 9 nodes, 0.0013 times in 61.
    CHECK(objection_at(damped_scene(3, 61), 0.3) == "");
    const std::string grows = objection_at(damped_scene(3, 9), 0.3);
    for (const char* text :
         {"NMBC2 of stride 2 at both ends is not stable at n = 2, G = 3, tau = 1/10, cfl = 0.3: ",
          "per round trip in a chain of 9 nodes"}) {
        CHECK_MESSAGE(grows.find(text) != std::string::npos, grows);
    }
}

TEST_CASE("damped: unlike ends, at any length here, and a mode at one of them") {
    for (const auto kind : {nmbcrun::BoundaryKind::fixed, nmbcrun::BoundaryKind::free}) {
        for (const std::size_t nodes : {9U, 61U}) {
            nmbcrun::Scene scene = damped_scene(1, nodes);
            scene.right.kind = kind;
            CHECK(objection_at(scene, 0.3) == "");
            std::swap(scene.left, scene.right);
            CHECK(objection_at(scene, 0.6) == "");
            scene.G = 0.3;  // one step multiplies the mode by 1.88
            CHECK(objection_at(scene, 0.6).find("a mode at that end grows as exp(") !=
                  std::string::npos);
        }
    }
}

}  // namespace
