// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/recommend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
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
#include "generator/time_step.hpp"

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

/// Whatever its cfl is; 0 where there is no such condition.
Certified certified(const Specification& what) {
    try {
        HalfSpace half_space = make_half_space(derive(what), what.stabilisation.value());
        const double cfl = stability_grade(half_space) == Grade::none
                               ? 0
                               : largest_cfl(half_space, GhostLevel::midpoint);
        return {what, cfl, std::move(half_space)};
    } catch (const NoSuchBoundary&) {
        return {what, 0, std::nullopt};
    }
}

/// Certified with a time step worth having.
Certified least_damped(Specification what) {
    for (const Rational& damping : damping_ladder()) {
        what.damping = damping;
        Certified found = certified(what);
        if (found.cfl >= smallest_cfl) {
            return found;
        }
    }
    return {what, 0, std::nullopt};
}

/// The same condition matched in time steps in which it is then certified: those of the question,
/// or else some about the largest that `plain` is certified for.
std::vector<Certified> matched_in_steps(const Certified& plain, const std::optional<double>& cfl) {
    std::vector<Certified> found;
    if (plain.what.order == 1 || !plain.half_space) {
        return found;
    }
    const double top = maximum_frequency(*plain.half_space);
    std::vector<double> steps;
    for (const double share : {1.8, 1.5, 1.25, 1.1, 1.0, 0.85, 0.7, 0.5}) {
        steps.push_back(share * plain.cfl);
    }
    if (cfl) {
        steps = {*cfl};
    }
    for (const double step : steps) {
        Specification what = plain.what;
        what.time_step = time_step_below(2 * std::min(step, 0.99) / top);
        Certified one = what.time_step > 0 ? certified(what) : Certified{};
        if (one.half_space && nearest_double(what.time_step) * top / 2 <= one.cfl) {
            found.push_back(std::move(one));
        }
    }
    return found;
}

std::vector<Certified> all_certified(const Question& question, const Progress& progress) {
    std::vector<Specification> all;
    const unsigned least = question.order.value_or(1);
    const unsigned most = question.order.value_or(highest_order);
    for (unsigned order = least; order <= most; ++order) {
        for (unsigned stride = 1; stride <= question.horizon + 2; ++stride) {
            all.push_back({question.family, question.horizon, order, stride, question.G});
        }
    }
    std::vector<Certified> found;
    std::size_t examined = 0;
    for (const Specification& what : all) {
        progress(examined++, all.size());
        found.push_back(least_damped(what));
        std::ranges::move(matched_in_steps(found.back(), question.cfl), std::back_inserter(found));
    }
    progress(all.size(), all.size());
    return found;
}

/// One in the largest certified steps in which it meets the tolerance, or reflects least.
struct Candidate {
    Specification what;
    double certified_cfl = 0;
    double cfl = 0;        ///< of the steps
    double reflected = 0;  ///< mean reflected energy over the band, in these steps
    double time_step = 0;  ///< [dX/c]
    double loss = 0;       ///< of the energy of a wave of 20 dX over one wavelength, by damping
    std::string lost;      ///< why another one is recommended; empty: this one is
};

/// The steps are the question's, or those it is matched in, or else the largest certified ones, or
/// shorter ones by multiples of 0.05 of cfl. Order 1 is best in large steps, whose errors in time
/// undo its errors in space; the others, where they are not matched in steps, in short ones.
Candidate in_steps(const Certified& certified, const Question& question, double tolerance) {
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
        return mean_reflected_energy(stepped(half_space, 2 * cfl / top), question.band.low,
                                     question.band.high);
    };
    candidate.loss = loss_per_wavelength(half_space, wavelength);
    const Rational& time_step = certified.what.time_step;
    const bool free = time_step == 0 && !question.cfl;
    candidate.cfl =
        time_step == 0 ? question.cfl.value_or(certified.cfl) : nearest_double(time_step) * top / 2;
    if (candidate.cfl > certified.cfl) {
        candidate.lost = "not certified in such steps";
        return candidate;
    }
    candidate.reflected = reflected_at(candidate.cfl);
    constexpr double coarse = 0.05;
    for (int step = int(std::ceil(candidate.cfl / coarse)) - 1;
         free && step > 0 && candidate.reflected > tolerance; --step) {
        const double reflected = reflected_at(coarse * step);
        if (reflected < candidate.reflected) {
            candidate.cfl = coarse * step;
            candidate.reflected = reflected;
        }
    }
    candidate.time_step = 2 * candidate.cfl / top;
    if (candidate.reflected > tolerance) {
        candidate.lost = "above the tolerance";
    }
    return candidate;
}

