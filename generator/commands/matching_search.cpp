// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/matching_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>

#include "generator/exact/rational.hpp"
#include "generator/matching/local.hpp"
#include "generator/matching/points.hpp"
#include "generator/stability/band_reflection.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"

namespace nmbcgen {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Ascending, in units of the grid.
using GridPoints = std::vector<std::int64_t>;

struct Trial {
    double reflected = infinite;  ///< infinite where there is no such condition
    bool certified = false;
};

class Search {
  public:
    Search(const Table& lattice, const WaveNumberRange& band)
        : lattice_(lattice),
          band_(band),
          units_(std::round(std::pow(10.0, std::ceil(2 - std::log10(band.high - band.low))))),
          highest_(std::int64_t(std::numbers::pi * units_)),
          time_step_(nearest_double(lattice.specification.time_step)) {}

    /// fewer: the best ones of one point less, or empty.
    GridPoints best(unsigned count, GridPoints fewer) {
        met_.clear();
        const double above = std::min(2 * band_.high - band_.low, std::numbers::pi);
        descend(chebyshev_nodes(count, band_.low, band_.high), false);
        descend(chebyshev_nodes(count, 0, band_.low), false);
        descend(chebyshev_nodes(count, band_.high, above), false);
        if (fewer.size() + 1 == count) {
            GridPoints next_to_pi = fewer;
            next_to_pi.push_back(highest_);
            descend(std::move(next_to_pi), false);
            fewer.insert(fewer.begin(), 1);
            descend(std::move(fewer), false);
        }
        const GridPoints certified = best_met(true);
        if (certified.empty()) {
            return best_met(false);
        }
        descend(certified, true);
        return best_met(true);
    }

    std::vector<MatchingPoint> points_at(const GridPoints& grid) const {
        std::vector<MatchingPoint> points;
        for (const std::int64_t xi : grid) {
            const Rational wave_number(xi, std::int64_t(units_));
            if (!points.empty() && points.back().wave_number == wave_number) {
                ++points.back().multiplicity;
            } else {
                points.push_back({.wave_number = wave_number, .of_pi = false, .multiplicity = 1});
            }
        }
        return points;
    }

  private:
    GridPoints chebyshev_nodes(unsigned count, double low, double high) const {
        GridPoints nodes;
        for (unsigned i = count; i-- > 0;) {
            const double cosine = std::cos(std::numbers::pi * (i + 0.5) / count);
            const double xi = (low + high) / 2 + (high - low) / 2 * cosine;
            nodes.push_back(std::clamp<std::int64_t>(std::llround(xi * units_), 1, highest_));
        }
        return nodes;
    }

    bool on_grid(std::int64_t xi) const { return xi >= 1 && xi <= highest_; }

    /// Whether a step that is worth having is stable, in a small part of a certificate's time.
    bool may_be_certified(const HalfSpace& half_space) const {
        constexpr double small_cfl = 0.05;
        const double step =
            time_step_ > 0 ? time_step_ : 2 * small_cfl / maximum_frequency(half_space);
        return stability_grade(half_space) != Grade::none &&
               stability_grade(stepped(half_space, step)) != Grade::none;
    }

    Trial tried(const GridPoints& grid) const {
        Table table = lattice_;
        table.specification.points = points_at(grid);
        try {
            match_at_points(table);
        } catch (const NotMatched&) {
            return {};
        }
        const HalfSpace half_space =
            make_half_space(table, table.specification.stabilisation.value());
        const double reflected =
            mean_reflected_energy(stepped(half_space, time_step_), band_.low, band_.high);
        if (!std::isfinite(reflected)) {
            return {};
        }
        return {reflected, may_be_certified(half_space)};
    }

    double objective(const GridPoints& grid, bool certified_only) {
        auto known = met_.find(grid);
        if (known == met_.end()) {
            known = met_.emplace(grid, tried(grid)).first;
        }
        if (certified_only && !known->second.certified) {
            return infinite;
        }
        return known->second.reflected;
    }

    /// Each point by a step down and up; certified ones also with another point, by as much or
    /// less: along the edge of what is certified, however it runs.
    static std::vector<GridPoints> moves(std::size_t count, std::int64_t step, bool certified) {
        std::vector<GridPoints> all;
        for (std::size_t i = 0; i < count; ++i) {
            for (const std::int64_t change : {-step, step}) {
                GridPoints move(count, 0);
                move[i] = change;
                all.push_back(move);
                for (std::size_t j = 0; certified && j < count; ++j) {
                    for (std::int64_t other = step; i != j && other > 0; other /= 2) {
                        for (const std::int64_t with : {-other, other}) {
                            all.push_back(move);
                            all.back()[j] = with;
                        }
                    }
                }
            }
        }
        return all;
    }

    void descend(GridPoints here, bool certified_only) {
        constexpr double worth_it = 0.999;
        double value = objective(here, certified_only);
        auto step = std::max<std::int64_t>(1, std::llround((band_.high - band_.low) * units_ / 4));
        while (step > 0) {
            bool moved = false;
            for (const GridPoints& move : moves(here.size(), step, certified_only)) {
                GridPoints there = here;
                for (std::size_t i = 0; i < here.size(); ++i) {
                    there[i] += move[i];
                }
                if (!std::ranges::all_of(there, [this](std::int64_t xi) { return on_grid(xi); })) {
                    continue;
                }
                std::ranges::sort(there);
                const double next = objective(there, certified_only);
                if (next < worth_it * value || (std::isinf(value) && std::isfinite(next))) {
                    here = there;
                    value = next;
                    moved = true;
                }
            }
            step = moved ? step : step / 2;
        }
    }

    /// Empty where there is none.
    GridPoints best_met(bool certified_only) const {
        GridPoints best;
        double least = infinite;
        for (const auto& [grid, trial] : met_) {
            if (trial.reflected < least && (trial.certified || !certified_only)) {
                best = grid;
                least = trial.reflected;
            }
        }
        return best;
    }

    const Table& lattice_;
    WaveNumberRange band_;
    double units_;          ///< of the grid in 1/dX, a power of ten
    std::int64_t highest_;  ///< below pi
    double time_step_;
    std::map<GridPoints, Trial> met_{};  ///< with the number of points that is sought
};

}  // namespace

std::vector<std::vector<MatchingPoint>> best_points(const Table& lattice,
                                                    const WaveNumberRange& band) {
    Search search(lattice, band);
    std::vector<std::vector<MatchingPoint>> found;
    GridPoints best;
    for (unsigned count = 1; count <= lattice.specification.order; ++count) {
        best = search.best(count, best);
        found.push_back(search.points_at(best));
    }
    return found;
}

}  // namespace nmbcgen
