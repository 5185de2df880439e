// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tools/nmbcrun/certification/evidence.hpp"
#include "tools/nmbcrun/output/share_gone.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {

std::string heading_of(const Simulation& simulation) {
    const Scene& scene = simulation.scene();
    std::string text = fmt::format("scene     {}\n", scene.title);
    text += fmt::format(
        "lattice   {} horizon {}, G = {}{}{}\n", scene.family, scene.horizon, scene.G,
        is_damped(scene) ? ", tau = " + scene.tau : "",
        scene.weights.empty() ? "" : fmt::format(", influence {}", fmt::join(scene.weights, ", ")));
    text += scene.left == scene.right
                ? fmt::format("boundary  {}\n", heading_of(scene.left))
                : fmt::format("left      {}\nright     {}\n", heading_of(scene.left),
                              heading_of(scene.right));
    if (simulation.plan().objection.empty()) {
        text += fmt::format("stable    {}\n",
                            evidence_of(scene, simulation.chain().lattice(),
                                        table_of(scene, scene.left), table_of(scene, scene.right),
                                        simulation.plan().time_step / unit_of_time(scene)));
    }
    return text + fmt::format("chain     {} nodes, dX = {}, c = {:.6g}\n", scene.nodes,
                              scene.spacing, simulation.chain().parameters().wave_speed());
}

void print_samples(std::span<const Sample> samples, double peak, bool damped) {
    fmt::print("{:>10}  {:>12}  {:>12}  {:>14}  {:>12}  {:>10}{}\n", "time", "kinetic", "strain",
               "stabilisation", "total", "of peak", damped ? "        damped" : "");
    for (const auto& [time, e, balance] : samples) {
        fmt::print("{:10.4g}  {:12.4e}  {:12.4e}  {:14.4e}  {:12.4e}  {:10.2e}{}\n", time,
                   e.kinetic, e.strain, e.stabilisation, e.total(), e.total() / peak,
                   damped ? fmt::format("  {:12.4e}", e.damped) : "");
    }
    fmt::print("\n");
}

void print_balance(const Sample& last, const Highlights& highlights, bool damped) {
    const auto& [time, e, balance] = last;
    const double peak = highlights.peak;
    fmt::print("energy left  {:.3e} of the peak\n", e.total() / peak);
    // What is there was put in, by the sources or through an end, and so was what has gone.
    const double put_in =
        balance.energy + std::max(0.0, balance.left) + std::max(0.0, balance.right) + e.damped;
    const auto [whole, name_of_whole] = whole_of(put_in, peak);
    fmt::print("went out     {} at the left end, {} at the right one{}, of {}\n",
               share_gone(balance.left / whole), share_gone(balance.right / whole),
               damped ? fmt::format(", {:.3e} by damping", e.damped / whole) : "", name_of_whole);
    fmt::print("ledger drift {:.1e} of the peak\n", highlights.drift / peak);
}

}  // namespace nmbcrun
