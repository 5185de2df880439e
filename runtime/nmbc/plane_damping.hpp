// SPDX-License-Identifier: MIT
/// Forces on the velocities of a plane. A part of plane.hpp.
///
/// A step takes them at the velocity before it, v-. With D their matrix, they are then those at the
/// mean of v- and v+ for masses M - dt D/2, which is why steps are shorter (longest_step()), and
/// why they only take energy where they are short enough.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <nmbc/correspondence_model.hpp>
#include <nmbc/plane.hpp>
#include <nmbc/plane_force.hpp>
#include <nmbc/plane_model.hpp>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace nmbc {

template <class Real>
std::optional<detail::PlaneForce<Real>> BasicPlane<Real>::damping_of(
    const std::variant<CorrespondenceModel, BondModel>& law) const {
    const auto* const correspondence = std::get_if<CorrespondenceModel>(&law);
    if (correspondence == nullptr || correspondence->damping == 0) {
        return std::nullopt;
    }
    return std::get<detail::PlaneForce<Real>>(
        force_of(CorrespondenceModel{.radius_squared = correspondence->radius_squared,
                                     .stabilisation = correspondence->damping,
                                     .influence = correspondence->influence}));
}

/// Of so much time, from v as it is.
template <class Real>
void BasicPlane<Real>::find_damping(double duration) {
    close_ghosts(v_);
    for (std::vector<Real>& component : damping_change_) {
        std::ranges::fill(component, Real(0));
    }
    damping_->kick(duration * parameters_.rate(), field(std::as_const(v_)), field(damping_change_));
}

template <class Real>
void BasicPlane<Real>::add_damping(Fields& v) const {
    for (std::size_t a = 0; a < 2; ++a) {
        std::ranges::transform(v[a], damping_change_[a], v[a].begin(), std::plus<>());
    }
}

/// Half of a step's work against it: its path is dt times the mean of the old and the new v.
template <class Real>
void BasicPlane<Real>::count_damped() {
    const auto change = field(std::as_const(damping_change_));
    const auto v = field(std::as_const(v_));
    for (std::ptrdiff_t y = 0; y < static_cast<std::ptrdiff_t>(ny_); ++y) {
        double sum = 0;
        for (std::ptrdiff_t x = 0; x < static_cast<std::ptrdiff_t>(nx_); ++x) {
            const std::ptrdiff_t at = y * static_cast<std::ptrdiff_t>(grid().nx) + x;
            for (std::size_t a = 0; a < 2; ++a) {
                sum += mass_of(a, x, y) * static_cast<double>(change[a][at]) *
                       static_cast<double>(v[a][at]);
            }
        }
        damped_ -= sum / 2;
    }
}

}  // namespace nmbc
