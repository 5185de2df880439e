// SPDX-License-Identifier: GPL-2.0-or-later
/// The finer lattice that closed sides are judged by: which sides it has, and what it refuses.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/nmbcrun/plane_starts.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/plane/finer_run.hpp"
#include "tools/nmbcrun/plane/plane_sides.hpp"

namespace nmbcrun::test {
namespace {

const std::string of_spline =
    "model = { family = 'nopd2d', radius2 = 2, nu = 0.3, G = 0.5, influence = 'spline' }\n";

/// As "left right bottom top", and its ratio.
std::string sides_of_finer(const std::string& model, const Overrides& sides) {
    const PlaneScene scene = plane_scene_of(model + of_lattice + "[boundary]\n" + packet, sides);
    const SameBody finer = finer_body(scene, sides_of(scene, true).all);
    std::string found;
    for (const PlaneSideChoice& side : finer.scene.sides) {
        found += std::string(name_of(side.kind)) + " ";
    }
    return found + std::to_string(finer.scene.original->ratio);
}

Overrides of_kinds(const char* left, const char* right, const char* bottom, const char* top) {
    return {{"boundary.left.kind", left},
            {"boundary.right.kind", right},
            {"boundary.bottom.kind", bottom},
            {"boundary.top.kind", top}};
}

void refuse(const PlaneScene& scene, const char* reason) {
    const nmbc::PlaneSides own = sides_of(scene, true).all;
    CHECK_THROWS_WITH_AS(finer_body(scene, own), reason, SceneError);
}

}  // namespace

TEST_CASE(
    "sides that end a body are closed by parts on a finer lattice, free ones beside no mirror") {
    CHECK(sides_of_finer(of_spline, of_kinds("kernel", "free", "kernel", "free")) ==
          "sbp sbp sbp sbp 2");
    CHECK(sides_of_finer(of_spline, of_kinds("mirror", "free", "kernel", "free")) ==
          "mirror free sbp free 3");
    CHECK(sides_of_finer(of_spline, of_kinds("mirror", "kernel", "kernel", "kernel")) ==
          "mirror sbp sbp sbp 3");
    CHECK(sides_of_finer(nopd2d_of_2, of_kinds("sbp", "extended", "fixed", "free")) ==
          "sbp extended fixed sbp 2");
}

TEST_CASE("a body with too few nodes for a finer lattice, or too many, is refused as that") {
    PlaneScene scene = plane_scene_of(nopd2d_of_2 + of_lattice + free_sides + packet);
    scene.nodes = {3, 30};
    refuse(scene,
           "the body is 3 dX long along x, too thin for the reference, whose sbp sides have "
           "5 lines each");
    scene.nodes = {9000, 4000};
    refuse(scene,
           "the reference, the same body on nodes dX/2 apart, has 1.44e+08 nodes; at most "
           "100000000 are allowed");
    scene.sides[0] = {.kind = SideKind::extended};
    scene.end = 1;
    refuse(scene,
           "the reference, the same body on nodes dX/2 apart, has 1.44e+08 nodes, with those "
           "in the place of artificial sides until time.end = 1; at most 100000000 are "
           "allowed");
}

TEST_CASE("what no finer lattice has is refused in the words of who asked for one") {
    PlaneScene scene = plane_scene_of(nopd2d_of_2 + of_lattice + free_sides + packet);
    scene.initial->shape = PlaneShape::file;
    refuse(scene,
           "physical sides are compared with a finer lattice, and initial.file has u at the "
           "nodes of this one only: take another initial.shape, or start by a force or a "
           "load");
    scene.sides[0] = {.kind = SideKind::extended};
    refuse(scene,
           "--finer compares with a finer lattice, and initial.file has u at the nodes of "
           "this one only: take another initial.shape, or start by a force or a load");
}

TEST_CASE("a difference that is not a number stays so, whatever node comes next") {
    const PlaneScene scene = plane_scene_of(nopd2d_of_2 + of_lattice + free_sides + packet);
    const PlaneSimulation reference(scene);
    PlaneSimulation simulation(scene);
    std::vector<std::vector<double>> state = simulation.state();
    state[0][simulation.entry(3, 5)] = std::numeric_limits<double>::quiet_NaN();
    simulation.resume(0, state);
    const auto found = CommonNodes(simulation, reference).between(simulation, reference);
    CHECK(std::isnan(found.largest));
    CHECK(found.node[0] == 4);
    CHECK(found.node[1] == 6);
}

}  // namespace nmbcrun::test
