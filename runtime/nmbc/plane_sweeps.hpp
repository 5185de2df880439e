// SPDX-License-Identifier: MIT
/// The sweeps over rows of a plane lattice that are made for its family.
#pragma once

#include <cstddef>
#include <nmbc/correspondence_model.hpp>
#include <nmbc/plane_family.hpp>
#include <nmbc/plane_row_sweeps.hpp>
#include <nmbc/plane_row_sweeps_beside.hpp>

namespace nmbc::detail {

/// Functions of plane_row_sweeps.hpp and plane_row_sweeps_beside.hpp.
template <class Real>
struct PlaneSweeps {
    static constexpr std::size_t largest_reach = 3;

    decltype(&nmbc::detail::stress_row<PlaneShape<1>, Real>) stress_row = nullptr;
    decltype(&nmbc::detail::kick_row<PlaneShape<1>, Real>) kick_row = nullptr;
    decltype(&stress_row_beside<PlaneShape<1>, Real, 0>) stress_beside = nullptr;
    decltype(&stress_row_beside<PlaneShape<1>, Real, 0>) stress_strip = nullptr;
    std::ptrdiff_t strip_nodes = 0;  ///< of which the strips' sweep is made

    /// Without them a plane goes node by node, which takes some ten times as long.
    bool exist() const { return stress_row != nullptr; }
};

template <int RadiusSquared, class Real>
PlaneSweeps<Real> sweeps_of_family() {
    using Shape = PlaneShape<RadiusSquared>;
    static_assert(Shape::reach <= int(PlaneSweeps<Real>::largest_reach));
    return {.stress_row = stress_row<Shape, Real>,
            .kick_row = kick_row<Shape, Real>,
            .stress_beside = stress_row_beside<Shape, Real, 0>,
            .stress_strip = stress_row_beside<Shape, Real, stress_strip<Shape, Real>>,
            .strip_nodes = stress_strip<Shape, Real>};
}

/// None for other families, and for those with an influence, whose sums are not those of columns.
template <class Real>
PlaneSweeps<Real> sweeps_of(const CorrespondenceModel& model) {
    if (!model.influence.empty()) {
        return {};
    }
    switch (model.radius_squared) {
        case 1:
            return sweeps_of_family<1, Real>();
        case 2:
            return sweeps_of_family<2, Real>();
        case 4:
            return sweeps_of_family<4, Real>();
        case 5:
            return sweeps_of_family<5, Real>();
        case 8:
            return sweeps_of_family<8, Real>();
        case 9:
            return sweeps_of_family<9, Real>();
        default:
            return {};
    }
}

}  // namespace nmbc::detail
