// SPDX-License-Identifier: MIT
/// What sweeps beside sides that are cut off know of the nodes of a row.
#pragma once

#include <cstddef>
#include <nmbc/plane_nodes.hpp>
#include <nmbc/plane_row_sweeps_beside.hpp>
#include <vector>

namespace nmbc::detail {

template <class Real>
PlaneRowNumbers<Real> row_numbers(const PlaneNodes& nodes, std::ptrdiff_t y) {
    PlaneRowNumbers<Real> numbers;
    const std::ptrdiff_t horizon = nodes.horizon();
    const auto xs = nodes.x().with_energy();
    const auto ys = nodes.y().with_energy();
    const bool has_energy = y >= ys.first && y < ys.last;
    for (std::ptrdiff_t x = -horizon; x < nodes.x().nodes() + horizon; ++x) {
        const PlaneNeighbours* const near =
            has_energy && x >= xs.first && x < xs.last ? &nodes.neighbours(x, y) : nullptr;
        const PlaneWeights own = nodes.weights(x, y);
        const auto weight = [&](std::ptrdiff_t i, std::ptrdiff_t j) {
            return nodes.model().stabilisation * nodes.x().stabilisation(i) *
                   nodes.y().stabilisation(j);
        };
        double lost = 2 * weight(x, y);
        if (near != nullptr) {
            for (const auto& bond : near->bonds) {
                lost += weight(x, y) + weight(x + bond.x, y + bond.y);
            }
        }
        const auto add = [](std::vector<Real>& list, double value) {
            list.push_back(static_cast<Real>(value));
        };
        for (std::size_t i = 0; i < 3; ++i) {
            add(numbers.inverse_shape[i], near == nullptr ? 0 : near->inverse_shape[i]);
        }
        add(numbers.moment[0], near == nullptr ? 0 : near->sum_x);
        add(numbers.moment[1], near == nullptr ? 0 : near->sum_y);
        add(numbers.strain, own.strain);
        add(numbers.stabilisation, weight(x, y));
        add(numbers.own, lost);
        for (std::size_t a = 0; a < 2; ++a) {
            add(numbers.inverse_mass[a], 1 / own.mass[a]);
        }
    }
    return numbers;
}

/// Of all rows of a plane: rows far from the sides across y are alike.
template <class Real>
class PlaneRows {
  public:
    PlaneRows() = default;
    explicit PlaneRows(const PlaneNodes& nodes) : horizon_(nodes.horizon()) {
        for (std::ptrdiff_t x = -2 * horizon_; x < nodes.x().nodes() + 2 * horizon_; ++x) {
            across_.push_back(static_cast<Real>(nodes.x().stabilisation(x)));
        }
        for (std::ptrdiff_t y = -2 * horizon_; y < nodes.y().nodes() + 2 * horizon_; ++y) {
            along_.push_back(
                static_cast<Real>(nodes.model().stabilisation * nodes.y().stabilisation(y)));
        }
        const auto plain = nodes.y().plain_force();
        for (std::ptrdiff_t y = -horizon_; y < nodes.y().nodes() + horizon_; ++y) {
            const bool is_as_before = !numbers_.empty() && y > plain.first && y < plain.last;
            if (!is_as_before) {
                numbers_.push_back(row_numbers<Real>(nodes, y));
            }
            number_of_row_.push_back(numbers_.size() - 1);
        }
    }

    const PlaneRowNumbers<Real>& numbers(std::ptrdiff_t y) const {
        return numbers_[number_of_row_[static_cast<std::size_t>(y + horizon_)]];
    }
    /// Of the body's nodes in row y.
    PlaneMasses<Real> masses(const PlaneNodes& nodes, std::ptrdiff_t y) const {
        const auto& inverse = numbers(y).inverse_mass;
        const PlaneRange rows = nodes.y().plain_mass();
        return {{inverse[0].data() + horizon_, inverse[1].data() + horizon_},
                y >= rows.first && y < rows.last ? nodes.x().plain_mass() : PlaneRange{}};
    }
    /// The stabilisation's weight w is across times along: across() points at the column of node 0,
    /// along(y) at row y - reach.
    const Real* across() const { return across_.data() + 2 * horizon_; }
    const Real* along(std::ptrdiff_t y) const { return along_.data() + y + horizon_; }

  private:
    std::ptrdiff_t horizon_ = 0;
    std::vector<PlaneRowNumbers<Real>> numbers_{};
    std::vector<std::size_t> number_of_row_{};
    std::vector<Real> across_{};
    std::vector<Real> along_{};
};

}  // namespace nmbc::detail
