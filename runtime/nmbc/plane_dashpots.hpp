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
        kick_.resize(size_);
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
        switch (size_) {  // lines of the smaller horizons, in loops of known length
            case 2:
                return close_groups<2>(v[component_], gone);
            case 4:
                return close_groups<4>(v[component_], gone);
            case 6:
                return close_groups<6>(v[component_], gone);
            default:
                return close_groups<0>(v[component_], gone);
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
    /// Size: the nodes of a group; 0: as many as there are.
    template <std::size_t Size>
    void close_groups(Real* v, std::array<double, 4>& gone) {
        const std::size_t size = Size == 0 ? size_ : Size;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const Real* const before = &before_[g * size];
            Real* const at = v + groups_[g];
            for (std::size_t k = 0; k < size; ++k) {
                kick_[k] = at[offsets_[k]] - before[k];
            }
            for (std::size_t i = 0; i < size; ++i) {
                Real sum = 0;
                for (std::size_t k = 0; k < size; ++k) {
                    sum += kicked_[i * size + k] * kick_[k] - dragged_[i * size + k] * before[k];
                }
                at[offsets_[i]] = before[i] + sum;
                mean_[i] = static_cast<double>(before[i]) + static_cast<double>(sum) / 2;
            }
            for (const OfSide& side : sides_) {
                double power = 0;
                for (std::size_t i = 0; i < size; ++i) {
                    double drag = 0;
                    for (std::size_t k = 0; k < size; ++k) {
                        drag += side.dashpots[i * size + k] * mean_[k];
                    }
                    power += mean_[i] * drag;
                }
                gone[side.side] += power;
            }
        }
    }

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
    std::vector<Real> kick_;        // v* - v- of one group, while it closes
    std::vector<double> mean_;      // likewise
};

}  // namespace nmbc::detail
