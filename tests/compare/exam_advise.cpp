// SPDX-License-Identifier: GPL-2.0-or-later
/// What is advised meets the tolerance when it is measured, and nothing much cheaper does.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <nmbc/certificate.hpp>
#include <nmbc/tables/tables.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "tests/compare/advised_scenes.hpp"
#include "tools/nmbcrun/advise/wave_grid.hpp"
#include "tools/nmbcrun/chart/boundaries.hpp"
#include "tools/nmbcrun/compare/reference.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"

namespace {

using namespace advised_scenes;

struct Task {
    const char* name;
    Scene scene;
    double tolerance;
};

std::vector<Task> tasks() {
    using nmbcrun::Shape;
    return {
        {"long pulse", with_pulse(scene_of(1, 0.5, 200, 400), Shape::gaussian, 15), 1e-2},
        {"long pulse, n = 2", with_pulse(scene_of(2, 1.5, 200, 400), Shape::gaussian, 15), 1e-3},
        {"ricker", with_pulse(scene_of(2, 1.5, 300, 450), Shape::ricker, 8), 1e-2},
        {"packet", with_pulse(scene_of(1, 0.5, 200, 500), Shape::packet, 20, 0.4), 1e-2},
        {"n = 3", with_pulse(scene_of(3, 2, 300, 500), Shape::gaussian, 20), 1e-3},
        {"drive", with_drive(scene_of(2, 1.85, 500, 415), 95), 1e-2},
        {"drive, strict", with_drive(scene_of(2, 1.85, 500, 415), 95), 1e-3},
        {"standard NOPD", with_drive(scene_of(1, 0, 200, 250), 120), 2e-2},
        {"nothing arrives", with_pulse(scene_of(2, 1, 1200, 300), Shape::gaussian, 10), 1e-3}};
}

/// Of ends and time steps together, in the candidate's own steps: against a run without ends in
/// steps so short that theirs is below a thousandth of it.
double measured_error(const Scene& scene, const Candidate& candidate) {
    const auto parts = std::size_t(std::ceil(candidate.cfl / 0.0125));
    Scene stepped = nmbcrun::with_ends(scene, candidate.boundary);
    stepped.step = candidate.time_step;
    nmbcrun::Simulation simulation(stepped);
    nmbcrun::Simulation fine(nmbcrun::endless(scene, candidate.time_step / double(parts)));
    nmbcrun::Deviation deviation;
    while (!simulation.is_done()) {
        simulation.step();
        for (std::size_t part = 0; part < parts; ++part) {
            fine.step();
        }
        deviation.look(simulation.chain(), fine.chain());
    }
    return deviation.relative();
}

nmbcrun::Deviation deviation(nmbcrun::Simulation& simulation, nmbcrun::Simulation& reference) {
    nmbcrun::Deviation deviation;
    while (!simulation.is_done()) {
        simulation.step();
        reference.step();
        deviation.look(simulation.chain(), reference.chain());
    }
    return deviation;
}

TEST_CASE("what is sent back in a domain of 6000 nodes, after 3000 dX/c") {
    const Scene scene = with_pulse(scene_of(1, 0.5, 6000, 4000), nmbcrun::Shape::gaussian, 20);
    const auto found = nmbcrun::find_candidates(scene, 0.02, [] {});
    for (const auto kind : {nmbcrun::BoundaryKind::nmbc, nmbcrun::BoundaryKind::passive}) {
        CAPTURE(kind);
        std::vector<Candidate> of_kind;
        std::ranges::copy_if(found.meet, std::back_inserter(of_kind),
                             [&](const Candidate& one) { return one.boundary.kind == kind; });
        const Candidate best =
            best_boundary(of_kind, [](const Candidate& one) { return one.steps; });
        // In its own steps without ends, so that the ends alone are measured.
        Scene stepped = nmbcrun::with_ends(scene, best.boundary);
        stepped.step = best.time_step;
        nmbcrun::Simulation simulation(stepped);
        nmbcrun::Simulation reference(nmbcrun::endless(scene, best.time_step));
        // In continuous time and in steps the pulse has become a little different on its way.
        CHECK(deviation(simulation, reference).relative() ==
              doctest::Approx(best.boundary_error).scale(0).epsilon(0.1));
    }
}

TEST_CASE("predictions do not grow with the run, and are what runs of every length measure") {
    // The force sends out a wave five times as long as its chain, so that several trips are under
    // way at a time; of the other two each trip is by itself.
    Scene forced = scene_of(2, 1, 30, 0);
    forced.force = nmbcrun::Force{
        {.history = nmbcrun::History::ricker, .time = 120, .duration = 30, .file = {}}, 15, 2};
    for (const auto& [what, scene, lengths] :
         {std::tuple<const char*, Scene, std::array<double, 3>>{
              "pulse",
              with_pulse(scene_of(2, 1, 100, 0), nmbcrun::Shape::gaussian, 5),
              {200.0, 2000.0, 180000.0}},
          {"packet",
           with_pulse(scene_of(1, 0.5, 100, 0), nmbcrun::Shape::packet, 10, 1.2),
           {250.0, 2000.0, 180000.0}},
          {"force", forced, {400.0, 2000.0, 180000.0}}}) {
        const char* const source = what;
        CAPTURE(source);
        std::map<std::string, double> before;
        for (const double length : lengths) {
            CAPTURE(length);
            Scene run = scene;
            run.end = length;
            run.step = 0.5;
            int compared = 0;
            for (const Candidate& one : nmbcrun::find_candidates(run, 1, [] {}).meet) {
                CAPTURE(one.name);
                if (one.boundary.kind != nmbcrun::BoundaryKind::nmbc &&
                    one.boundary.kind != nmbcrun::BoundaryKind::passive) {
                    continue;
                }
                ++compared;
                const auto [known, is_new] = before.try_emplace(one.name, one.boundary_error);
                CHECK(one.boundary_error <= 1.1 * known->second);
                if (length > 2000) {  // a reference without ends would be as wide
                    continue;
                }
                nmbcrun::Simulation simulation(nmbcrun::with_ends(run, one.boundary));
                nmbcrun::Simulation reference(nmbcrun::endless(run, *run.step));
                const double error = deviation(simulation, reference).relative();
                CHECK(error <= 1.1 * one.boundary_error);
                CHECK(error >= 0.5 * one.boundary_error);  // both ends' crests met
            }
            CHECK(compared >= 3);
        }
    }
}

TEST_CASE("the grid of waves repeats beyond all nodes, and gives back what it was given") {
    nmbcrun::WaveGrid grid(6001);
    CHECK(2 * grid.bands() == 6144);  // 2^11 3
    std::vector<double> field(6001);
    for (std::size_t node = 0; node < field.size(); ++node) {
        field[node] = std::sin(0.01 * double(node * node));
    }
    const std::vector<double> back = grid.field(grid.amplitudes(field));
    double difference = 0;
    for (std::size_t node = 0; node < back.size(); ++node) {
        const double given = node < field.size() ? field[node] : 0;
        difference = std::max(difference, std::abs(back[node] - given));
    }
    CHECK(difference < 1e-13);  // roundings of two transforms, eps log2(6144) = 3e-15 each
}

TEST_CASE("the advised set-up meets the tolerance, and none certified in 2/3 of its steps does") {
    for (const Task& task : tasks()) {
        CAPTURE(task.name);
        const auto found = nmbcrun::find_candidates(task.scene, task.tolerance, [] {});
        const Candidate best =
            best_boundary(found.meet, [](const Candidate& one) { return one.steps; });
        CAPTURE(best.name);
        CAPTURE(best.cfl);
        const double error = measured_error(task.scene, best);
        CHECK(error <= task.tolerance);
        // What is predicted is what is measured, within a factor: the two ends' errors are added up
        // as if their crests met.
        CHECK(error >= 0.4 * best.error());
        CHECK(error <= 1.1 * best.error());
        CHECK((std::string(task.name) == "nothing arrives") ==
              (best.boundary.kind == nmbcrun::BoundaryKind::fixed));
        for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
            Candidate cheaper = best;
            cheaper.cfl *= 1.5;
            cheaper.time_step *= 1.5;
            cheaper.boundary = {.order = table->order, .stride = table->stride};
            if (table->lattice->family != "nopd1d" ||
                table->lattice->horizon != task.scene.horizon || table->lattice->tau != "0" ||
                table->time_step != "0" ||
                nmbc::certified_cfl(*table, task.scene.G) < cheaper.cfl) {
                continue;
            }
            CAPTURE(table->name);
            CHECK(measured_error(task.scene, cheaper) > task.tolerance);
        }
    }
}

}  // namespace
