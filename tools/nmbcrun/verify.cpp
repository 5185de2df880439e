// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <vector>

#include "tools/nmbcrun/compare/bar_series.hpp"
#include "tools/nmbcrun/compare/packet.hpp"
#include "tools/nmbcrun/compare/reference.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/step_warnings.hpp"
#include "tools/nmbcrun/output/warnings.hpp"
#include "tools/nmbcrun/prediction/prediction.hpp"
#include "tools/nmbcrun/prediction/source_spectrum.hpp"
#include "tools/nmbcrun/prediction/spectrum.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"
#include "tools/nmbcrun/terminal/progress.hpp"

namespace nmbcrun {
namespace {

struct Outcome {
    Deviation deviation;
    double energy_left = 0;            ///< over its own peak
    double reference_energy_left = 0;  ///< likewise
};

Outcome run_both(Simulation& simulation, Simulation& reference, bool quiet) {
    Outcome outcome;
    double peak = 0;
    double reference_peak = 0;
    Progress progress(simulation.plan().steps, quiet);
    while (!simulation.is_done()) {
        simulation.step();
        reference.step();
        const nmbc::Chain& chain = simulation.chain();
        progress.update(chain.steps());
        outcome.deviation.look(chain, reference.chain());
        peak = std::max(peak, simulation.energies().total());
        reference_peak = std::max(reference_peak, reference.energies().total());
        if (!chain.is_finite()) {
            throw Unstable(fmt::format("the run is not finite any more at step {} (t = {:.6g})",
                                       chain.steps(), chain.time()));
        }
        if (interrupted()) {
            throw Interrupted(
                fmt::format("stopped at step {} of {}", chain.steps(), simulation.plan().steps));
        }
    }
    if (peak > 0 && reference_peak > 0) {
        outcome.energy_left = simulation.energies().total() / peak;
        outcome.reference_energy_left = reference.energies().total() / reference_peak;
    }
    return outcome;
}

std::string cell(std::optional<double> value) {
    return value ? fmt::format("{:12.3e}", *value) : fmt::format("{:>12}", "-");
}

/// Measured and predicted, of one end.
std::string reflection_cells(const Scene& scene, const Boundary& boundary, const Packet& packet,
                             double step) {
    Scene of_packet = scene;  // the length of whose run some ends want to know
    of_packet.end = double(packet.steps(boundary.layer)) * step;
    // The packet does not get as far as the far end of an extended one.
    const bool has_end = boundary.kind != BoundaryKind::extended;
    const auto measured =
        packet.is_measurable() && has_end
            ? std::optional(packet.reflected_by(chain_end(of_packet, boundary), boundary.layer))
            : std::nullopt;
    return "  " + cell(measured) + "  " + cell(predicted_reflection(scene, boundary, packet, step));
}

/// A row for each wave number below which the source has a certain share of its energy.
void print_reflections(const Simulation& simulation, const nmbc::Chain& endless) {
    const Scene& scene = simulation.scene();
    const nmbc::ChainParameters& p = endless.parameters();
    const double step = p.time_step * p.wave_speed() / p.spacing;
    // A physical end cuts the field off, and the cut has waves of all lengths.
    const bool is_cut = is_physical(scene.left.kind) || is_physical(scene.right.kind);
    const Spectrum spectrum = is_cut ? spectrum_of_sources(scene, endless.lattice(), p.time_step)
                                     : Spectrum(endless, 1024);
    const bool alike = scene.left == scene.right;
    fmt::print(
        "\nreflected energy of a packet of waves about xi, measured and by modal analysis\n");
    fmt::print("{:>8}  {:>13}", "xi dX", "source below");
    for (const char* side : {alike ? "measured" : "left", "right"}) {
        fmt::print("  {:>12}  {:>12}", side, "predicted");
        if (alike) {
            break;
        }
    }
    fmt::print("\n");
    double last = 0;
    for (const double share : {0.5, 0.9, 0.99, 0.999, 0.9999, 0.99999}) {
        const double xi = spectrum.quantile(share);
        if (xi == last) {
            continue;
        }
        last = xi;
        const Packet packet(endless.lattice(), xi, step);
        const std::string left = reflection_cells(scene, scene.left, packet, step);
        fmt::print("{:8.3f}  {:11.3f} %{}{}\n", xi, 100 * share, left,
                   alike ? "" : reflection_cells(scene, scene.right, packet, step));
    }
    fmt::print(
        "-: too long or too slow a wave for a packet, or nothing is predicted for this end\n");
}

}  // namespace

bool verify(const Scene& scene, double tolerance, bool quiet) {
    const bool is_closed = is_physical(scene.left.kind) && is_physical(scene.right.kind);
    const Scene mirrored = is_closed ? with_mirrors(scene) : scene;
    const bool is_its_own_mirror =
        is_closed && mirrored.left == scene.left && mirrored.right == scene.right;
    const std::optional<BarSeries> series = BarSeries::of(scene);
    if (is_its_own_mirror && !series) {
        throw SceneError(
            "both ends are physical, and verify looks at what artificial ones do, or closures "
            "beside mirrors, or bars that the series (7) of SNM 2023 covers: there is none");
    }
    Simulation simulation(scene);
    Simulation reference(endless(mirrored, simulation.plan().time_step));
    const Plan& plan = simulation.plan();
    const StepsLeft all{plan.steps, simulation.chain().nodes() + reference.chain().nodes(),
                        chain_pace};
    require_bearable_length(plan, unit_of_time(scene), all);
    print_warnings(simulation.warnings());
    print_warnings(warnings_of_steps(plan, unit_of_time(scene), all));
    if (!quiet) {
        fmt::print("scene      {}\n", scene.title);
        fmt::print("ends       {}; {}\n", heading_of(scene.left), heading_of(scene.right));
        fmt::print("reference  {}; {}\n", heading_of(reference.scene().left),
                   heading_of(reference.scene().right));
        fmt::print("time       {} steps of {:.6g} (cfl = {:.3g})\n\n", plan.steps, plan.time_step,
                   plan.cfl);
        std::fflush(stdout);  // through a pipe, too, it is read before the runs
    }
    note_interrupts();
    const Outcome outcome = run_both(simulation, reference, quiet);
    const double from_series =
        series ? series->error(interior(simulation.chain()), simulation.chain().time()) : 0;
    const double error = is_its_own_mirror ? from_series : outcome.deviation.relative();
    const bool holds = error <= tolerance;
    const std::string judged =
        fmt::format("; {} the tolerance {:g}", holds ? "within" : "above", tolerance);
    if (!is_its_own_mirror) {
        fmt::print("error        {:.3e} in amplitude, of max |u|, at node {}, t = {:.4g}{}\n",
                   error, outcome.deviation.node(), outcome.deviation.time(), judged);
    }
    if (series) {
        fmt::print("series (7)   {:.3e} of the start, at t = {:.4g}: SNM 2023, the continuum{}\n",
                   from_series, simulation.chain().time(), is_its_own_mirror ? judged : "");
    }
    fmt::print("{:<12} {:.3e} of the peak; {} {:.3e}\n",
               simulation.is_driven(simulation.chain().time()) ? "energy then" : "energy left",
               outcome.energy_left, is_closed ? "between mirrors" : "without artificial ends",
               outcome.reference_energy_left);
    if (!quiet && !is_closed) {
        print_reflections(simulation, reference.chain());
    }
    return holds;
}

}  // namespace nmbcrun
