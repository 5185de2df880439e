// SPDX-License-Identifier: GPL-2.0-or-later
/// The drive (57), and how the driven nodes are let go.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "tests/nmbcrun/bar.hpp"
#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun::test {
namespace {

constexpr double end_time = 12;
constexpr double duration = 5;

/// The interior's displacements at the end, of a bar that nothing comes back in.
std::vector<double> driven(double steps) {
    Scene scene = bar(200, end_time);
    scene.drive = Drive{0.01, duration, 50, 1};
    scene.cfl.reset();
    scene.step = end_time / steps;
    Simulation simulation(scene);
    run_to_end(simulation);
    const auto u = interior(simulation, simulation.chain().displacement());
    return {u.begin(), u.end()};
}

double largest_difference(const std::vector<double>& one, const std::vector<double>& other) {
    double most = 0;
    for (std::size_t node = 0; node < one.size(); ++node) {
        most = std::max(most, std::abs(one[node] - other[node]));
    }
    return most;
}

// The drive takes 5/12 of the steps: 100 of 240, and 200.4, 202.1, 202.5, 202.9 and 204.2 of the
// others.
TEST_CASE("the error of steps is of second order, wherever between two of them the drive ends") {
    const std::vector<double> reference = driven(60 * 240);
    const double at_a_level = largest_difference(driven(240), reference);
    for (const double steps : {481., 485., 486., 487., 490.}) {
        CAPTURE(steps);
        const double error = largest_difference(driven(steps), reference);
        // A quarter of that of half as many steps, and where the drive ends far from a level, up to
        // a third more, also of second order: the nodes are held till the next one.
        CHECK(error * std::pow(steps / 240, 2) ==
              doctest::Approx(at_a_level).scale(0).epsilon(0.25));
    }
}

TEST_CASE("a drive that takes no more than a step is refused") {
    Scene scene = bar(200, end_time);
    scene.drive = Drive{0.01, 0.1, 50, 1};
    scene.cfl.reset();
    scene.step = 0.12;
    CHECK_THROWS_WITH_AS(Simulation{scene},
                         "drive.duration is 0.1, not longer than a time step of 0.12", SceneError);
    scene.step = 0.1;
    CHECK_THROWS_AS(Simulation{scene}, SceneError);
    scene.step = 0.0999999;
    CHECK_NOTHROW(Simulation{scene});
}

}  // namespace
}  // namespace nmbcrun::test
