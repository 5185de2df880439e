// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace nmbcrun {

void print_heading(const Simulation& simulation) {
    const Scene& scene = simulation.scene();
    const Plan& plan = simulation.plan();
    fmt::print("scene     {}\n", scene.title);
    fmt::print(
        "lattice   {} horizon {}, G = {}{}{}\n", scene.family, scene.horizon, scene.G,
        is_damped(scene) ? ", tau = " + scene.tau : "",
        scene.weights.empty() ? "" : fmt::format(", influence {}", fmt::join(scene.weights, ", ")));
    if (scene.left == scene.right) {
        fmt::print("boundary  {}\n", heading_of(scene.left));
    } else {
        fmt::print("left      {}\n", heading_of(scene.left));
        fmt::print("right     {}\n", heading_of(scene.right));
    }
    fmt::print("chain     {} nodes, dX = {}, c = {:.6g}\n", scene.nodes, scene.spacing,
               simulation.chain().parameters().wave_speed());
    fmt::print("time      {} steps of {:.6g} (cfl = {:.3g}){}\n\n", plan.steps, plan.time_step,
               plan.cfl, plan.limit.empty() ? "" : ": " + plan.limit);
}

void print_samples(const Highlights& highlights, bool damped) {
    fmt::print("{:>10}  {:>12}  {:>12}  {:>14}  {:>12}  {:>10}{}\n", "time", "kinetic", "strain",
               "stabilisation", "total", "of peak", damped ? "        damped" : "");
    for (const auto& [time, e, balance] : highlights.samples) {
        fmt::print("{:10.4g}  {:12.4e}  {:12.4e}  {:14.4e}  {:12.4e}  {:10.2e}{}\n", time,
                   e.kinetic, e.strain, e.stabilisation, e.total(), e.total() / highlights.peak,
                   damped ? fmt::format("  {:12.4e}", e.damped) : "");
    }
    fmt::print("\n");
}

void print_balance(const Highlights& highlights, bool damped) {
    const auto& [time, e, balance] = highlights.samples.back();
    const double peak = highlights.peak;
    fmt::print("energy left  {:.3e} of the peak\n", e.total() / peak);
    fmt::print("went out     {:.3e} at the left end, {:.3e} at the right one{}\n",
               balance.left / peak, balance.right / peak,
               damped ? fmt::format(", {:.3e} by damping", e.damped / peak) : "");
    fmt::print("ledger drift {:.1e} of the peak\n", highlights.drift / peak);
}

}  // namespace nmbcrun
