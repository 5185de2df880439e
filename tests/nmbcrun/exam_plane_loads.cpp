// SPDX-License-Identifier: GPL-2.0-or-later
/// Loads on the sides of planes: which nodes they act on, beside which sides, and where their work
/// is.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/nmbcrun/plane_starts.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/plane/plane_body.hpp"

namespace nmbcrun::test {
namespace {

const std::string of_load =
    of_lattice + "[boundary]\nkind = 'extended'\n[load.pull]\nside = 'right'\n";

std::string model_of_radius(unsigned radius_squared, const char* more = "") {
    return fmt::format("model = {{ family = 'nopd2d', radius2 = {}, nu = 0.25, G = 1{} }}\n",
                       radius_squared, more);
}
const std::string spline = model_of_radius(8, ", influence = 'spline'");

/// Loaded on the right, with these sides there, below, above and on the left.
PlaneScene loaded(const std::string& model, const char* load, const char* right, const char* bottom,
                  const char* top, const char* left) {
    Overrides overrides{{"load.pull.kind", load},
                        {"load.pull.component", "y"},
                        {"load.pull.amplitude", "7"},
                        {"load.pull.rise", std::string(load) == "displacement" ? "5" : "0"},
                        {"boundary.right.kind", right},
                        {"boundary.bottom.kind", bottom},
                        {"boundary.top.kind", top},
                        {"boundary.left.kind", left}};
    for (const auto& [key, kind] : {std::pair{"boundary.bottom.layer", std::string(bottom)},
                                    {"boundary.top.layer", std::string(top)}}) {
        if (kind == "sponge") {
            overrides.emplace_back(key, "6");
        }
    }
    return plane_scene_of(model + of_load, overrides);
}

/// A side of a lattice that is loaded, and what is beside it.
struct Loaded {
    std::string model;
    const char* kind;
    const char* beside;
};

TEST_CASE("the work of a load on a closed side is what the ledger says" *
          doctest::test_suite("long")) {
    for (const Loaded& one :
         {Loaded{model_of_radius(1), "sbp", "passive"},
          Loaded{model_of_radius(2), "sbp", "passive"}, Loaded{model_of_radius(1), "sbp", "sponge"},
          Loaded{model_of_radius(4), "sbp", "sponge"}, Loaded{spline, "sbp", "sponge"},
          Loaded{spline, "kernel", "sponge"}}) {
        for (const char* const load : {"traction", "force", "velocity", "displacement"}) {
            CAPTURE(one.model);
            CAPTURE(one.kind);
            CAPTURE(one.beside);
            CAPTURE(load);
            PlaneSimulation simulation(
                loaded(one.model, load, one.kind, one.kind, one.beside, one.kind));
            double peak = 0;
            double drift = 0;
            for (int look = 0; look < 20; ++look) {
                simulation.advance(5);
                const PlaneBalance balance = simulation.balance();
                peak = std::max(peak, balance.energy);
                drift = std::max(drift, std::abs(balance.drift));
            }
            CHECK(peak > 0);
            CHECK(simulation.balance().left[3] > 1e-3 * peak);
            CHECK(drift < 1e-11 * peak);
        }
    }
}

TEST_CASE("a side follows the displacement that it is given, until it is let go") {
    PlaneScene scene = loaded(model_of_radius(4), "displacement", "sbp", "sbp", "sponge", "free");
    scene.loads.front().until = 10;
    PlaneSimulation simulation(scene);
    const std::array<std::size_t, 2> nodes = simulation.body().nodes;
    double off = 0;  // largest departure from what is given
    const auto look = [&] {
        const double time = simulation.plane().time();
        for (std::size_t y = 0; y < nodes[1]; ++y) {
            const std::size_t entry = simulation.entry_of_body(nodes[0] - 1, y);
            off = std::max(off, std::abs(simulation.plane().displacement(1)[entry] -
                                         7 * std::min(1.0, time / 5)));
        }
    };
    while (simulation.plane().time() + simulation.plan().time_step <= 10) {
        simulation.advance(1);
        look();
    }
    CHECK(simulation.plane().time() > 9);
    CHECK(off < 1e-13);
    CHECK(simulation.is_driven(9.9));
    CHECK(!simulation.is_driven(10.1));
    simulation.advance(20);
    look();
    CHECK(off > 0.1);
}

TEST_CASE("a displacement that sets in at once is refused, one of 0 holds") {
    const auto refusal = [](const Overrides& more) {
        Overrides overrides{{"load.pull.kind", "displacement"}, {"load.pull.component", "x"}};
        overrides.insert(overrides.end(), more.begin(), more.end());
        try {
            plane_scene_of(model_of_radius(1) + of_load, overrides);
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refusal({{"load.pull.amplitude", "1"}}).find("load.pull.rise above 0, or a file") !=
          std::string::npos);
    CHECK(refusal({{"load.pull.amplitude", "1"}, {"load.pull.rise", "1"}}) == "");
    CHECK(refusal({{"load.pull.amplitude", "1"}, {"load.pull.file", "any.csv"}}) == "");
    CHECK(refusal({{"load.pull.amplitude", "0"}}) == "");
}

TEST_CASE("between closed sides all that a load puts in is in the body") {
    for (const Loaded& one :
         {Loaded{model_of_radius(1), "sbp", "sbp"}, Loaded{model_of_radius(4), "sbp", "sbp"},
          Loaded{spline, "kernel", "kernel"}}) {
        CAPTURE(one.model);
        CAPTURE(one.kind);
        PlaneSimulation simulation(
            loaded(one.model, "traction", one.kind, one.beside, one.beside, one.kind));
        simulation.advance(100);
        const double left = simulation.energies().staggered;
        CHECK(left > 0);
        CHECK(left == doctest::Approx(simulation.balance().work).epsilon(1e-12));
    }
}

TEST_CASE("under tractions that balance it an even stress rests from the first step on") {
    constexpr double stress = 7;
    constexpr double strain = stress / 12;  // E of the lattice
    for (const unsigned radius_squared : {1U, 4U}) {
        CAPTURE(radius_squared);
        const std::string text =
            model_of_radius(radius_squared) + of_lattice +
            "[boundary]\nkind = 'sbp'\n"
            "[load.left]\nside = 'left'\nkind = 'traction'\ncomponent = 'x'\n"
            "amplitude = -7\n"
            "[load.right]\nside = 'right'\nkind = 'traction'\ncomponent = 'x'\n"
            "amplitude = 7\n";
        const PlaneScene at_rest = plane_scene_of(text);
        const PlaneBody body = body_of(at_rest, PlaneSimulation(at_rest, true).plane().layers());
        const auto file = file_named("exam_even_stress.csv");
        std::ofstream csv(file);
        csv << "x,y,ux,uy\n";
        for (std::size_t j = 0; j < body.nodes[1]; ++j) {
            for (std::size_t i = 0; i < body.nodes[0]; ++i) {
                const double x = at_rest.spacing * (1 + double(i) - double(body.before[0]));
                const double y = at_rest.spacing * (1 + double(j) - double(body.before[1]));
                csv << fmt::format("{},{},{},{}\n", x, y, strain * x, -0.25 * strain * y);
            }
        }
        csv.close();
        PlaneSimulation simulation(started_from(text, file), true);
        const std::vector<double> start(simulation.plane().displacement(0).begin(),
                                        simulation.plane().displacement(0).end());
        simulation.advance(100);
        for (std::size_t entry = 0; entry < start.size(); ++entry) {
            CHECK(std::abs(simulation.plane().displacement(0)[entry] - start[entry]) < 1e-12);
        }
        std::filesystem::remove(file);
    }
}

/// Given to the whole plane along y [per thickness].
double momentum(const PlaneSimulation& simulation) {
    const nmbc::Plane& plane = simulation.plane();
    double sum = 0;
    for (std::size_t entry = 0; entry < plane.velocity(1).size(); ++entry) {
        sum += plane.velocity(1)[entry] == 0 ? 0 : plane.mass(1, entry) * plane.velocity(1)[entry];
    }
    return sum;
}

TEST_CASE("a traction acts on the surface that a scene describes, whatever it goes on to beside" *
          doctest::test_suite("long")) {
    for (const char* const surface : {"sbp", "free"}) {
        for (const Loaded& one : {Loaded{model_of_radius(4), surface, "extended"},
                                  Loaded{model_of_radius(1), surface, "extended"},
                                  Loaded{model_of_radius(4), surface, "sponge"},
                                  Loaded{model_of_radius(1), surface, "sponge"},
                                  Loaded{model_of_radius(2), surface, "passive"},
                                  Loaded{model_of_radius(1), surface, "passive"},
                                  Loaded{model_of_radius(4), surface, "fixed"},
                                  Loaded{model_of_radius(4), surface, "mirror"},
                                  Loaded{model_of_radius(4), surface, "sbp"},
                                  Loaded{model_of_radius(2), surface, "sbp"},
                                  Loaded{model_of_radius(1), surface, "sbp"}}) {
            CAPTURE(one.model);
            CAPTURE(one.kind);
            CAPTURE(one.beside);
            PlaneSimulation simulation(
                loaded(one.model, "traction", one.kind, one.beside, "sbp", "fixed"));
            const bool is_low_closed = simulation.body().before[1] > 0;
            // A surface lies on its outermost nodes, others' bodies go on midway to the next.
            const double length =
                (double(simulation.body().nodes[1]) - (is_low_closed ? 1 : 0.5)) * 0.5;
            simulation.advance(1);
            CHECK(momentum(simulation) ==
                  doctest::Approx(7 * length * simulation.plan().time_step).epsilon(1e-12));
        }
    }
}

}  // namespace
}  // namespace nmbcrun::test
