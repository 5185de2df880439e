// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/recommend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "generator/emit/emit.hpp"
#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/band_reflection.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"

namespace nmbcgen {
namespace {

constexpr unsigned highest_order = 4;
constexpr double wavelength = 20;      // [dX], of the loss that is stated
constexpr double smallest_cfl = 0.25;  // below, more damping is the better bargain

const std::vector<Rational>& damping_ladder() {
    static const std::vector<Rational> ladder{0,
                                              Rational(1, 100),
                                              Rational(1, 50),
                                              Rational(1, 20),
                                              Rational(1, 10),
                                              Rational(1, 5),
                                              Rational(3, 10),
                                              Rational(1, 2)};
    return ladder;
}

/// A condition with the least damping of the ladder that certifies it at the G of the question.
struct Certified {
    Specification what;
    double cfl = 0;                       ///< the largest one; 0: not certified with any damping
    std::optional<HalfSpace> half_space;  ///< where it is certified
};

/// Certified with a time step worth having.
Certified least_damped(Specification what, const Rational& G) {
    for (const Rational& damping : damping_ladder()) {
        what.damping = damping;
        try {
            HalfSpace half_space = make_half_space(derive(what), G);
            const double cfl = stability_grade(half_space) == Grade::none
                                   ? 0
                                   : largest_cfl(half_space, GhostLevel::midpoint);
            if (cfl >= smallest_cfl) {
                return {what, cfl, std::move(half_space)};
            }
        } catch (const NoSuchBoundary&) {
            continue;  // with this damping
        }
    }
    return {what, 0, std::nullopt};
}

std::vector<Certified> examined(const Question& question, const Progress& progress) {
    std::vector<Specification> all;
    const unsigned least = question.order.value_or(1);
    const unsigned most = question.order.value_or(highest_order);
    for (unsigned order = least; order <= most; ++order) {
        for (unsigned stride = 1; stride <= question.horizon + 2; ++stride) {
            all.push_back({question.family, question.horizon, order, stride, question.G});
        }
    }
    std::vector<Certified> found;
    for (const Specification& what : all) {
        progress(found.size(), all.size());
        found.push_back(least_damped(what, question.G));
    }
    progress(found.size(), all.size());
    return found;
}

/// One in the largest certified steps in which it meets the tolerance, or reflects least.
struct Candidate {
    Specification what;
    double certified_cfl = 0;
    double cfl = 0;        ///< of the steps
    double reflected = 0;  ///< mean reflected energy over the band, in these steps
    double loss = 0;       ///< of the energy of a wave of 20 dX over one wavelength, by damping
    std::string lost;      ///< why another one is recommended; empty: this one is
};

/// The steps are the largest certified ones, or shorter ones by multiples of 0.05 of cfl. Order 1
/// is best in large steps, whose errors in time undo its errors in space; the others are best in
/// short ones.
Candidate in_steps(const Certified& certified, const Band& band, double tolerance) {
    Candidate candidate;
    candidate.what = certified.what;
    candidate.certified_cfl = certified.cfl;
    if (!certified.half_space) {
        candidate.lost = fmt::format("not certified with cfl {} or more and any tau up to {}",
                                     smallest_cfl, to_string(damping_ladder().back()));
        return candidate;
    }
    const HalfSpace& half_space = *certified.half_space;
    const double top = maximum_frequency(half_space);
    const auto reflected_at = [&](double cfl) {
        return mean_reflected_energy(stepped(half_space, 2 * cfl / top), band.low, band.high);
    };
    candidate.loss = loss_per_wavelength(half_space, wavelength);
    candidate.cfl = certified.cfl;
    candidate.reflected = reflected_at(candidate.cfl);
    constexpr double coarse = 0.05;
    for (int step = int(std::ceil(candidate.cfl / coarse)) - 1;
         step > 0 && candidate.reflected > tolerance; --step) {
        const double reflected = reflected_at(coarse * step);
        if (reflected < candidate.reflected) {
            candidate.cfl = coarse * step;
            candidate.reflected = reflected;
        }
    }
    if (candidate.reflected > tolerance) {
        candidate.lost = "above the tolerance";
    }
    return candidate;
}

auto rank(const Candidate& candidate) {
    return std::tuple(candidate.what.damping, -candidate.cfl, candidate.reflected);
}

std::string why_not(const Candidate& loser, const Candidate& winner) {
    if (loser.what.damping != winner.what.damping) {
        return "more damping";
    }
    return loser.cfl < winner.cfl ? "smaller time step" : "more reflection";
}

/// All of them, the recommended one first.
std::vector<Candidate> ranked(const std::vector<Certified>& certified, const Band& band,
                              double tolerance) {
    std::vector<Candidate> all;
    all.reserve(certified.size());
    for (const Certified& one : certified) {
        all.push_back(in_steps(one, band, tolerance));
    }
    std::ranges::stable_sort(all, {}, [](const Candidate& candidate) {
        return std::tuple(!candidate.lost.empty(), candidate.cfl == 0, rank(candidate));
    });
    for (Candidate& candidate : all) {
        if (candidate.lost.empty() && &candidate != &all.front()) {
            candidate.lost = why_not(candidate, all.front());
        }
    }
    return all;
}

std::string row(const Candidate& candidate) {
    std::string text = fmt::format("{:>5} {:>6}", candidate.what.order, candidate.what.stride);
    text += candidate.certified_cfl > 0
                ? fmt::format(" {:>6} {:>9.2f} {:>5.2f} {:>10.1e} {:>8.1e}",
                              to_string(candidate.what.damping), candidate.certified_cfl,
                              candidate.cfl, candidate.reflected, candidate.loss)
                : fmt::format(" {:>6} {:>9} {:>5} {:>10} {:>8}", "-", "-", "-", "-", "-");
    return text + (candidate.lost.empty() ? "" : "  " + candidate.lost) + "\n";
}

std::string table_of(const std::vector<Candidate>& all, const Band& band, double tolerance) {
    std::string text = fmt::format(
        "certified: the largest cfl\ncfl: of the largest steps that reflect no more than {:g}, or "
        "of those that reflect least\nreflected: energy in these steps, mean over xi = {:g} .. "
        "{:g}/dX\nloss: energy of a wave of {:g} dX over one wavelength, by damping\n\n"
        "order stride    tau certified   cfl  reflected     loss\n",
        tolerance, band.low, band.high, wavelength);
    for (const Candidate& candidate : all) {
        text += row(candidate);
    }
    return text;
}

}  // namespace

std::string recommendation(const Question& question, const Progress& progress) {
    const std::vector<Certified> certified = examined(question, progress);
    // Where no tolerance is given, damping comes in when nothing undamped keeps 1e-4.
    constexpr double least = 1e-6;
    constexpr double undamped_most = 1e-4;
    constexpr double most = 0.1;
    double tolerance = question.tolerance.value_or(least);
    std::vector<Candidate> all = ranked(certified, question.band, tolerance);
    const auto answers = [&] {
        const Candidate& best = all.front();
        return best.lost.empty() && (best.what.damping == 0 || tolerance > undamped_most);
    };
    while (!question.tolerance && !answers() && tolerance < most) {
        tolerance *= 10;
        all = ranked(certified, question.band, tolerance);
    }
    const Candidate& best = all.front();
    if (!best.lost.empty()) {
        throw NoSuchBoundary(fmt::format(
            "no certified boundary for horizon {} at G = {} reflects {:g} of the energy or "
            "less.\n{}",
            question.horizon, to_string(question.G), tolerance,
            table_of(all, question.band, tolerance)));
    }
    Specification open = best.what;
    open.stabilisation.reset();
    const bool damped = best.what.damping != 0;
    return fmt::format(
        "NMBC{}, stride {}, tau = {}, steps of cfl {:.2f}, at horizon {}, G = {}\n"
        "  table      {}.hpp, by nmbcgen --order {} --horizon {} --stride {}{}\n"
        "  certified  stable with both ends alike, {}, in steps of cfl {:.2f} or less\n"
        "  reflected  {:.1e} of the energy in these steps\n"
        "  loss       {:.1e} of the energy\n\n{}",
        best.what.order, best.what.stride, to_string(best.what.damping), best.cfl,
        best.what.horizon, to_string(question.G), table_name(open), best.what.order,
        best.what.horizon, best.what.stride,
        damped ? " --damping " + to_string(best.what.damping) : std::string(),
        damped ? fmt::format("in chains of {} interior nodes and more", least_damped_nodes)
               : std::string("in chains of any length (docs/stability.md: short ones)"),
        best.certified_cfl, best.reflected, best.loss, table_of(all, question.band, tolerance));
}

}  // namespace nmbcgen
