// SPDX-License-Identifier: GPL-2.0-or-later
/// What a chain is started with: shapes, waves that go one way, the field of another run.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "tests/nmbcrun/bar.hpp"
#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun::test {
namespace {

constexpr double height = 0.01;
constexpr double middle = 100;  // node 200

Scene started(InitialKind kind, const Pulse& pulse, double end) {
    Scene scene = bar(400, end);
    scene.initial = Initial{kind, pulse, middle, {}};
    return scene;
}

/// Kinetic energy at nodes left of the centre over that of all.
double share_on_the_left(const Simulation& simulation) {
    const auto v = interior(simulation, simulation.chain().velocity());
    double left = 0;
    double all = 0;
    for (std::size_t node = 0; node < v.size(); ++node) {
        all += v[node] * v[node];
        left += node < 199 ? v[node] * v[node] : 0;
    }
    return left / all;
}

TEST_CASE("the shapes, at t = 0 and on every node") {
    const Pulse pulses[]{{Shape::gaussian, height, 4, 0},
                         {Shape::ricker, height, 4, 0},
                         {Shape::packet, height, 4, 0.7}};
    const auto value = [](Shape shape, double x) {
        const double envelope = height * std::exp(-x * x / 16);
        return shape == Shape::gaussian ? envelope
               : shape == Shape::ricker ? envelope * (1 - x * x / 8)
                                        : envelope * std::cos(1.4 * x);
    };
    for (const Pulse& pulse : pulses) {
        for (const auto kind : {InitialKind::displacement, InitialKind::to_the_left}) {
            const Simulation simulation(started(kind, pulse, 10));
            CHECK(largest_error(simulation, [&](double X) {
                      return value(pulse.shape, X - middle);
                  }) < 1e-15 * height);
        }
        const Simulation pushed(started(InitialKind::velocity, pulse, 10));
        CHECK(largest(pushed.chain().displacement()) == 0);
        const auto v = interior(pushed, pushed.chain().velocity());
        for (std::size_t node = 0; node < v.size(); ++node) {
            CHECK(
                v[node] ==
                doctest::Approx(value(pulse.shape, double(node + 1) / 2 - middle)).epsilon(1e-12));
        }
    }
}

TEST_CASE("without a direction it goes both ways alike") {
    Simulation simulation(started(InitialKind::displacement, {Shape::ricker, height, 4, 0}, 20));
    run_to_end(simulation);
    // The middle node is left out of the left half, and has next to nothing.
    CHECK(share_on_the_left(simulation) == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("a wave goes one way, at its group velocity, phases backwards or not") {
    for (const double wave_number : {0.5, 1.0, 2.4}) {
        const Pulse pulse{Shape::packet, height, 10, wave_number};
        Simulation right(started(InitialKind::to_the_right, pulse, 30));
        Simulation left(started(InitialKind::to_the_left, pulse, 30));
        const double start = centre_of_energy(right);
        CHECK(start == doctest::Approx(200).epsilon(5e-3));  // half a step ago
        run_to_end(right);
        run_to_end(left);
        CAPTURE(wave_number);
        // Mirror images of each other.
        CHECK(centre_of_energy(right) - 200 ==
              doctest::Approx(200 - centre_of_energy(left)).epsilon(1e-9));
        // The group velocity of leapfrog waves, from omega_d at two wave numbers.
        const nmbc::Lattice& lattice = right.chain().lattice();
        const double courant = 4 * right.plan().time_step;  // c dt/dX
        const auto omega = [&](double xi) {
            return 2 / right.plan().time_step *
                   std::asin(courant / 2 * std::sqrt(omega_squared(lattice, xi)));
        };
        const double velocity =
            std::abs(omega(wave_number + 1e-4) - omega(wave_number - 1e-4)) / 2e-4;
        const double time = right.chain().time();
        // The packet's other wave numbers have other speeds.
        CHECK((centre_of_energy(right) - start) / time ==
              doctest::Approx(velocity).scale(0).epsilon(0.03));
    }
}

TEST_CASE("nothing of a smooth wave goes the other way") {
    Simulation simulation(started(InitialKind::to_the_right, {Shape::gaussian, height, 5, 0}, 40));
    run_to_end(simulation);
    // It is 160 nodes on; roundings are left, squared.
    CHECK(share_on_the_left(simulation) < 1e-28);
}

TEST_CASE("nor in a damped lattice, where it loses energy on its way") {
    Scene scene = started(InitialKind::to_the_left, {Shape::gaussian, height, 5, 0}, 40);
    scene.tau = "1/100";
    scene.left.order = scene.left.stride = 2;
    scene.right = scene.left;
    scene.cfl = 0.3;
    Simulation simulation(scene);
    const double start = simulation.energies().total();
    run_to_end(simulation);
    CHECK(1 - share_on_the_left(simulation) < 1e-28);
    CHECK(simulation.energies().total() < start);
}

TEST_CASE("the field of a run goes on in another") {
    const auto file = std::filesystem::temp_directory_path() / "exam_initial_field.csv";
    Scene scene = started(InitialKind::displacement, {Shape::packet, height, 4, 0.7}, 10);
    Simulation whole(scene);
    run_to_end(whole);
    {
        std::ofstream stream(file);
        stream.precision(std::numeric_limits<double>::max_digits10);
        stream << "node,x,u,v\n";
        for (std::size_t node = 1; node <= scene.nodes; ++node) {
            const std::size_t entry = whole.chain().first_interior() + node - 1;
            stream << node << ",0," << whole.chain().displacement()[entry] << ","
                   << whole.chain().velocity()[entry] << "\n";
        }
    }
    scene.initial = Initial{InitialKind::file, {}, 0, file};
    Simulation resumed(scene);
    std::filesystem::remove(file);
    run_to_end(resumed);
    for (std::size_t step = 0; step < whole.plan().steps; ++step) {
        whole.step();
    }
    const auto u = interior(whole, whole.chain().displacement());
    // Nothing has come near the ends: bit for bit.
    CHECK(largest_error(resumed,
                        [&](double X) { return u[std::size_t(std::lround(X / 0.5)) - 1]; }) == 0);
}

TEST_CASE("files that are no field of this bar are refused") {
    const auto file = std::filesystem::temp_directory_path() / "exam_initial_bad.csv";
    const auto refused = [&](const std::string& text) {
        std::ofstream(file) << text;
        Scene scene = bar(3, 1);
        scene.initial = Initial{InitialKind::file, {}, 0, file};
        try {
            const Simulation simulation(scene);
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const std::pair<const char*, const char*> bad[]{
        {"", "has no row"},
        {"node,u,v\n", "has no row"},
        {"node,u\n1,0\n", ":1: the header has no column 'v'"},
        {"node,u,v\n1,0\n", ":2: column 'v' is missing"},
        {"node,u,v\n\n# note\n1,0,x\n", ":4: 'x' is not a finite number"},
        {"node,u,v\n1,0,nan\n", "is not a finite number"},
        {"node,u,v\n1,0,1e999\n", "is not a finite number"},
        {"node,u,v\n4,0,0\n", "node 4 is none of the 3"},
        {"node,u,v\n1.5,0,0\n", "node 1.5 is none"},
        {"node,u,v\n0,0,0\n", "node 0 is none"},
        {"node,u,v\n2,0,0\n2,0,0\n", "node 2 is there twice"}};
    for (const auto& each : bad) {
        CAPTURE(each.first);
        CHECK(refused(each.first).find(each.second) != std::string::npos);
    }
    CHECK(refused("v , u,node\r\n1,2,3\r\n") == "");
    std::filesystem::remove(file);
    Scene scene = bar(3, 1);
    scene.initial = Initial{InitialKind::file, {}, 0, file};
    CHECK_THROWS_AS(Simulation{scene}, FileError);
}

TEST_CASE("energies have the same digits in vectors of any width") {
    for (const double G : {0.0, 1.0}) {
        Scene scene = started(InitialKind::velocity, {Shape::packet, height, 4, 0.7}, 10);
        scene.G = G;
        Simulation simulation(scene);
        simulation.advance(37);
        const nmbc::Energies wide = simulation.energies();
        const nmbc::Energies narrow = nmbc::energies(simulation.chain());
        CHECK(wide.kinetic > 0);
        CHECK(wide.kinetic == narrow.kinetic);
        CHECK(wide.strain == narrow.strain);
        CHECK(wide.stabilisation == narrow.stabilisation);
        CHECK(wide.staggered == narrow.staggered);
    }
}

}  // namespace
}  // namespace nmbcrun::test
