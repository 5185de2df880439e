// SPDX-License-Identifier: GPL-2.0-or-later
/// Loads on the sides of planes: which nodes they act on, beside which sides, and where their work
/// is.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/nmbcrun/plane_starts.hpp"

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
    Overrides overrides{{"load.pull.kind", load},         {"load.pull.component", "y"},
                        {"load.pull.amplitude", "7"},     {"boundary.right.kind", right},
                        {"boundary.bottom.kind", bottom}, {"boundary.top.kind", top},
                        {"boundary.left.kind", left}};
    for (const auto& [key, kind] : {std::pair{"boundary.bottom.layer", std::string(bottom)},
                                    {"boundary.top.layer", std::string(top)}}) {
        if (kind == "sponge") {
            overrides.emplace_back(key, "6");
        }
    }
    return plane_scene_of(model + of_load, overrides);
}

TEST_CASE("the work of a load on a closed side is what the ledger says") {
    for (const auto& [model, closed, beside] : {std::tuple{model_of_radius(1), "sbp", "passive"},
                                                {model_of_radius(2), "sbp", "passive"},
                                                {model_of_radius(1), "sbp", "sponge"},
                                                {model_of_radius(4), "sbp", "sponge"},
                                                {spline, "sbp", "sponge"},
                                                {spline, "kernel", "sponge"}}) {
        for (const char* const load : {"traction", "force", "velocity"}) {
            CAPTURE(model);
            CAPTURE(closed);
            CAPTURE(beside);
            CAPTURE(load);
            PlaneSimulation simulation(loaded(model, load, closed, closed, beside, closed));
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

TEST_CASE("between closed sides all that a load puts in is in the body") {
    for (const auto& [model, closed] :
         {std::pair{model_of_radius(1), "sbp"}, {model_of_radius(4), "sbp"}, {spline, "kernel"}}) {
        CAPTURE(model);
        PlaneSimulation simulation(loaded(model, "traction", closed, closed, closed, closed));
        simulation.advance(100);
        const double left = simulation.energies().staggered;
        CHECK(left > 0);
        CHECK(left == doctest::Approx(simulation.balance().work).epsilon(1e-12));
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

TEST_CASE("a traction acts on the surface that a scene describes, whatever it goes on to beside") {
    for (const char* const surface : {"sbp", "free"}) {
        for (const auto& [beside, radius_squared] : {std::pair{"extended", 4U},
                                                     {"extended", 1U},
                                                     {"sponge", 4U},
                                                     {"sponge", 1U},
                                                     {"passive", 2U},
                                                     {"passive", 1U},
                                                     {"fixed", 4U},
                                                     {"mirror", 4U},
                                                     {"sbp", 4U},
                                                     {"sbp", 2U},
                                                     {"sbp", 1U}}) {
            CAPTURE(surface);
            CAPTURE(beside);
            CAPTURE(radius_squared);
            PlaneSimulation simulation(loaded(model_of_radius(radius_squared), "traction", surface,
                                              beside, "sbp", "fixed"));
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
