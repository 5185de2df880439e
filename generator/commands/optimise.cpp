// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/optimise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <numeric>

#include "generator/commands/candidates.hpp"
#include "generator/commands/matching_search.hpp"
#include "generator/commands/require_stable.hpp"
#include "generator/commands/time_step.hpp"
#include "generator/exact/rational.hpp"
#include "generator/names/names.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/band_reflection.hpp"
#include "generator/support/on_all_cores.hpp"

namespace nmbcgen {
namespace {

/// The standard condition of order 1 is the same in time steps: it is made without.
Specification standard(const Aim& aim, unsigned stride) {
    Specification what = aim.what;
    what.stride = stride;
    what.points.clear();
    if (what.order == 1) {
        what.time_step = 0;
    }
    return what;
}

/// With its model and its Taylor coefficients, which no stride changes.
Table any_standard(const Aim& aim) {
    const unsigned last = std::max(aim.stride.value_or(1), 4U);
    for (unsigned stride = 1; stride < last; ++stride) {
        try {
            return derive(standard(aim, stride));
        } catch (const NoSuchBoundary&) {
            continue;
        }
    }
    return derive(standard(aim, last));
}

/// Less is not told apart: amplitudes come from doubles.
constexpr double roundings = 1e-26;

/// Derives and proves it, and says what it reflects; nothing where it does not exist.
std::optional<HalfSpace> examine(Contender& contender, const Aim& aim) {
    try {
        HalfSpace half_space =
            make_half_space(derive(contender.what), contender.what.stabilisation.value());
        const std::vector<double> energies = reflected_energies(
            stepped(half_space, nearest_double(aim.what.time_step)), aim.band.low, aim.band.high);
        contender.exists = true;
        const double sum = std::accumulate(energies.begin(), energies.end(), 0.0);
        contender.mean = std::max(sum / double(energies.size()), roundings);
        contender.largest = std::max(*std::ranges::max_element(energies), roundings);
        return half_space;
    } catch (const NoSuchBoundary&) {
        return std::nullopt;
    }
}

std::string why_not(const Contender& contender) {
    switch (contender.verdict.failure) {
        case Failure::growing_mode:
            return "a boundary mode grows";
        case Failure::resonance:
            return "it sends out a wave of its own";
        case Failure::amplified_wave:
            return "waves are amplified";
        default:
            break;
    }
    return "not certified in such steps";
}

std::string points_text(const Contender& contender) {
    return contender.what.points.empty() ? "-" : matching_text(contender.what);
}

std::string row(const Contender& contender, const Contender* best, std::size_t width) {
    std::string text =
        fmt::format("{:>6}  {:<{}}", contender.what.stride, points_text(contender), width);
    if (!contender.exists) {
        return text + fmt::format(" {:>9} {:>9} {:>9}  no such condition\n", "-", "-", "-");
    }
    text += fmt::format(" {:>9.1e} {:>9.1e}", contender.mean, contender.largest);
    if (contender.certified.largest == 0) {
        return text + fmt::format(" {:>9}  {}\n", "-", why_not(contender));
    }
    return text + fmt::format(" {:>9.2f}{}\n", contender.certified.largest,
                              &contender == best ? "  the best" : "");
}

std::string table_of(const std::vector<Contender>& all, const Contender* best, const Aim& aim) {
    std::size_t width = 6;
    for (const Contender& contender : all) {
        width = std::max(width, points_text(contender).size());
    }
    const bool at_roundings = std::ranges::any_of(
        all, [](const Contender& one) { return one.exists && one.mean == roundings; });
    std::string text = fmt::format(
        "points: what is matched, as --match has it; -: the standard NMBC{}\n"
        "mean, largest: reflected energy at 64 wave numbers between xi = {:g} and {:g}/dX, {}{}\n"
        "certified: the largest cfl\n\n"
        "stride  {:<{}} {:>9} {:>9} certified\n",
        aim.what.order, aim.band.low, aim.band.high,
        aim.what.time_step == 0 ? "in continuous time"
                                : fmt::format("in steps of {} dX/c", to_string(aim.what.time_step)),
        at_roundings ? fmt::format("; {:.1e}: that or less, roundings", roundings) : "", "points",
        width, "mean", "largest");
    for (const Contender& contender : all) {
        text += row(contender, best, width);
    }
    return text;
}

/// The best among standard conditions.
std::string standard_text(const std::vector<Contender>& all) {
    std::vector<Contender> standards;
    std::ranges::copy_if(all, std::back_inserter(standards),
                         [](const Contender& one) { return one.what.points.empty(); });
    const Contender* best = best_of(standards);
    if (best == nullptr) {
        return "none is certified";
    }
    return fmt::format("{:.1e} with stride {}, {:.1e} at most", best->mean, best->what.stride,
                       best->largest);
}

}  // namespace

std::vector<Contender> contenders(const Aim& aim, const Progress& progress) {
    const Table lattice = any_standard(aim);
    const unsigned first = aim.stride.value_or(1);
    const unsigned last = aim.stride.value_or(std::max(2 * aim.what.horizon, 4U));
    const std::size_t strides = last - first + 1;
    std::mutex told;
    std::size_t done = 0;
    std::size_t jobs = strides;
    const auto tell = [&] {
        const std::lock_guard lock(told);
        progress(done++, jobs);
    };

    std::vector<std::vector<std::vector<MatchingPoint>>> points(strides);
    on_all_cores(strides, [&](std::size_t i) {
        tell();
        Table table = lattice;
        table.specification = aim.what;
        table.specification.stride = first + unsigned(i);
        points[i] = best_points(table, aim.band);
    });
    std::vector<Contender> all;
    for (std::size_t i = 0; i < strides; ++i) {
        all.push_back({.what = standard(aim, first + unsigned(i))});
        for (const std::vector<MatchingPoint>& some : points[i]) {
            if (!some.empty()) {
                Specification what = aim.what;
                what.stride = first + unsigned(i);
                what.points = some;
                all.push_back({.what = std::move(what)});
            }
        }
    }
    std::vector<std::optional<HalfSpace>> half_spaces;  // the algebra system knows no threads
    half_spaces.reserve(all.size());
    for (Contender& contender : all) {
        half_spaces.push_back(examine(contender, aim));
    }
    jobs += all.size();
    const double own_step = nearest_double(aim.what.time_step);
    on_all_cores(all.size(), [&](std::size_t i) {
        tell();
        if (half_spaces[i]) {
            all[i].certified = certified_steps(*half_spaces[i], own_step);
            if (all[i].certified.largest == 0) {
                all[i].verdict = modal_verdict(*half_spaces[i]);
            }
        }
    });
    progress(jobs, jobs);
    return all;
}

const Contender* best_of(const std::vector<Contender>& all) {
    const Contender* best = nullptr;
    for (const Contender& one : all) {
        const auto rank = [](const Contender& some) {
            return std::pair(some.mean, some.what.points.size());
        };
        if (one.certified.largest > 0 && (best == nullptr || rank(one) < rank(*best))) {
            best = &one;
        }
    }
    return best;
}

std::string optimisation(const Aim& aim, const Progress& progress) {
    const std::vector<Contender> all = contenders(aim, progress);
    const Contender* best = best_of(all);
    const std::string table = table_of(all, best, aim);
    const std::string lattice =
        fmt::format("horizon {}, G = {}{}", aim.what.horizon, to_string(*aim.what.stabilisation),
                    aim.what.damping == 0 ? "" : ", tau = " + to_string(aim.what.damping));
    if (best == nullptr) {
        throw NotStable(fmt::format(
            "nothing of order {} is certified at {}, neither the standard condition nor one with "
            "matching points. Try another order, more damping or shorter steps.\n{}",
            aim.what.order, lattice, table));
    }
    const bool damped = aim.what.damping != 0;
    const Rational& time_step = aim.what.time_step;
    const std::string steps =
        time_step == 0 ? in_words(best->certified)
                       : fmt::format("these steps, of cfl {:.2f}",
                                     nearest_double(time_step) * maximum_frequency(best->what) / 2);
    return fmt::format(
        "NMBC{}, stride {}, {}, at {}\n"
        "  reflected  {:.1e} of the energy, mean over the band, {:.1e} at most\n"
        "  standard   {}\n"
        "  certified  stable with both ends alike{}, in {}\n\n{}\n"
        "  command    {}\n",
        aim.what.order, best->what.stride,
        best->what.points.empty() ? "the standard one" : "matched at " + matching_text(best->what),
        lattice, best->mean, best->largest, standard_text(all),
        damped ? fmt::format(", in chains of {} interior nodes and more", least_damped_nodes) : "",
        steps, table, regenerating_command(best->what));
}

}  // namespace nmbcgen
