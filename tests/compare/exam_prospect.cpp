// SPDX-License-Identifier: GPL-2.0-or-later
/// What is predicted of a run before it begins is what it measures.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/compare/advised_scenes.hpp"
#include "tools/nmbcrun/prediction/prospect.hpp"
#include "tools/nmbcrun/prediction/source_spectrum.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"

namespace {

using namespace advised_scenes;
using nmbcrun::BoundaryKind;
using nmbcrun::Shape;
using nmbcrun::Simulation;

struct Difference {
    double largest = 0;   ///< of the shares of energy below a wave number
    double steepest = 0;  ///< largest share of one part
};

/// Of the only source, and what a chain measures of it when it has acted, in the same parts.
Difference difference_of(Scene scene) {
    scene.left = {.kind = BoundaryKind::extended, .layer = 400};
    scene.right = scene.left;
    scene.cfl = 0.1;  // u and v are half a step apart, which counts for the shortest waves
    Simulation simulation(scene);
    const auto spectra =
        nmbcrun::source_spectra(scene, simulation.chain().lattice(), simulation.plan().time_step);
    REQUIRE(spectra.size() == 1);
    do {
        simulation.step();
    } while (simulation.is_driven(simulation.chain().time()));
    const nmbcrun::Spectrum measured(simulation.chain(), spectra.front().spectrum.parts());
    Difference difference;
    double below = 0;
    for (std::size_t part = 0; part < measured.parts(); ++part) {
        below += measured.share(part) - spectra.front().spectrum.share(part);
        difference.largest = std::max(difference.largest, std::abs(below));
        difference.steepest = std::max(difference.steepest, measured.share(part));
    }
    return difference;
}

constexpr double time_of_ricker = 60;

/// The only warning of a ricker too short for its lattice.
std::string warning_of_short_ricker(double end) {
    Scene scene = scene_of(2, 32.0 / 15, 100, end);
    scene.cfl = 0.3;
    scene.force = nmbcrun::Force{
        {.history = nmbcrun::History::ricker, .time = time_of_ricker, .duration = 2, .file = {}},
        50,
        0};
    const auto warnings = prospect_of(Simulation(scene)).warnings;
    REQUIRE(warnings.size() == 1);
    return warnings.front();
}

TEST_CASE("spectra of sources are those of the waves that they send out") {
    Scene forced = scene_of(2, 1.5, 300, 500);
    forced.force = nmbcrun::Force{
        {.history = nmbcrun::History::ricker, .time = 40, .duration = 6, .file = {}}, 150, 2};
    Scene sine = forced;
    sine.force->history = nmbcrun::History::sine;
    sine.force->time = 5;
    sine.force->frequency = 0.08;
    sine.force->cycles = 6;
    Scene velocity = with_pulse(scene_of(1, 0.5, 200, 400), Shape::ricker, 4);
    velocity.initial->kind = nmbcrun::InitialKind::velocity;
    for (const Scene& scene :
         {with_pulse(scene_of(2, 1.5, 300, 450), Shape::ricker, 5),
          with_pulse(scene_of(2, 0, 300, 450), Shape::gaussian, 1.5),
          with_pulse(scene_of(1, 0.5, 200, 500), Shape::packet, 20, 0.9), velocity, forced, sine,
          with_drive(scene_of(2, 1.85, 300, 415), 95)}) {
        const Difference difference = difference_of(scene);
        // A wave number belongs to one part or to the next.
        CHECK(difference.largest < std::max(0.02, difference.steepest));
    }
}

TEST_CASE("what comes back is foretold, and what is amplified") {
    Scene scene = with_pulse(scene_of(3, 0, 200, 3000), Shape::ricker, 2);
    scene.cfl = 0.3;
    const auto amplified = prospect_of(Simulation(scene));
    CHECK(amplified.objection.find(
              "NMBC1, stride 1, midpoint ghosts on the left sends back up to") == 0);
    REQUIRE(amplified.warnings.size() == 1);
    CHECK(amplified.warnings.front().find("initial sends out") != std::string::npos);
    CHECK(amplified.warnings.front().find("; initial.width = ") !=
          std::string::npos);  // a smooth one excites no zero-energy mode
    scene.G = 27.0 / 7;
    scene.initial->pulse.width = 12;
    const auto absorbed = prospect_of(Simulation(scene));
    CHECK(absorbed.objection.empty());
    CHECK(absorbed.warnings.empty());
    // Nothing is under way long enough; nothing to say of physical ends.
    scene.end = 20;
    CHECK(prospect_of(Simulation(scene)).ends == "nothing gets there before time.end");
    scene.left = {.kind = BoundaryKind::fixed};
    scene.right = {.kind = BoundaryKind::free};
    CHECK(prospect_of(Simulation(scene)).ends.empty());
    scene.left = {.kind = BoundaryKind::sponge, .layer = 401};
    CHECK(prospect_of(Simulation(scene)).ends ==
          "nothing is predicted of a sponge of more than 400 nodes: nmbcrun verify measures it");
    scene.left = {.kind = BoundaryKind::exact};
    scene.end = 300;
    CHECK(prospect_of(Simulation(scene)).ends ==
          "nothing of the energy that reaches them comes back");
}

TEST_CASE("a matching end that sends back next to nothing is not said to send back nothing") {
    const Scene scene = with_pulse(scene_of(1, 0.5, 2000, 3000), Shape::gaussian, 120);
    CHECK(prospect_of(Simulation(scene)).ends ==
          "less than 1e-12 of the energy that reaches them comes back");
}

TEST_CASE("what an extended end sends back is what gets to its far end and has the time") {
    // Long waves travel 180 spacings, 100 of them to each end: 80 are left.
    Scene scene = with_pulse(scene_of(2, 32.0 / 15, 200, 180), Shape::gaussian, 8);
    const auto prospect_at = [&](std::size_t layer) {
        scene.left = scene.right = {.kind = BoundaryKind::extended, .layer = layer};
        return prospect_of(Simulation(scene));
    };
    CHECK(prospect_at(20).ends.starts_with("all of the energy that reaches them comes back"));
    CHECK(prospect_at(20).sends_much_back);
    CHECK(prospect_at(90).ends == "nothing of the energy that reaches them comes back");
    CHECK(!prospect_at(90).sends_much_back);
}

TEST_CASE("a layer too thin to absorb is said to send back what comes") {
    Scene scene = with_pulse(scene_of(2, 32.0 / 15, 200, 400), Shape::gaussian, 12);
    for (const auto kind : {BoundaryKind::sponge, BoundaryKind::pml}) {
        scene.left = scene.right = {.kind = kind, .layer = 1};
        const auto thin = prospect_of(Simulation(scene));
        CHECK(thin.sends_much_back);
        CHECK(thin.ends.find("of the energy that reaches them comes back") != std::string::npos);
        CHECK(thin.objection.empty());
    }
    scene.left = scene.right = {.kind = BoundaryKind::pml, .layer = 20};
    CHECK(!prospect_of(Simulation(scene)).sends_much_back);
}

TEST_CASE("what a force sends out late does not get to an end in time") {
    Scene scene = scene_of(2, 0, 200, 300);  // at G = 0 its short waves would be amplified
    scene.force = nmbcrun::Force{
        {.history = nmbcrun::History::ricker, .time = 20, .duration = 2, .file = {}}, 100, 0};
    CHECK(!prospect_of(Simulation(scene)).objection.empty());
    scene.force->time = 290;
    CHECK(prospect_of(Simulation(scene)).objection.empty());
    CHECK(prospect_of(Simulation(scene)).ends == "nothing gets there before time.end");
}

TEST_CASE("the pulse of a run of many steps is met") {
    Scene scene = scene_of(2, 32.0 / 15, 200, 300);
    scene.force = nmbcrun::Force{
        {.history = nmbcrun::History::gaussian, .time = 60, .duration = 12, .file = {}}, 100, 0};
    const std::string ends = prospect_of(Simulation(scene)).ends;
    CHECK(ends.find("of the energy that reaches them comes back") != std::string::npos);
    scene.end = 1e8;
    CHECK(prospect_of(Simulation(scene)).ends == ends);
}

TEST_CASE("of energies that doubles do not hold nothing is predicted") {
    Scene scene = with_pulse(scene_of(2, 1, 200, 300), Shape::gaussian, 8);
    for (const double amplitude : {1e-165, 1e165}) {
        scene.initial->pulse.amplitude = amplitude;
        CHECK(prospect_of(Simulation(scene)).ends.starts_with("nothing is predicted: "));
    }
    scene.left = scene.right = {.kind = BoundaryKind::free};
    CHECK(prospect_of(Simulation(scene)).ends.empty());
}

TEST_CASE("a source that would do is over before the run ends, or a later end is told") {
    const std::string warning = warning_of_short_ricker(70);
    const auto value_of = [&](const std::string& key) {
        const std::size_t place = warning.find(key + " = ");
        REQUIRE(place != std::string::npos);
        return std::stod(warning.substr(place + key.size() + 3));
    };
    const double end = value_of("time.end");
    CHECK(end > 70);
    CHECK(warning.find("force.time") == std::string::npos);
    CHECK(time_of_ricker + 4 * value_of("force.duration") <= end);
}

TEST_CASE("a longer source that begins in the run keeps its time") {
    const std::string warning = warning_of_short_ricker(700);
    CHECK(warning.find("; force.duration = ") != std::string::npos);
    CHECK(warning.find("force.time") == std::string::npos);
    CHECK(warning.find("time.end") == std::string::npos);
}

TEST_CASE("a width that would do does, and a packet of short waves has none") {
    Scene scene = with_pulse(scene_of(2, 1, 400, 300), Shape::gaussian, 1);
    scene.cfl = 0.3;
    const auto prospect = prospect_of(Simulation(scene));
    REQUIRE(prospect.warnings.size() == 1);
    const std::string& warning = prospect.warnings.front();
    const std::size_t value = warning.find("initial.width = ");
    REQUIRE(value != std::string::npos);
    scene.initial->pulse.width = std::stod(warning.substr(value + 16));
    CHECK(scene.initial->pulse.width > 1);
    CHECK(scene.initial->pulse.width < 10);
    CHECK(prospect_of(Simulation(scene)).warnings.empty());
    scene.initial->pulse = {
        .shape = Shape::packet, .amplitude = 1, .width = 20, .wave_number = 2.8};
    const auto packet = prospect_of(Simulation(scene)).warnings;
    REQUIRE(packet.size() == 1);
    CHECK(packet.front().find("; no initial.width within a factor of 1000 cures it") !=
          std::string::npos);
}

}  // namespace
