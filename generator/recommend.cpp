// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/recommend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <tuple>

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

/// With the least damping that certifies it with a time step worth having.
Candidate least_damped(Specification what, const Question& question) {
    Candidate candidate;
    std::string obstacle;
    for (const Rational& damping : damping_ladder()) {
        what.damping = damping;
        candidate.what = what;
        try {
            const HalfSpace half_space = make_half_space(derive(what), question.G);
            if (stability_grade(half_space) == Grade::none) {
                continue;
            }
            candidate.cfl = largest_cfl(half_space, GhostLevel::midpoint);
            if (candidate.cfl < smallest_cfl) {
                candidate.cfl = 0;
                continue;
            }
            candidate.reflected =
                mean_reflected_energy(half_space, question.band.low, question.band.high);
            candidate.loss = loss_per_wavelength(half_space, wavelength);
            return candidate;
        } catch (const NoSuchBoundary&) {
            continue;  // with this damping
        }
    }
    candidate.lost = fmt::format("not certified with cfl {} or more and any tau up to {}",
                                 smallest_cfl, to_string(damping_ladder().back()));
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

std::string row(const Candidate& candidate) {
    const std::string tau = candidate.cfl > 0 ? to_string(candidate.what.damping) : "-";
    std::string text =
        fmt::format("{:>5} {:>6} {:>6}", candidate.what.order, candidate.what.stride, tau);
    text += candidate.cfl > 0 ? fmt::format(" {:>5.2f} {:>10.1e} {:>10.1e}", candidate.cfl,
                                            candidate.reflected, candidate.loss)
                              : fmt::format(" {:>5} {:>10} {:>10}", "-", "-", "-");
    return text + "  " + candidate.lost;
}

std::string table_of(const std::vector<Candidate>& all, const Question& question) {
    std::string text = fmt::format(
        "reflected: energy, mean over xi = {:g} .. {:g}/dX; loss: energy of a wave of {:g} dX over "
        "one wavelength, by damping\n\norder stride    tau   cfl  reflected       loss\n",
        question.band.low, question.band.high, wavelength);
    for (const Candidate& candidate : all) {
        text += row(candidate) + "\n";
    }
    return text;
}

}  // namespace

std::vector<Candidate> candidates(const Question& question) {
    std::vector<Candidate> all;
    const unsigned least = question.order.value_or(1);
    const unsigned most = question.order.value_or(highest_order);
    for (unsigned order = least; order <= most; ++order) {
        for (unsigned stride = 1; stride <= question.horizon + 2; ++stride) {
            all.push_back(least_damped(
                {question.family, question.horizon, order, stride, question.G}, question));
        }
    }
    double first_order = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : all) {
        if (candidate.what.order == 1 && candidate.cfl > 0) {
            first_order = std::min(first_order, candidate.reflected);
        }
    }
    for (Candidate& candidate : all) {
        if (candidate.cfl == 0) {
            continue;
        }
        if (!question.order && candidate.what.order == 1) {
            candidate.lost = "order 1";
        } else if (question.tolerance && candidate.reflected > *question.tolerance) {
            candidate.lost = "above the tolerance";
        } else if (!question.order && candidate.reflected >= first_order) {
            candidate.lost = "reflects no less than NMBC1";
        }
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

std::string recommendation(const Question& question) {
    const std::vector<Candidate> all = candidates(question);
    const Candidate& best = all.front();
    if (!best.lost.empty()) {
        throw NoSuchBoundary(fmt::format("no boundary for horizon {} at G = {} answers this.\n{}",
                                         question.horizon, to_string(question.G),
                                         table_of(all, question)));
    }
    Specification open = best.what;
    open.stabilisation.reset();
    const bool damped = best.what.damping != 0;
    return fmt::format(
        "NMBC{}, stride {}, tau = {}, steps of cfl {:.2f} or less, at horizon {}, G = {}\n"
        "  table      {}.hpp, by nmbcgen --order {} --horizon {} --stride {}{}\n"
        "  certified  stable with both ends alike, {}\n"
        "  reflected  {:.1e} of the energy\n"
        "  loss       {:.1e} of the energy\n\n{}",
        best.what.order, best.what.stride, to_string(best.what.damping), best.cfl,
        best.what.horizon, to_string(question.G), table_name(open), best.what.order,
        best.what.horizon, best.what.stride,
        damped ? " --damping " + to_string(best.what.damping) : std::string(),
        damped ? fmt::format("in chains of {} interior nodes and more", least_damped_nodes)
               : std::string("in chains of any length (docs/stability.md: short ones)"),
        best.reflected, best.loss, table_of(all, question));
}

}  // namespace nmbcgen
