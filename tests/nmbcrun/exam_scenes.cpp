// SPDX-License-Identifier: GPL-2.0-or-later
/// Every ready scene is read, and its first steps run.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "tests/nmbcrun/bar.hpp"
#include "tools/nmbcrun/plane/plane_lattice.hpp"
#include "tools/nmbcrun/plane/plane_simulation.hpp"
#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun::test {
namespace {

TEST_CASE("the first steps of every scene in tools/scenes" * doctest::test_suite("long")) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(NMBC_SCENES)) {
        if (entry.path().extension() != ".toml") {
            continue;
        }
        CAPTURE(entry.path().string());
        const std::string text = read_text(entry.path().string());
        if (is_plane_scene(text, entry.path().string(), {})) {
            const PlaneScene scene = read_plane_scene(text, entry.path().string(), {});
            CHECK(scene.title != scene.name);
            PlaneSimulation simulation(scene);
            REQUIRE(simulation.plan().steps >= 100);
            simulation.advance(100);
            CHECK(std::isfinite(simulation.energies().total()));
            continue;
        }
        const Scene scene = read_scene(entry.path().string(), {});
        CHECK(scene.title != scene.name);
        Simulation simulation(scene);
        REQUIRE(simulation.plan().steps >= 100);
        for (int step = 0; step < 100; ++step) {
            simulation.step();
        }
        CHECK(simulation.chain().is_finite());
        ++scenes;
    }
    CHECK(scenes >= 10);
}

std::string path_of(const char* scene) {
    return std::string(NMBC_SCENES) + "/" + scene;
}

/// Energy at the end over the largest on the way.
double energy_left(const Scene& scene) {
    Simulation simulation(scene);
    double peak = simulation.energies().total();
    while (!simulation.is_done()) {
        simulation.step();
        peak = std::max(peak, simulation.energies().total());
    }
    return simulation.energies().total() / peak;
}

TEST_CASE("broadband: each order leaves less") {
    const auto left = [](const char* order, const char* stride) {
        return energy_left(read_scene(path_of("broadband.toml"),
                                      {{"boundary.order", order}, {"boundary.stride", stride}}));
    };
    const double first = left("1", "1");
    const double second = left("2", "2");
    const double third = left("3", "2");
    // 1.5e-3, 1.5e-4 and 3.7e-6 were found; half of each decade is enough to be seen.
    CHECK(second < first / 5);
    CHECK(third < second / 20);
}

TEST_CASE("Fig. 6: the chain of atoms is the lattice of n = 1, G = 1/2, and so are its ends") {
    Simulation atoms(read_scene(path_of("fig6_md.toml"), {}));
    Simulation nopd(read_scene(path_of("fig11.toml"), {{"boundary.order", "1"}}));
    run_to_end(atoms);
    run_to_end(nopd);
    const auto u = interior(nopd, nopd.chain().displacement());
    // One has a ghost node at each end, the other two, with the same condition: that of the inner
    // one is the same. 2744 steps, each with roundings of 4e-19 of a largest u of 0.0025.
    CHECK(largest_error(atoms, [&](double X) { return u[std::size_t(std::lround(X)) - 1]; }) <
          2744 * 4e-19);
    CHECK(largest(u) > 1e-6);
}

TEST_CASE("incoming: what comes in leaves on the other side, or on its own from a true end") {
    // An end reflects 9e-5 of its energy: here two of them in turn, there one.
    CHECK(energy_left(read_scene(path_of("incoming.toml"), {})) < 1e-7);
    for (const std::string kind : {"fixed", "free", "node_mirror", "sbp"}) {
        CAPTURE(kind);
        CHECK(energy_left(read_scene(path_of("incoming.toml"), {{"boundary.right.kind", kind}})) <
              2e-4);
    }
}

TEST_CASE("at the G that a plane scene is told its long waves have one speed, at every angle") {
    PlaneScene scene;
    scene.nu = {3, 10};
    scene.state = nmbc::StressState::plane_strain;
    for (const unsigned radius_squared : {1U, 4U, 9U}) {
        for (const bool is_P : {true, false}) {
            scene.radius_squared = radius_squared;
            const double best = G_of_least_dispersion(scene, is_P);
            CHECK(best > 0);
            for (const double angle : {0.0, 0.3, 0.7}) {
                constexpr double xi = 0.1;
                const auto error = [&](double G) {
                    PlaneScene other = scene;
                    other.G = G;
                    const nmbc::PlaneModel model = model_of(other);
                    const double speed = is_P ? model.speed_P() : model.speed_S();
                    return std::abs(
                        nmbc::plane_wave(model, {xi * std::cos(angle), xi * std::sin(angle)}, is_P)
                                .omega_squared /
                            std::pow(speed * xi, 2) -
                        1);
                };
                CHECK(error(best) < 0.02 * error(0));  // xi^4 in the place of xi^2
            }
        }
    }
}

}  // namespace
}  // namespace nmbcrun::test