/// As it is printed, so that steps of the same cfl but for the rounding of dt are the same.
double shown_cfl(const Candidate& candidate) {
    return std::round(100 * candidate.cfl) / 100;
}

auto rank(const Candidate& candidate) {
    return std::tuple(candidate.what.damping, -shown_cfl(candidate), candidate.reflected);
}

std::string why_not(const Candidate& loser, const Candidate& winner) {
    if (loser.what.damping != winner.what.damping) {
        return "more damping";
    }
    return shown_cfl(loser) < shown_cfl(winner) ? "smaller time step" : "more reflection";
}

/// Whether `better`, which comes first, is the same condition matched in other steps.
bool is_matched_alike(const Candidate& better, const Candidate& candidate) {
    return better.what.time_step != 0 && candidate.what.time_step != 0 &&
           better.what.order == candidate.what.order && better.what.stride == candidate.what.stride;
}

/// All of them, the recommended one first; of the same condition matched in several steps the
/// first.
std::vector<Candidate> in_order(const std::vector<Certified>& certified, const Question& question,
                                double tolerance) {
    std::vector<Candidate> all;
    all.reserve(certified.size());
    for (const Certified& one : certified) {
        all.push_back(in_steps(one, question, tolerance));
    }
    std::ranges::stable_sort(all, {}, [](const Candidate& candidate) {
        return std::tuple(!candidate.lost.empty(), candidate.cfl == 0, rank(candidate));
    });
    std::vector<Candidate> ranked;
    for (Candidate& candidate : all) {
        if (std::ranges::none_of(ranked, [&](const Candidate& better) {
                return is_matched_alike(better, candidate);
            })) {
            ranked.push_back(std::move(candidate));
        }
    }
    for (Candidate& candidate : ranked) {
        if (candidate.lost.empty() && &candidate != &ranked.front()) {
            candidate.lost = why_not(candidate, ranked.front());
        }
    }
    return ranked;
}

std::string row(const Candidate& candidate) {
    std::string text = fmt::format("{:>5} {:>6}", candidate.what.order, candidate.what.stride);
    const Rational& time_step = candidate.what.time_step;
    text +=
        candidate.certified_cfl > 0
            ? fmt::format(" {:>6} {:>9} {:>9.2f} {:>5.2f} {:>10.1e} {:>8.1e}",
                          to_string(candidate.what.damping),
                          time_step == 0 ? "-" : to_string(time_step), candidate.certified_cfl,
                          candidate.cfl, candidate.reflected, candidate.loss)
            : fmt::format(" {:>6} {:>9} {:>9} {:>5} {:>10} {:>8}", "-", "-", "-", "-", "-", "-");
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
        question.band.low, question.band.high, wavelength);
    for (const Candidate& candidate : all) {
        text += row(candidate);
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
    const bool damped = best.what.damping != 0;
    const bool matched = best.what.time_step != 0;
    return fmt::format(
        "NMBC{}, stride {}, tau = {}, {}steps of cfl {:.2f}, at horizon {}, G = {}\n"
        "  command    {}\n"
        "  certified  stable with both ends alike, {}, in steps of cfl {:.2f} or less\n"
        "  reflected  {:.1e} of the energy in steps of cfl {:.2f}, dt = {:.4g} dX/c{}\n"
        "  loss       {:.1e} of the energy\n\n{}",
        best.what.order, best.what.stride, to_string(best.what.damping),
        matched ? "matched in " : "", best.cfl, best.what.horizon, to_string(question.G),
        regenerating_command(best.what),
        damped ? fmt::format("in chains of {} interior nodes and more", least_damped_nodes)
               : std::string("in chains of any length (docs/stability.md: short ones)"),
        best.certified_cfl, best.reflected, best.cfl, best.time_step,
        matched ? ", and takes no other" : "; another step reflects more or less", best.loss,
        table_of(all, question, tolerance));
}

}  // namespace nmbcgen
