// SPDX-License-Identifier: MIT
/// The dashpots of passive sides: of the lines of nodes across a side, and where two sides meet of
/// a corner as a whole.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/passive.hpp>
#include <nmbc/plane_force.hpp>
#include <nmbc/vector_loops.hpp>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// C of nodes of these masses that friction gamma slows.
inline std::vector<double> friction_matrix(double gamma, const std::vector<double>& mass) {
    std::vector<double> matrix(mass.size() * mass.size());
    for (std::size_t i = 0; i < mass.size(); ++i) {
        matrix[i * (mass.size() + 1)] = gamma * mass[i];
    }
    return matrix;
}

/// Equal groups of nodes that dashpots join, one component each: in a step
///     v+ = v* - dt S C (v- + v*)/2,   S = (M + dt C/2)^-1,
/// v* what the forces alone would have made of v-; then M (v+ - v*) = -dt C (v- + v+)/2.
/// Many groups are closed abreast, in vectors across them; a group alone in vectors of its nodes.
template <class Real>
class DashpotGroups {
  public:
    /// What one side does in a group: C, nodes times nodes, row by row.
    struct OfSide {
        std::size_t side = 0;  ///< its place among plane_sides
        std::vector<double> dashpots{};
    };

    /// offsets: entries of the group's nodes in a field, from its own; groups: entries of these, of
    /// `component`. mass: of the nodes. Units E = density = dX = 1, time_step too.
    DashpotGroups(std::size_t component, std::vector<std::ptrdiff_t> offsets,
                  std::vector<std::ptrdiff_t> groups, const std::vector<double>& mass,
                  const std::vector<OfSide>& sides, double time_step)
        : component_(component),
          size_(offsets.size()),
          offsets_(std::move(offsets)),
          groups_(std::move(groups)),
          are_in_a_row_(std::ranges::adjacent_find(
                            groups_, [](auto one, auto next) { return next != one + 1; }) ==
                        groups_.end()),
          mass_(mass),
          dashpots_(size_ * size_) {
        for (const OfSide& side : sides) {
            add(side);
        }
        std::vector<double> sum(size_ * size_);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] = time_step / 2 * dashpots_[i] + (i / size_ == i % size_ ? mass[i / size_] : 0);
        }
        const std::vector<double> drag =
            product(inverse_of(std::move(sum), size_), size_, dashpots_, size_);
        dragged_.resize(drag.size());
        for (std::size_t i = 0; i < drag.size(); ++i) {
            dragged_[i % size_ * size_ + i / size_] = static_cast<Real>(time_step * drag[i]);
        }
        for (const double one : mass_) {
            impulses_.push_back(one / time_step);
        }
        with_abreast([&](auto abreast) {
            before_.resize(size_ * ((groups_.size() + abreast - 1) / abreast * abreast));
            now_.resize(size_ * abreast);
            change_.resize(size_ * abreast);
        });
        mean_.resize(size_);
    }

    /// Keeps v-.
    void keep(PlaneField<const Real> v) {
        with_abreast([&](auto abreast) {
            for (std::size_t first = 0; first < groups_.size(); first += abreast) {
                for_each_node<abreast>(first, [&, before = &before_[first * size_]](
                                                  std::size_t i, std::ptrdiff_t entry) {
                    before[i] = v[component_][entry];
                });
            }
        });
    }

    /// Makes v+ of v*, and adds to `gone` what each side has taken out: dt vbar.C vbar, vbar the
    /// mean of v- and v+, times 1/dt.
    void close(PlaneField<Real> v, std::array<double, 4>& gone) {
        with_abreast([&](auto abreast) { close_groups<abreast>(v[component_], gone); });
    }

    /// v += duration times what the dashpots alone do to it.
    void drag(double duration, PlaneField<Real> v) const {
        std::vector<double> old(size_);
        for (const std::ptrdiff_t group : groups_) {
            Real* const at = v[component_] + group;
            for (std::size_t i = 0; i < size_; ++i) {
                old[i] = static_cast<double>(at[offsets_[i]]);
            }
            for (std::size_t i = 0; i < size_ * size_; ++i) {
                at[offsets_[i / size_]] -=
                    static_cast<Real>(duration * dashpots_[i] * old[i % size_] / mass_[i / size_]);
            }
        }
    }

  private:
    /// C of one side, without its zeros.
    struct SideEntries {
        struct Entry {
            std::size_t row = 0;
            std::size_t column = 0;
            double value = 0;
        };
        std::size_t side = 0;
        std::vector<Entry> entries{};
    };

    /// Whole vectors; the numbers of as many lines stay in the cache of first level.
    static constexpr std::size_t most_abreast = 32;

    void add(const OfSide& side) {
        SideEntries own{side.side};
        for (std::size_t i = 0; i < dashpots_.size(); ++i) {
            dashpots_[i] += side.dashpots[i];
            if (side.dashpots[i] != 0) {
                own.entries.push_back({i / size_, i % size_, side.dashpots[i]});
            }
        }
        if (!own.entries.empty()) {
            sides_.push_back(std::move(own));
        }
    }

    /// Calls work(how many groups go abreast).
    template <class Work>
    void with_abreast(const Work& work) const {
        if (groups_.size() == 1) {
            work(std::integral_constant<std::size_t, 1>{});
        } else {
            work(std::integral_constant<std::size_t, most_abreast>{});
        }
    }

    /// Of the groups that go abreast from `first` on, calls work(i, entry in a component of a
    /// field), i counted as in now_.
    template <std::size_t Abreast, class Work>
    NMBC_INLINED void for_each_node(std::size_t first, const Work& work) const {
        const std::size_t there = std::min(Abreast, groups_.size() - first);
        if (are_in_a_row_) {
            for (std::size_t i = 0; i < size_; ++i) {
                const std::ptrdiff_t entry = groups_[first] + offsets_[i];
                NMBC_NO_ENTRY_NEEDS_ANOTHER
                for (std::size_t g = 0; g < there; ++g) {
                    work(i * Abreast + g, entry + static_cast<std::ptrdiff_t>(g));
                }
            }
            return;
        }
        for (std::size_t g = 0; g < there; ++g) {
            for (std::size_t i = 0; i < size_; ++i) {
                work(i * Abreast + g, groups_[first + g] + offsets_[i]);
            }
        }
    }

    /// Where fewer groups are left than go abreast, the entries of the others are 0.
    template <std::size_t Abreast>
    void close_groups(Real* v, std::array<double, 4>& gone) {
        std::array<double, Abreast> by_one_side{};
        for (std::size_t first = 0; first < groups_.size(); first += Abreast) {
            const std::size_t there = std::min(Abreast, groups_.size() - first);
            const Real* const before = &before_[first * size_];
            if (there < Abreast) {
                std::ranges::fill(now_, Real(0));
            }
            for_each_node<Abreast>(
                first, [&](std::size_t i, std::ptrdiff_t entry) { now_[i] = v[entry]; });
            find_change<Abreast>(before);
            add_change<Abreast>(before, by_one_side);
            for_each_node<Abreast>(
                first, [&](std::size_t i, std::ptrdiff_t entry) { v[entry] = now_[i]; });
            if (sides_.size() > 1) {
                for (std::size_t g = 0; g < there; ++g) {
                    add_powers<Abreast>(before + g, &now_[g], gone);
                }
            }
        }
        if (sides_.size() == 1) {
            gone[sides_.front().side] +=
                std::accumulate(by_one_side.begin(), by_one_side.end(), 0.0);
        }
    }

    template <std::size_t Abreast>
    void find_change(const Real* before) {
        std::ranges::fill(change_, Real(0));
        for (std::size_t k = 0; k < size_; ++k) {
            std::array<Real, Abreast> between{};
            for (std::size_t g = 0; g < Abreast; ++g) {
                between[g] = (before[k * Abreast + g] + now_[k * Abreast + g]) / 2;
            }
            const Real* const column = &dragged_[k * size_];
            Real* __restrict change = change_.data();
            for (std::size_t i = 0; i < size_; ++i) {
                for (std::size_t g = 0; g < Abreast; ++g) {
                    change[i * Abreast + g] += column[i] * between[g];
                }
            }
        }
    }

    template <std::size_t Abreast>
    void add_change(const Real* before, std::array<double, Abreast>& power) {
        Real* __restrict now = now_.data();
        for (std::size_t i = 0; i < size_; ++i) {
            for (std::size_t g = 0; g < Abreast; ++g) {
                const std::size_t at = i * Abreast + g;
                now[at] -= change_[at];
                power[g] += impulses_[i] * static_cast<double>(change_[at]) *
                            (static_cast<double>(before[at]) + static_cast<double>(now[at])) / 2;
            }
        }
    }

    /// Of each side in one group: vbar.C vbar.
    template <std::size_t Abreast>
    void add_powers(const Real* before, const Real* now, std::array<double, 4>& gone) {
        for (std::size_t i = 0; i < size_; ++i) {
            mean_[i] =
                (static_cast<double>(before[i * Abreast]) + static_cast<double>(now[i * Abreast])) /
                2;
        }
        for (const SideEntries& side : sides_) {
            double power = 0;
            for (const auto& [row, column, value] : side.entries) {
                power += mean_[row] * value * mean_[column];
            }
            gone[side.side] += power;
        }
    }

    std::size_t component_;
    std::size_t size_;
    std::vector<std::ptrdiff_t> offsets_;
    std::vector<std::ptrdiff_t> groups_;
    bool are_in_a_row_;
    std::vector<SideEntries> sides_{};
    std::vector<double> mass_;
    std::vector<double> impulses_{};  // M/dt
    std::vector<double> dashpots_;    // C, of all sides
    std::vector<Real> dragged_{};     // dt S C, column by column
    // Of nodes of groups that go abreast: node by node, of each the groups.
    std::vector<Real> before_{};  // v-, of all groups, those that go abreast after each other
    std::vector<Real> now_{};     // v* of the groups being closed, then v+
    std::vector<Real> change_{};  // their v* - v+
    std::vector<double> mean_{};  // of one of them
};

}  // namespace nmbc::detail
