// SPDX-License-Identifier: MIT
/// The dashpots of passive sides: of the lines of nodes across a side, and where two sides meet of
/// a corner as a whole.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/passive.hpp>
#include <nmbc/plane_force.hpp>
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
///     v+ = v- + S (M (v* - v-) - dt C v-),   S = (M + dt C/2)^-1,
/// v* what the forces alone would have made of v-.
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
                  std::vector<OfSide> sides, double time_step)
        : component_(component),
          size_(offsets.size()),
          offsets_(std::move(offsets)),
          groups_(std::move(groups)),
          sides_(std::move(sides)),
          mass_(mass),
          dashpots_(size_ * size_) {
        std::erase_if(sides_, [](const OfSide& side) {  // takes nothing
            return std::ranges::all_of(side.dashpots, [](double one) { return one == 0; });
        });
        for (const OfSide& side : sides_) {
            for (std::size_t i = 0; i < dashpots_.size(); ++i) {
                dashpots_[i] += side.dashpots[i];
            }
        }
        std::vector<double> sum(size_ * size_);
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] = time_step / 2 * dashpots_[i] + (i / size_ == i % size_ ? mass[i / size_] : 0);
        }
        const std::vector<double> solve = inverse_of(std::move(sum), size_);
        const std::vector<double> drag = product(solve, size_, dashpots_, size_);
        for (std::size_t i = 0; i < solve.size(); ++i) {
            kicked_.push_back(static_cast<Real>(solve[i] * mass[i % size_]));
            dragged_.push_back(static_cast<Real>(time_step * drag[i]));
        }
        before_.resize(size_ * groups_.size());
        change_.resize(size_);
        mean_.resize(size_);
    }

    /// Keeps v-.
    void keep(PlaneField<const Real> v) {
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            for (std::size_t i = 0; i < size_; ++i) {
                before_[g * size_ + i] = v[component_][groups_[g] + offsets_[i]];
            }
        }
    }

    /// Makes v+ of v*, and adds to `gone` what each side has taken out: dt vbar.C vbar, vbar the
    /// mean of v- and v+, times 1/dt.
    void close(PlaneField<Real> v, std::array<double, 4>& gone) {
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const Real* const before = &before_[g * size_];
            Real* const at = v[component_] + groups_[g];
            for (std::size_t i = 0; i < size_; ++i) {
                Real sum = 0;
                for (std::size_t k = 0; k < size_; ++k) {
                    sum += kicked_[i * size_ + k] * (at[offsets_[k]] - before[k]) -
                           dragged_[i * size_ + k] * before[k];
                }
                change_[i] = sum;
            }
            for (std::size_t i = 0; i < size_; ++i) {
                at[offsets_[i]] = before[i] + change_[i];
                mean_[i] = static_cast<double>(before[i]) + static_cast<double>(change_[i]) / 2;
            }
            for (const OfSide& side : sides_) {
                double power = 0;
                for (std::size_t i = 0; i < size_ * size_; ++i) {
                    power += mean_[i / size_] * side.dashpots[i] * mean_[i % size_];
                }
                gone[side.side] += power;
            }
        }
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
    std::size_t component_;
    std::size_t size_;
    std::vector<std::ptrdiff_t> offsets_;
    std::vector<std::ptrdiff_t> groups_;
    std::vector<OfSide> sides_;
    std::vector<double> mass_;
    std::vector<double> dashpots_;  // C, of all sides
    std::vector<Real> kicked_;      // S M
    std::vector<Real> dragged_;     // dt S C
    std::vector<Real> before_;      // v-, group by group
    std::vector<Real> change_;      // of one group, while it closes
    std::vector<double> mean_;      // likewise
};

}  // namespace nmbc::detail
