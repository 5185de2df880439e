// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/recommend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "generator/commands/candidates.hpp"
#include "generator/commands/scene_settings.hpp"
#include "generator/enclosures/prove.hpp"
#include "generator/exact/rational.hpp"
#include "generator/names/names.hpp"
#include "generator/names/projected_family.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/certify.hpp"

namespace nmbcgen {
namespace {

std::string row(const Candidate& candidate) {
    const Specification& what = candidate.what;
    std::string text = fmt::format("{:>5} {:>6}", what.order, what.stride);
    if (candidate.certified.largest > 0) {
        // In steps that are not certified nothing was examined.
        const std::string reflected = candidate.certified.contains(candidate.cfl)
                                          ? fmt::format("{:.1e}", candidate.reflected)
                                          : "-";
        text +=
            fmt::format(" {:>6} {:>9} {:>9.2f} {:>5.2f} {:>10} {:>8.1e}", to_string(what.damping),
                        what.time_step == 0 ? "-" : to_string(what.time_step),
                        candidate.certified.largest, candidate.cfl, reflected, candidate.loss);
    } else {
        text += fmt::format(" {:>6} {:>9} {:>9} {:>5} {:>10} {:>8}", "-", "-", "-", "-", "-", "-");
    }
    return text + (candidate.lost.empty() ? "" : "  " + candidate.lost) + "\n";
}

std::string table_of(const std::vector<Candidate>& all, const Question& question,
                     double tolerance) {
    std::string text = fmt::format(
        "matched: in these leapfrog steps [dX/c]\ncertified: the largest cfl\ncfl: of {}\n"
        "reflected: energy in these steps, mean over xi = {:g} .. "
        "{:g}/dX\nloss: energy of a wave of {:g} dX over one wavelength, by damping\n\n"
        "order stride    tau   matched certified   cfl  reflected     loss\n",
        question.cfl ? "your steps"
                     : fmt::format("the largest steps that reflect no more than {:g}, or of those "
                                   "that reflect least",
                                   tolerance),
        question.band.low, question.band.high, faded_wavelength);
    for (const Candidate& candidate : all) {
        text += row(candidate);
    }
    return text;
}

/// How a scene of nmbcrun takes the best one; where its table has to be made, the first that needs
/// none, if one is within the tolerance.
std::string in_a_scene(const std::vector<Candidate>& all, double tolerance) {
    const Candidate& best = all.front();
    std::string text = fmt::format("  settings   {}\n", scene_settings(best));
    if (is_committed(best.what)) {
        return text;
    }
    text += fmt::format("  table      to be made beside the scene: {} --format json --out FOLDER\n",
                        regenerating_command(best.what));
    const auto ready = std::ranges::find_if(all, [tolerance](const Candidate& other) {
        return other.time_step > 0 && other.reflected <= tolerance && is_committed(other.what);
    });
    if (ready != all.end()) {
        text += fmt::format("  ready      NMBC{}, stride {}, {}reflects {:.1e}: {}\n",
                            ready->what.order, ready->what.stride,
                            ready->what.time_step != 0
                                ? "matched in its steps, "
                                : fmt::format("in steps of cfl {:.2f}, ", ready->cfl),
                            ready->reflected, scene_settings(*ready));
    }
    return text;
}

}  // namespace

std::string recommendation(const Question& question, const Progress& progress) {
    const std::vector<Certified> certified = all_certified(question, progress);
    // Where no tolerance is given, damping comes in when nothing undamped keeps 1e-3.
    constexpr double least = 1e-6;
    constexpr double undamped_most = 1e-3;
    constexpr double most = 0.1;
    double tolerance = question.tolerance.value_or(least);
    std::vector<Candidate> all = in_order(certified, question, tolerance);
    const auto answers = [&] {
        const Candidate& best = all.front();
        return best.lost.empty() && (best.what.damping == 0 || tolerance > undamped_most);
    };
    while (!question.tolerance && !answers() && tolerance < most) {
        tolerance *= 10;
        all = in_order(certified, question, tolerance);
    }
    const Candidate& best = all.front();
    if (!best.lost.empty()) {
        throw NoSuchBoundary(fmt::format(
            "no certified boundary for horizon {} at G = {} reflects {:g} of the energy or "
            "less.\n{}",
            question.horizon, to_string(question.G), tolerance,
            table_of(all, question, tolerance)));
    }
    const Table table = derive(best.what);
    Certificate certificate = certify(table);
    prove_certificate(table, certificate);
    const bool matched = best.what.time_step != 0;
    return fmt::format(
        "NMBC{}, stride {}, tau = {}, {}steps of cfl {:.2f}, at horizon {}, G = {}\n"
        "  command    {}\n{}"
        "  certified  stable with both ends alike, in chains of {} interior nodes and more, in {}; "
        "{}{}\n"
        "  opposite   its like; with a fixed or free end opposite, nmbcrun advise SCENE chooses\n"
        "  reflected  {:.1e} of the energy in steps of cfl {:.2f}, dt = {:.4g} dX/c\n"
        "  loss       {:.1e} of the energy\n\n{}",
        best.what.order, best.what.stride, to_string(best.what.damping),
        matched ? "matched in " : "", best.cfl, best.what.horizon, to_string(question.G),
        regenerating_command(best.what), in_a_scene(all, tolerance), certificate.least_nodes,
        matched ? "these steps, of which it takes no others" : in_words(best.certified),
        certificate.paired == Evidence::proved
            ? "proved of two such ends far apart, sampled of the length"
            : "sampled",
        projected_family(question.family)
            ? "\n             for waves at normal incidence; in the plane oblique waves may grow"
            : "",
        best.reflected, best.cfl, best.time_step, best.loss, table_of(all, question, tolerance));
}

}  // namespace nmbcgen
