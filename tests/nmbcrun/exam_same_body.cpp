// SPDX-License-Identifier: GPL-2.0-or-later
/// A body on another lattice: its places are the same, and what moves it is as large.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "tests/nmbcrun/plane_starts.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/plane/same_body.hpp"

namespace nmbcrun::test {
namespace {

const std::string bump =
    "[initial]\nshape = 'gaussian'\ncomponent = 'x'\namplitude = 0.01\ncentre = [5, 4]\nwidth = "
    "2\n";

/// A scene between such sides, and the same body on a lattice so much finer between others.
struct Pair {
    const char* x;  ///< left and right
    const char* y;  ///< bottom and top
    const char* finer_x;
    const char* finer_y;
    std::size_t ratio;
};
const std::vector<Pair> pairs{{"sbp", "sbp", "sbp", "sbp", 2},
                              {"free", "sbp", "sbp", "sbp", 2},
                              {"free", "free", "free", "free", 3},
                              {"mirror", "fixed", "mirror", "fixed", 3},
                              {"periodic", "mirror", "periodic", "mirror", 3},
                              {"fixed", "periodic", "fixed", "periodic", 2},
                              {"sbp", "sbp", "free", "free", 1}};

PlaneScene between(const char* x, const char* y, const std::string& source) {
    return plane_scene_of(nopd2d_of_2 + of_lattice + "[boundary]\n" + source,
                          {{"boundary.left.kind", x},
                           {"boundary.right.kind", x},
                           {"boundary.bottom.kind", y},
                           {"boundary.top.kind", y}});
}

/// The original and the body of the pair, in steps of the former over its ratio.
struct Bodies {
    PlaneSimulation original;
    PlaneSimulation other;
};
Bodies bodies_of(const Pair& pair, const std::string& source) {
    PlaneSimulation original(between(pair.x, pair.y, source));
    const auto sides = between(pair.finer_x, pair.finer_y, source).sides;
    SameBody same = same_body(original.scene(), original.plane().sides(), sides, pair.ratio);
    same.scene.step = original.plan().time_step / double(pair.ratio);
    PlaneSimulation other(same.scene, same.sides);
    return {std::move(original), std::move(other)};
}

/// Of a component, per thickness.
double momentum(const PlaneSimulation& simulation, std::size_t component) {
    const PlaneBody body = simulation.body();
    double sum = 0;
    for (std::size_t y = 0; y < body.nodes[1]; ++y) {
        for (std::size_t x = 0; x < body.nodes[0]; ++x) {
            const std::size_t entry = simulation.entry_of_body(x, y);
            sum += simulation.plane().mass(component, entry) *
                   simulation.plane().velocity(component)[entry];
        }
    }
    return sum;
}

/// Of the body, so fast along x.
std::size_t nodes_moved(const PlaneSimulation& simulation, double speed) {
    const PlaneBody body = simulation.body();
    std::size_t found = 0;
    for (std::size_t y = 0; y < body.nodes[1]; ++y) {
        for (std::size_t x = 0; x < body.nodes[0]; ++x) {
            found += std::size_t(simulation.plane().velocity(0)[simulation.entry_of_body(x, y)] ==
                                 speed);
        }
    }
    return found;
}

std::string on_rectangle(const char* centre, const char* half_width) {
    return fmt::format(
        "[load.push]\nkind = 'force'\ncomponent = 'y'\namplitude = 7\ncentre = {}\nhalf_width = "
        "{}\n",
        centre, half_width);
}

/// The source gives both bodies the same momentum in a step: at rest before, no other forces act.
void check_push(const Pair& pair, const std::string& source, std::size_t component) {
    CAPTURE(pair.x);
    CAPTURE(pair.y);
    CAPTURE(pair.ratio);
    Bodies bodies = bodies_of(pair, source);
    bodies.original.advance(1);
    bodies.other.advance(1);
    const double pushed = momentum(bodies.original, component);
    CHECK(pushed > 0);
    CHECK(momentum(bodies.other, component) * double(pair.ratio) ==
          doctest::Approx(pushed).epsilon(1e-12));
}

}  // namespace

TEST_CASE("a force is as large on another lattice, at sides and in corners, too" *
          doctest::test_suite("long")) {
    for (const std::string& force :
         {on_rectangle("[0.5, 0.5]", "[0, 0]"), on_rectangle("[12, 9]", "[1, 0]"),
          on_rectangle("[6, 4]", "[1.5, 20]"),
          std::string("[force]\ncomponent = 'y'\ncentre = [5, 4]\nhalf_width = 1.3\nhistory = "
                      "'gaussian'\namplitude = 2\ntime = 3\nduration = 9\n")}) {
        for (const Pair& pair : pairs) {
            CAPTURE(force);
            check_push(pair, force, 1);
        }
    }
}

TEST_CASE("a traction is as large on another lattice") {
    const std::string pull =
        "[load.pull]\nkind = 'traction'\nside = 'top'\ncomponent = 'x'\namplitude = 7\n";
    for (const Pair& pair : pairs) {
        if (ends_body(between(pair.x, pair.y, bump).sides[3].kind)) {
            check_push(pair, pull, 0);
        }
    }
}

TEST_CASE("a field begins in the same places of the body") {
    for (const Pair& pair : pairs) {
        CAPTURE(pair.x);
        CAPTURE(pair.y);
        CAPTURE(pair.ratio);
        if (pair.ratio == 1) {  // half a dX aside
            const Bodies bodies = bodies_of(pair, bump);
            CHECK_THROWS_WITH_AS(CommonNodes(bodies.original, bodies.other),
                                 "its nodes lie midway between those of the reference", SceneError);
            continue;
        }
        const Bodies bodies = bodies_of(pair, bump);
        const auto found =
            CommonNodes(bodies.original, bodies.other).between(bodies.original, bodies.other);
        CHECK(found.other > 0.0099);
        CHECK(found.largest < 1e-14);  // roundings of places of some 10, times 0.01
    }
}

TEST_CASE("what is moved is moved from the outermost node to the outermost" *
          doctest::test_suite("long")) {
    struct Rectangle {
        const char* centre;
        const char* half_width;
        std::array<std::size_t, 2> nodes;  // of the original
    };
    for (const Rectangle& rectangle :
         {Rectangle{"[6, 4]", "[1, 0.5]", {5, 3}}, Rectangle{"[0.5, 0.5]", "[1, 0.5]", {3, 2}},
          Rectangle{"[12, 9]", "[1, 0.5]", {3, 2}}}) {
        for (const Pair& pair : pairs) {
            CAPTURE(rectangle.centre);
            CAPTURE(pair.x);
            CAPTURE(pair.y);
            CAPTURE(pair.ratio);
            if (pair.ratio == 1) {  // all nodes lie midway
                continue;
            }
            Bodies bodies = bodies_of(
                pair, fmt::format("[load.pull]\nkind = 'velocity'\ncomponent = 'x'\namplitude = "
                                  "3\ncentre = {}\nhalf_width = {}\n",
                                  rectangle.centre, rectangle.half_width));
            bodies.other.advance(1);
            const auto finer = [&](std::size_t nodes) { return pair.ratio * (nodes - 1) + 1; };
            CHECK(nodes_moved(bodies.other, 3) ==
                  finer(rectangle.nodes[0]) * finer(rectangle.nodes[1]));
        }
    }
}

TEST_CASE("between periodic sides all is moved that lies between nodes that are") {
    Bodies bodies = bodies_of({"periodic", "mirror", "periodic", "mirror", 3},
                              "[load.pull]\nkind = 'velocity'\ncomponent = 'x'\namplitude = "
                              "3\ncentre = [6, 9]\nhalf_width = [20, 0]\n");
    bodies.other.advance(1);
    CHECK(nodes_moved(bodies.other, 3) == std::size_t{3} * 24);
}

TEST_CASE("a packet is one of the same length on a finer lattice") {
    const auto simulation = bodies_of(pairs[0], packet).other;
    CHECK(simulation.scene().initial->wave_number == doctest::Approx(0.35).epsilon(1e-15));
}

TEST_CASE("a body that no nodes fill is refused") {
    PlaneSimulation original(between("sbp", "sbp", bump));
    auto sides = original.scene().sides;
    sides[0] = {.kind = SideKind::free};
    CHECK_THROWS_WITH_AS(
        same_body(original.scene(), original.plane().sides(), sides, 1),
        "the body is 33 dX long along x, which nodes 0.5 apart do not fill between "
        "sides of the kinds free and sbp",
        SceneError);
}

}  // namespace nmbcrun::test
