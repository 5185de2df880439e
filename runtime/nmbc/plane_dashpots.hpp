// SPDX-License-Identifier: MIT
/// The dashpots of passive sides: of the lines of nodes across a side, and where two sides meet of
/// a corner as a whole.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/passive.hpp>
#include <nmbc/plane_force.hpp>
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
        const std::vector<double> drag =
            product(inverse_of(std::move(sum), size_), size_, dashpots_, size_);
        const std::size_t rows = whole_vectors(size_);
        dragged_.resize(size_ * rows);
        for (std::size_t i = 0; i < drag.size(); ++i) {
            dragged_[i % size_ * rows + i / size_] = static_cast<Real>(time_step * drag[i]);
        }
        for (const double one : mass_) {
            impulses_.push_back(one / time_step);
        }
        before_.resize(size_ * groups_.size());
        mean_.resize(size_);
        change_.resize(rows);
    }

    /// Keeps v-.
    void keep(PlaneField<const Real> v) {
        with_known_size([&](auto known) {
            const std::size_t size = known > 0 ? known : size_;
            for (std::size_t g = 0; g < groups_.size(); ++g) {
                for (std::size_t i = 0; i < size; ++i) {
                    before_[g * size + i] = v[component_][groups_[g] + offsets_[i]];
                }
            }
        });
    }

    /// Makes v+ of v*, and adds to `gone` what each side has taken out: dt vbar.C vbar, vbar the
    /// mean of v- and v+, times 1/dt.
    void close(PlaneField<Real> v, std::array<double, 4>& gone) {
        with_known_size([&](auto known) { close_groups<known>(v[component_], gone); });
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
    /// Rows of a column in memory.
    static constexpr std::size_t whole_vectors(std::size_t rows) { return (rows + 3) / 4 * 4; }

    /// Lines of the smaller horizons in loops of known length; 0: of any.
    template <class Work>
    void with_known_size(const Work& work) {
        switch (size_) {
            case 2:
                return work(std::integral_constant<std::size_t, 2>{});
            case 4:
                return work(std::integral_constant<std::size_t, 4>{});
            case 6:
                return work(std::integral_constant<std::size_t, 6>{});
            default:
                return work(std::integral_constant<std::size_t, 0>{});
        }
    }

    template <std::size_t Size>
    void close_groups(Real* v, std::array<double, 4>& gone) {
        const std::size_t size = Size == 0 ? size_ : Size;
        const std::size_t rows = whole_vectors(size);
        std::array<Real, whole_vectors(Size)> of_known_size{};
        Real* const change = Size == 0 ? change_.data() : of_known_size.data();
        double by_one_side = 0;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const Real* const before = &before_[g * size];
            Real* const at = v + groups_[g];
            std::fill_n(change, rows, Real(0));
            for (std::size_t k = 0; k < size; ++k) {
                const Real* const column = &dragged_[k * rows];
                const Real between = (before[k] + at[offsets_[k]]) / 2;
                for (std::size_t i = 0; i < rows; ++i) {
                    change[i] += column[i] * between;
                }
            }
            for (std::size_t i = 0; i < size; ++i) {
                Real& own = at[offsets_[i]];
                own -= change[i];
                mean_[i] = (static_cast<double>(before[i]) + static_cast<double>(own)) / 2;
                by_one_side += impulses_[i] * static_cast<double>(change[i]) * mean_[i];
            }
            if (sides_.size() > 1) {
                add_powers(gone);
            }
        }
        if (sides_.size() == 1) {
            gone[sides_.front().side] += by_one_side;
        }
    }

    /// Of each side in one group: vbar.C vbar.
    void add_powers(std::array<double, 4>& gone) const {
        for (const OfSide& side : sides_) {
            for (std::size_t i = 0; i < size_; ++i) {
                for (std::size_t k = 0; k < size_; ++k) {
                    gone[side.side] += mean_[i] * side.dashpots[i * size_ + k] * mean_[k];
                }
            }
        }
    }

    std::size_t component_;
    std::size_t size_;
    std::vector<std::ptrdiff_t> offsets_;
    std::vector<std::ptrdiff_t> groups_;
    std::vector<OfSide> sides_;
    std::vector<double> mass_;
    std::vector<double> impulses_{};  // M/dt
    std::vector<double> dashpots_;    // C, of all sides
    std::vector<Real> dragged_{};     // dt S C, column by column, each of whole vectors
    std::vector<Real> before_{};      // v-, group by group
    std::vector<Real> change_{};      // v* - v+ of one group, while it closes
    std::vector<double> mean_{};      // likewise
};

}  // namespace nmbc::detail
