// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/optimise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <mutex>
#include <numeric>
#include <thread>

#include "generator/candidates.hpp"
#include "generator/emit/emit.hpp"
#include "generator/exact/rational.hpp"
#include "generator/matching_search.hpp"
#include "generator/pipeline.hpp"
#include "generator/require_stable.hpp"
#include "generator/stability/band_reflection.hpp"
#include "generator/time_step.hpp"

namespace nmbcgen {
namespace {

/// work(0) .. work(count - 1), on all cores.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> taken = 0;
    const auto take = [&] {
        for (std::size_t i = taken++; i < count; i = taken++) {
            work(i);
        }
    };
    std::vector<std::future<void>> workers;
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    for (std::size_t i = 0; i < std::min(cores, count); ++i) {
        workers.push_back(std::async(std::launch::async, take));
    }
    for (std::future<void>& worker : workers) {
        worker.get();  // throws what the worker threw
    }
}

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

/// Derives and proves it, and says what it reflects; nothing where it does not exist.
std::optional<HalfSpace> examine(Contender& contender, const Aim& aim) {
    try {
        HalfSpace half_space =
            make_half_space(derive(contender.what), contender.what.stabilisation.value());
        const std::vector<double> energies = reflected_energies(
            stepped(half_space, nearest_double(aim.what.time_step)), aim.band.low, aim.band.high);
        contender.exists = true;
        contender.mean =
            std::accumulate(energies.begin(), energies.end(), 0.0) / double(energies.size());
        contender.largest = *std::ranges::max_element(energies);
        return half_space;
    } catch (const NoSuchBoundary&) {
        return std::nullopt;
    }
}

std::string why_not(const Contender& contender) {
    switch (contender.verdict.failure) {
        case ModalFailure::growing_mode:
            return "a boundary mode grows";
        case ModalFailure::resonance:
            return "it sends out a wave of its own";
        case ModalFailure::amplified_wave:
            return "waves are amplified";
        case ModalFailure::none:
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
    if (contender.certified_cfl == 0) {
        return text + fmt::format(" {:>9}  {}\n", "-", why_not(contender));
    }
    return text + fmt::format(" {:>9.2f}{}\n", contender.certified_cfl,
                              &contender == best ? "  the best" : "");
}

std::string table_of(const std::vector<Contender>& all, const Contender* best, const Aim& aim) {
    std::size_t width = 6;
    for (const Contender& contender : all) {
        width = std::max(width, points_text(contender).size());
    }
    std::string text = fmt::format(
        "points: what is matched, as --match has it; -: the standard NMBC{}\n"
        "mean, largest: reflected energy at 64 wave numbers xi = {:g} .. {:g}/dX, {}\n"
        "certified: the largest cfl\n\n"
        "stride  {:<{}} {:>9} {:>9} certified\n",
        aim.what.order, aim.band.low, aim.band.high,
        aim.what.time_step == 0 ? "in continuous time"
                                : fmt::format("in steps of {} dX/c", to_string(aim.what.time_step)),
        "points", width, "mean", "largest");
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
    Table lattice = any_standard(aim);
    const unsigned first = aim.stride.value_or(1);
    const unsigned last = aim.stride.value_or(std::max(2 * aim.what.horizon, 4U));
    std::vector<Contender> all;
    for (unsigned stride = first; stride <= last; ++stride) {
        all.resize(all.size() + aim.what.order + 1, {.what = standard(aim, stride)});
    }
    std::mutex told;
    std::size_t done = 0;
    const auto tell = [&] {
        const std::lock_guard lock(told);
        progress(done++, 2 * all.size());
    };

    const unsigned counts = aim.what.order + 1;
    on_all_cores(all.size(), [&](std::size_t i) {
        tell();
        const auto count = unsigned(i % counts);
        if (count > 0) {
            Table table = lattice;
            table.specification = aim.what;
            table.specification.stride = all[i].what.stride;
            all[i].what = table.specification;
            all[i].what.points = best_points(table, count, aim.band);
        }
    });
    // Where no points do: what is without them stands there already.
    std::vector<Contender> found;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i % counts == 0 || !all[i].what.points.empty()) {
            found.push_back(all[i]);
        }
    }
    std::vector<std::optional<HalfSpace>> half_spaces;  // the algebra system knows no threads
    for (Contender& contender : found) {
        half_spaces.push_back(examine(contender, aim));
    }
    on_all_cores(found.size(), [&](std::size_t i) {
        tell();
        if (half_spaces[i]) {
            const double own = nearest_double(aim.what.time_step);
            found[i].certified_cfl = certified_cfl(*half_spaces[i], own);
            if (found[i].certified_cfl == 0) {
                found[i].verdict = modal_verdict(*half_spaces[i]);
            }
        }
    });
    progress(2 * all.size(), 2 * all.size());
    return found;
}

const Contender* best_of(const std::vector<Contender>& all) {
    const Contender* best = nullptr;
    for (const Contender& one : all) {
        const auto rank = [](const Contender& some) {
            return std::pair(some.mean, some.what.points.size());
        };
        if (one.certified_cfl > 0 && (best == nullptr || rank(one) < rank(*best))) {
            best = &one;
        }
    }
    return best;
}

std::string optimisation(const Aim& aim, const Progress& progress) {
    const std::vector<Contender> all = contenders(aim, progress);
    const Contender* best = best_of(all);
    const std::string table = table_of(all, best, aim);
    const std::string request =
        fmt::format("order {} at horizon {}, G = {}{}", aim.what.order, aim.what.horizon,
                    to_string(*aim.what.stabilisation),
                    aim.what.damping == 0 ? "" : ", tau = " + to_string(aim.what.damping));
    if (best == nullptr) {
        throw NotStable(fmt::format(
            "nothing is certified of {}, standard or matched in the band. Try another stride, "
            "less order, or more damping.\n{}",
            request, table));
    }
    const bool damped = aim.what.damping != 0;
    const Rational& time_step = aim.what.time_step;
    const std::string steps =
        time_step == 0 ? fmt::format("steps of cfl {:.2f} or less", best->certified_cfl)
                       : fmt::format("these steps, of cfl {:.2f}",
                                     nearest_double(time_step) * maximum_frequency(best->what) / 2);
    return fmt::format(
        "{}, stride {}, {}\n"
        "  reflected  {:.1e} of the energy, mean over the band, {:.1e} at most\n"
        "  standard   {}\n"
        "  certified  stable with both ends alike{}, in {}\n\n{}\n"
        "  command    {}\n",
        request, best->what.stride,
        best->what.points.empty() ? "the standard one" : "matched at " + matching_text(best->what),
        best->mean, best->largest, standard_text(all),
        damped ? fmt::format(", in chains of {} interior nodes and more", least_damped_nodes) : "",
        steps, table, regenerating_command(best->what));
}

}  // namespace nmbcgen
