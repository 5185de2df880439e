// SPDX-License-Identifier: GPL-2.0-or-later
/// Ends that let a field in: a preload stays at rest, an incoming wave is a wave of the lattice,
/// and what comes back leaves.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/nmbcrun/bar.hpp"
#include "tools/nmbcrun/ends/lattice_wave.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/sources/incoming_wave.hpp"

namespace nmbcrun::test {
namespace {

constexpr double amplitude = 0.01;

/// A packet, or for wave_number = 0 a Gaussian, 10 nodes wide.
Incoming incoming(nmbc::End end, double wave_number, double arrival) {
    return {end,
            {wave_number == 0 ? Shape::gaussian : Shape::packet, amplitude, 5, wave_number},
            arrival};
}

/// The incoming wave of a scene at the interior nodes in a step of its run.
std::vector<double> wave_at(const Simulation& simulation, std::size_t step) {
    IncidentField incident;
    const nmbc::Chain& chain = simulation.chain();
    add_incoming_wave(simulation.scene(), chain.lattice(), chain.parameters(),
                      simulation.plan().steps, incident);
    std::vector<double> u(chain.parameters().nodes);
    std::vector<double> v(u.size());
    WavesAtNodes(incident.waves, 1 - incident.origin, chain.parameters().time_step)
        .add(double(step) - incident.arrival, u, v);
    return u;
}

double largest_difference(std::span<const double> left, std::span<const double> right) {
    double most = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        most = std::max(most, std::abs(left[i] - right[i]));
    }
    return most;
}

TEST_CASE("a preload stays at rest for 100 000 steps, whatever the ends") {
    constexpr double strain = 0.01;
    for (const auto kind :
         {BoundaryKind::nmbc, BoundaryKind::fixed, BoundaryKind::free, BoundaryKind::extended}) {
        Scene scene = bar(50, 1e9);
        scene.preload = Preload{strain};
        scene.left.kind = kind;
        scene.left.layer = kind == BoundaryKind::extended ? 7 : 0;
        scene.right = scene.left;
        Simulation simulation(scene);
        constexpr int steps = 100'000;
        for (int step = 0; step < steps; ++step) {
            simulation.step();
        }
        // u is 0.16 at most; a rounding of it, 1.4e-17, in each step and always in one direction.
        CHECK(largest_error(simulation, [](double X) { return strain * (X - 25.5 * 0.5); }) <
              1.4e-17 * steps);
        CHECK(largest(simulation.chain().velocity()) < 1e-12);  // 1e-14 was seen
    }
}

TEST_CASE("a pulse runs over a preload as it does without one") {
    Scene scene = bar(100, 10);
    scene.initial = Initial{InitialKind::to_the_right, {Shape::gaussian, amplitude, 4, 0}, 25, {}};
    Simulation alone(scene);
    scene.preload = Preload{0.01};
    Simulation loaded(scene);
    run_to_end(alone);
    run_to_end(loaded);
    const auto u = interior(alone, alone.chain().displacement());
    // 282 steps, each with roundings of 0.25.
    CHECK(largest_error(loaded, [&](double X) {
              return 0.01 * (X - 50.5 * 0.5) + u[std::size_t(std::lround(X / 0.5)) - 1];
          }) < 300 * 2.8e-17);
}

TEST_CASE("a driven node under preload is driven from where it is") {
    Scene scene = bar(60, 5);
    scene.preload = Preload{0.01};
    scene.drive = Drive{0.002, 2, 20, 0};
    Simulation simulation(scene);
    simulation.step();
    const double phase = std::acos(-1.0) * simulation.chain().time() / 2;
    const std::size_t node = simulation.chain().first_interior() + 39;
    // Roundings of u = 0.1, divided and multiplied by dt.
    CHECK(std::abs(simulation.chain().displacement()[node] -
                   (0.01 * (20 - 30.5 * 0.5) + 0.001 * (1 - std::cos(phase)))) < 1e-16);
}

TEST_CASE("an incoming wave is inside what it is in a lattice without end") {
    for (const auto end : {nmbc::End::left, nmbc::End::right}) {
        for (const auto kind : {BoundaryKind::nmbc, BoundaryKind::fixed, BoundaryKind::free,
                                BoundaryKind::extended}) {
            for (const double wave_number : {0.0, 0.5, 2.4}) {  // at 2.4 phases run backwards
                Scene scene = bar(300, 25);
                scene.left.kind = kind;
                scene.left.layer = kind == BoundaryKind::extended ? 7 : 0;
                scene.right = scene.left;
                scene.incoming = incoming(end, wave_number, 15);
                Simulation simulation(scene);
                run_to_end(simulation);
                // What the far end makes of the first trace of it has not come as far as here.
                const std::size_t first = end == nmbc::End::left ? 0 : 200;
                const auto u =
                    interior(simulation, simulation.chain().displacement()).subspan(first, 100);
                const auto wave = wave_at(simulation, simulation.plan().steps);
                CAPTURE(wave_number);
                CHECK(largest(u) > 0.1 * amplitude);
                // 177 steps, each with roundings of 1e-18: 6e-16 was seen.
                CHECK(largest_difference(u, std::span(wave).subspan(first, 100)) <
                      1e-13 * amplitude);
            }
        }
    }
}

TEST_CASE("it is the pulse when it arrives, with its middle at the outermost node") {
    Scene scene = bar(100, 15);
    scene.incoming = incoming(nmbc::End::left, 0.3, 15);
    scene.cfl.reset();
    scene.step = 0.1;  // a step ends at 15
    Simulation simulation(scene);
    run_to_end(simulation);
    CHECK(largest_error(simulation, [](double X) {
              const double x = X - 0.5;
              return amplitude * std::exp(-x * x / 25) * std::cos(0.3 * x / 0.5);
          }) < 1e-12 * amplitude);  // 150 steps, as above
}

TEST_CASE("the other end reflects it as a wave that was inside from the start") {
    Scene scene = bar(100, 15 + 35);
    scene.cfl.reset();
    scene.step = 0.1;
    scene.incoming = incoming(nmbc::End::left, 0.5, 15);
    Simulation simulation(scene);
    run_to_end(simulation);
    // The same end, and 200 nodes more on the left, so that the pulse starts inside.
    Scene longer = bar(300, 35);
    longer.cfl.reset();
    longer.step = 0.1;
    longer.initial = Initial{InitialKind::to_the_right, scene.incoming->pulse, 100.5, {}};
    Simulation from_inside(longer);
    run_to_end(from_inside);
    const auto u = interior(simulation, simulation.chain().displacement());
    const auto same = interior(from_inside, from_inside.chain().displacement()).subspan(200);
    CHECK(largest(u) > 0.02 * amplitude);
    // 5e-12 was seen: the first trace of what is reflected has come back to the left end.
    CHECK(largest_difference(u, same) < 1e-10 * amplitude);
}

TEST_CASE("a smooth wave drives the bar until it has passed its end") {
    Scene scene = bar(100, 100);
    scene.incoming = Incoming{nmbc::End::left, {Shape::gaussian, amplitude, 10, 0}, 40};
    Simulation simulation(scene);
    // 20 nodes wide, it goes 4 nodes in a unit of time: 1e-16 of it is left after 32.5.
    CHECK(simulation.is_driven(70));
    CHECK(!simulation.is_driven(90));
}

TEST_CASE("from a fixed end it comes back and leaves through the end it came by") {
    Scene scene = bar(100, 100);
    scene.left.order = scene.left.stride = 2;
    scene.right.kind = BoundaryKind::fixed;
    scene.cfl = 0.3;
    scene.incoming = incoming(nmbc::End::left, 0.3, 20);
    Simulation simulation(scene);
    double peak = 0;
    double half_way = 0;
    while (!simulation.is_done()) {
        simulation.step();
        const double total = simulation.energies().total();
        peak = std::max(peak, total);
        half_way = simulation.chain().time() < 57 ? total : half_way;
    }
    CHECK(half_way > 0.99 * peak);                       // after the fixed end, in the middle again
    CHECK(simulation.energies().total() < 2e-4 * peak);  // NMBC2 of this packet; 1.2e-4 was seen
}

TEST_CASE("what does not come in is refused") {
    const auto refused = [](const Incoming& what, const std::string& tau, double end) {
        Scene scene = bar(100, end);
        scene.tau = tau;
        if (tau != "0") {
            scene.left.order = scene.right.order = 2;
            scene.left.stride = scene.right.stride = 2;
        }
        scene.incoming = what;
        try {
            const Simulation simulation(scene);
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refused(incoming(nmbc::End::left, 0, 15), "1/100", 25).find("damped lattice") !=
          std::string::npos);
    CHECK(refused({nmbc::End::left, {Shape::packet, amplitude, 1000, 3.14159}, 15}, "0", 25)
              .find("nothing comes in") != std::string::npos);
    CHECK(refused({nmbc::End::left, {Shape::gaussian, amplitude, 0.01, 0}, 15}, "0", 25)
              .find("a tenth") != std::string::npos);
    CHECK(refused({nmbc::End::left, {Shape::packet, amplitude, 1, 1.8}, 1e6}, "0", 2e6)
              .find("at most 100000") != std::string::npos);
}

}  // namespace
}  // namespace nmbcrun::test
