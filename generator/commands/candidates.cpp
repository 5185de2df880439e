// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <tuple>
#include <utility>

#include "generator/commands/time_step.hpp"
#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/band_reflection.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"

namespace nmbcgen {
namespace {

constexpr unsigned highest_order = 6;
constexpr unsigned highest_damped_order = 4;  // above, certified damping is rare and takes long
constexpr double smallest_cfl = 0.25;         // below, more damping is the better bargain

/// The values of tau that are tried, ascending from 0; 0 alone for a family without stabilisation.
std::span<const Rational> dampings_of(const Specification& what) {
    static const std::array<Rational, 8> all{0,
                                             Rational(1, 100),
                                             Rational(1, 50),
                                             Rational(1, 20),
                                             Rational(1, 10),
                                             Rational(1, 5),
                                             Rational(3, 10),
                                             Rational(1, 2)};
    const bool is_damped = is_stabilised(what.family) && what.order <= highest_damped_order;
    return std::span(all).first(is_damped ? all.size() : 1);
}

/// Certified with a time step worth having.
Certified least_damped(Specification what) {
    for (const Rational& damping : dampings_of(what)) {
        what.damping = damping;
        Certified found = certified(what);
        if (found.steps.largest >= smallest_cfl) {
            return found;
        }
    }
    return {what, {}, std::nullopt};
}

/// The same condition matched in time steps: with the least damping that certifies it in the
/// shortest ones, in the two longest in which it is certified then.
std::vector<Certified> matched_in_steps(Specification what, double top,
                                        const std::optional<double>& cfl) {
    std::vector<double> cfls{0.99, 0.95, 0.85, 0.75, 0.65, 0.55, 0.45, 0.35, smallest_cfl};
    if (cfl) {
        cfls = {*cfl};
    }
    const auto matched = [&](double steps) {
        what.time_step = time_step_below(2 * steps / top);
        return what.time_step > 0 ? certified(what) : Certified{};
    };
    std::vector<Certified> found;
    const std::span<const Rational> dampings = dampings_of(what);
    const auto least = std::ranges::find_if(dampings, [&](const Rational& damping) {
        what.damping = damping;
        return matched(cfls.back()).steps.largest > 0;
    });
    if (least == dampings.end()) {
        return found;
    }
    constexpr std::size_t enough = 2;
    for (const double steps : cfls) {
        if (found.size() == enough) {
            break;
        }
        Certified one = matched(steps);
        if (one.steps.largest > 0) {
            found.push_back(std::move(one));
        }
    }
    return found;
}

/// The steps are the question's, or those it is matched in, or else the largest certified ones, or
/// shorter ones by multiples of 0.05 of cfl. Order 1 is best in large steps, whose errors in time
/// undo its errors in space; the others, where they are not matched in steps, in short ones.
Candidate in_steps(const Certified& certified, const Question& question, double tolerance) {
    Candidate candidate;
    candidate.what = certified.what;
    candidate.certified = certified.steps;
    if (!certified.half_space) {
        candidate.lost =
            dampings_of(certified.what).size() == 1
                ? fmt::format("not certified with cfl {} or more; no tau was tried", smallest_cfl)
                : fmt::format("not certified with cfl {} or more and any tau up to {}",
                              smallest_cfl, to_string(dampings_of(certified.what).back()));
        return candidate;
    }
    const HalfSpace& half_space = *certified.half_space;
    const double top = maximum_frequency(half_space);
    const auto reflected_at = [&](double cfl) {
        return mean_reflected_energy(stepped(half_space, 2 * cfl / top), question.band.low,
                                     question.band.high);
    };
    candidate.loss = loss_per_wavelength(half_space, faded_wavelength);
    const Rational& time_step = certified.what.time_step;
    const bool may_shorten = time_step == 0 && !question.cfl;
    candidate.cfl = time_step == 0 ? question.cfl.value_or(certified.steps.largest)
                                   : nearest_double(time_step) * top / 2;
    if (!certified.steps.contains(candidate.cfl)) {
        candidate.lost = "not certified in such steps";
        return candidate;
    }
    candidate.reflected = reflected_at(candidate.cfl);
    constexpr double coarse = 0.05;
    for (int step = int(std::ceil(candidate.cfl / coarse)) - 1;
         may_shorten && step > 0 && certified.steps.contains(coarse * step) &&
         candidate.reflected > tolerance;
         --step) {
        const double reflected = reflected_at(coarse * step);
        if (reflected < candidate.reflected) {
            candidate.cfl = coarse * step;
            candidate.reflected = reflected;
        }
    }
    candidate.time_step = 2 * candidate.cfl / top;
    if (!(candidate.reflected <= tolerance)) {  // nor a NaN
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

}  // namespace

Certified certified(const Specification& what) {
    try {
        HalfSpace half_space = make_half_space(derive(what), what.stabilisation.value());
        const StepRange steps = certified_steps(half_space, nearest_double(what.time_step));
        return {what, steps, std::move(half_space)};
    } catch (const NoSuchBoundary&) {
        return {what, {}, std::nullopt};
    }
}

std::string in_words(const StepRange& steps) {
    return steps.from > 0 ? fmt::format("steps of cfl {:.3f} to {:.2f}", steps.from, steps.largest)
                          : fmt::format("steps of cfl {:.2f} or less", steps.largest);
}

StepRange certified_steps(const HalfSpace& half_space, double time_step) {
    const double own_cfl = cfl_of(half_space, time_step);
    const bool stable = own_cfl < 1 &&
                        stability_grade(stepped(half_space, time_step)) != Grade::none &&
                        stability_grade(half_space) != Grade::none;
    const StepRange steps = stable ? stable_range(half_space) : StepRange{};
    return time_step == 0 || steps.contains(own_cfl) ? steps : StepRange{};
}

std::vector<Certified> all_certified(const Question& question, const Progress& progress) {
    std::vector<Specification> all;
    const unsigned least = question.order.value_or(1);
    const unsigned most = question.order.value_or(highest_order);
    for (unsigned order = least; order <= most; ++order) {
        for (unsigned stride = 1; stride <= question.horizon + 2; ++stride) {
            all.push_back({.family = question.family,
                           .horizon = question.horizon,
                           .order = order,
                           .stride = stride,
                           .stabilisation = question.G,
                           .weights = question.weights});
        }
    }
    std::vector<Certified> found;
    const double top = maximum_frequency(all.front());
    std::size_t examined = 0;
    for (const Specification& what : all) {
        progress(examined++, all.size());
        if (Certified one = least_damped(what);
            one.half_space || what.order <= highest_damped_order || question.order) {
            found.push_back(std::move(one));
        }
        if (what.order > 1) {
            std::ranges::move(matched_in_steps(what, top, question.cfl), std::back_inserter(found));
        }
    }
    progress(all.size(), all.size());
    return found;
}

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

}  // namespace nmbcgen
