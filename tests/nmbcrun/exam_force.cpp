// SPDX-License-Identifier: GPL-2.0-or-later
/// Body forces: their histories, and the momentum they give.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "tests/nmbcrun/bar.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/sources/forcing.hpp"

namespace nmbcrun::test {
namespace {

Scene forced(const Force& force, double end = 60) {
    Scene scene = bar(400, end);
    scene.force = force;
    return scene;
}

Force gaussian(double half_width) {
    return {{.history = History::gaussian, .amplitude = 0.3, .time = 12, .duration = 2, .file = {}},
            100,
            half_width};
}

TEST_CASE("histories") {
    const Forcing pulse(forced(gaussian(0)), 0.1);
    CHECK(pulse.force_at(12) == 0.3);
    CHECK(pulse.force_at(14) == doctest::Approx(0.3 * std::exp(-1)));
    CHECK(pulse.force_at(8) == doctest::Approx(0.3 * std::exp(-4)));
    CHECK(pulse.drives(24.9));
    CHECK(!pulse.drives(25.1));  // 12 + 6.5 durations

    Force ricker = gaussian(0);
    ricker.history = History::ricker;
    CHECK(Forcing(forced(ricker), 0.1).force_at(14) == doctest::Approx(-0.3 * std::exp(-1)));
    CHECK(Forcing(forced(ricker), 0.1).force_at(12) == 0.3);

    const Force sine{{.history = History::sine,
                      .amplitude = 2,
                      .time = 3,
                      .frequency = 0.5,
                      .cycles = 1.25,
                      .file = {}},
                     100,
                     0};
    const Forcing burst(forced(sine), 0.1);
    CHECK(burst.force_at(2.9) == 0);
    CHECK(burst.force_at(3.5) == doctest::Approx(2));
    CHECK(burst.force_at(4.5) == doctest::Approx(-2));
    CHECK(burst.force_at(5.5) == doctest::Approx(2));
    CHECK(burst.force_at(5.6) == 0);
    CHECK(burst.drives(5.4));
    CHECK(!burst.drives(5.6));
}

TEST_CASE("a history of a file is linear in between, and 0 outside") {
    const auto file = std::filesystem::temp_directory_path() / "exam_force.csv";
    Force force{{.history = History::file, .amplitude = 10, .time = 5, .file = file}, 100, 0};
    std::ofstream(file) << "time,force\n0,1\n2,3\n3,-1\n";
    const Forcing forcing(forced(force), 0.1);
    CHECK(forcing.force_at(4.9) == 0);
    CHECK(forcing.force_at(5) == 10);
    CHECK(forcing.force_at(6) == 20);
    CHECK(forcing.force_at(7) == 30);
    CHECK(forcing.force_at(7.75) == doctest::Approx(0));
    CHECK(forcing.force_at(8) == -10);
    CHECK(forcing.force_at(8.1) == 0);
    std::ofstream(file) << "time,force\n0,1\n0,3\n";
    CHECK_THROWS_WITH_AS(Forcing(forced(force), 0.1),
                         doctest::Contains("its times must ascend from row to row"), SceneError);
    for (const char* idle : {"time,force\n0,1\n", "time,force\n0,0\n1,0\n2,0\n"}) {
        std::ofstream(file) << idle;
        CHECK_THROWS_WITH_AS(Forcing(forced(force), 0.1), doctest::Contains("it drives nothing"),
                             SceneError);
    }
    std::filesystem::remove(file);
    CHECK_THROWS_AS(Forcing(forced(force), 0.1), FileError);
}

TEST_CASE("a history that is cut off at the beginning or the end of a run is told") {
    const auto only = [](const std::vector<std::string>& warnings) {
        REQUIRE(warnings.size() == 1);
        return warnings.front();
    };
    const auto of = [](History history, double time) {
        return ForceInTime({.history = history,
                            .amplitude = -0.3,
                            .time = time,
                            .duration = history == History::sine ? 0.0 : 2.0,
                            .frequency = 0.25,
                            .cycles = 1.5,
                            .file = {}});
    };
    const double step = 0.1;
    CHECK(of(History::gaussian, 8).warnings("force", step, 16).empty());
    CHECK(of(History::ricker, 8).warnings("force", step, 16).empty());
    CHECK(of(History::ricker, 5).warnings("force", step, 16).empty());  // -0.022, of plane_box.toml
    CHECK(of(History::sine, 0).warnings("force", step, 6).empty());
    CHECK(only(of(History::gaussian, 2).warnings("force", step, 16)) ==  // exp(-1)
          "force jumps to -0.37 of its peak at t = 0, and what is before is cut off: "
          "force.time = 8 would do");
    // At a zero of a ricker, of which -2 exp(-3/2) is cut off.
    CHECK(only(of(History::ricker, 2 / std::numbers::sqrt2).warnings("force", step, 16))
              .starts_with("force jumps to "));
    CHECK(only(of(History::sine, -1).warnings("force", step, 16)) ==
          "force jumps to -1 of its peak at t = 0, and what is before is cut off: force.time = 0 "
          "would do");
    CHECK(only(of(History::gaussian, 14).warnings("boundary.left.value", step, 16)) ==
          "boundary.left.value has not ended at time.end = 16: up to 0.37 of its peak comes later. "
          "time.end = 22 or more has all of it");
    CHECK(only(of(History::gaussian, 20).warnings("force", step, 16)).find("up to 1 of its peak") !=
          std::string::npos);
    CHECK(only(of(History::sine, 2).warnings("force", step, 4.5)).find("up to 1 of its peak") !=
          std::string::npos);
    // What is proposed can be run.
    const auto both = of(History::gaussian, 2).warnings("force", step, 3);
    REQUIRE(both.size() == 2);
    CHECK(both.front().ends_with("force.time = 8 with time.end = 16 would do"));

    const auto file = std::filesystem::temp_directory_path() / "exam_force_cut.csv";
    const auto of_rows = [&](const char* rows) {
        std::ofstream(file) << "time,force\n" << rows;
        return ForceInTime({.history = History::file, .time = 1, .file = file});
    };
    CHECK(of_rows("0,0\n1,2\n2,0\n").warnings("force", step, 4).empty());
    CHECK(of_rows("0,0\n1,2\n9,2\n").warnings("load.top", step).empty());  // a load may stay
    CHECK(of_rows("0,0\n1,2\n9,2\n").warnings("force", step, 4).empty());
    CHECK(
        only(of_rows("0,0\n1,2\n9,2\n").warnings("force", step, 1.5)) ==  // on its way up
        "force has not ended at time.end = 1.5: up to 1 of its peak comes later. time.end = 10 or "
        "more has all of it");
    CHECK(only(of_rows("0,0\n1,2\n9,1\n").warnings("force", step, 4))
              .starts_with("force has not ended at time.end = 4: up to "));
    CHECK(only(of_rows("0,1\n1,2\n2,0\n").warnings("force", step, 4)) ==
          "force jumps to 0.5 of its peak at t = 1: a first row of 0, at t = 0 or later, would do");
    CHECK(only(of_rows("-2,0\n0,2\n2,0\n").warnings("load.top", step)) ==
          "load.top jumps to 0.5 of its peak at t = 0, and what is before is cut off: a first row "
          "of 0, at t = 0 or later, would do");
    std::filesystem::remove(file);
}

TEST_CASE("steps that do not resolve a force are refused with what is allowed") {
    const auto refusal = [](const ForceHistory& history, double step) {
        return refusal_of([&] { ForceInTime(history).require_resolved("force", step); });
    };
    ForceHistory pulse{.history = History::gaussian, .time = 8, .duration = 2, .file = {}};
    CHECK(refusal(pulse, 2).empty());
    CHECK(refusal(pulse, 2.25) ==
          "force.duration is 2, less than a time step of 2.25: steps meet it by chance only. Give "
          "force.duration = 2.3 or more, or time.step = 2 or less");
    pulse.history = History::ricker;
    CHECK(!refusal(pulse, 2.25).empty());
    ForceHistory sine{.history = History::sine, .frequency = 0.25, .cycles = 1.5, .file = {}};
    CHECK(refusal(sine, 1).empty());
    CHECK(refusal(sine, 1.125) ==
          "force.frequency is 0.25, with a period of 4, less than 4 time steps of 1.12: steps meet "
          "it by chance only. Give force.frequency = 0.22 or less, or time.step = 1 or less");
    sine.cycles = 0.375;
    CHECK(refusal(sine, 1) ==
          "force.cycles is 0.375, which lasts 1.5, less than 2 time steps of 1: steps meet it by "
          "chance only. Give force.cycles = 0.5 or more, or time.step = 0.75 or less");
    // Where the run makes one, and where a surface has it.
    Scene scene = forced({pulse, 100, 0});
    scene.step = 0.01;
    scene.force->duration = 0.001;
    CHECK_THROWS_WITH_AS(Simulation{scene}, doctest::Contains("force.duration is 0.001, less"),
                         SceneError);
    scene.left = {.kind = BoundaryKind::mirror, .value = scene.force};
    scene.force.reset();
    CHECK_THROWS_WITH_AS(Simulation{scene}, doctest::Contains("boundary.left.value.duration is"),
                         SceneError);
}

TEST_CASE("a force moves the bar by its impulse over 2 rho c") {
    for (const int nodes : {1, 5}) {
        Simulation simulation(forced(gaussian(0.25 * (nodes - 1)), 40));
        run_to_end(simulation);
        // Two waves leave a step of u behind them: each has half of the impulse, and a step of u
        // that moves at c the momentum rho c u. The sum over time steps is the integral to
        // exp(-(pi duration/dt)^2). Short waves that are still there are 2.3e-5 of it, and half of
        // that at twice the time.
        const double impulse = 0.3 * nodes * 0.5 * 2 * std::sqrt(std::numbers::pi);
        const double u =
            simulation.chain().displacement()[simulation.chain().first_interior() + 199];
        CHECK(u == doctest::Approx(impulse / (2 * 3 * 2)).scale(0).epsilon(3e-5));
    }
}

TEST_CASE("the very first step: v = dt f(0) / rho") {
    Force force = gaussian(0);
    force.time = 0;
    Simulation simulation(forced(force));
    simulation.step();
    const double v = simulation.chain().velocity()[simulation.chain().first_interior() + 199];
    CHECK(v == doctest::Approx(simulation.plan().time_step * 0.3 / 3).scale(0).epsilon(1e-15));
}

TEST_CASE("a force without nodes is refused") {
    Force force = gaussian(0);
    force.centre = -3;
    CHECK_THROWS_AS(Simulation(forced(force)), SceneError);
}

}  // namespace
}  // namespace nmbcrun::test
