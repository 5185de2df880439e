// SPDX-License-Identifier: MIT
/// What a plane asks of its parameters, its model and its sides.
#pragma once

#include <cmath>
#include <nmbc/correspondence_model.hpp>
#include <nmbc/plane_model.hpp>
#include <nmbc/plane_parameters.hpp>
#include <nmbc/plane_sides.hpp>
#include <stdexcept>
#include <variant>

namespace nmbc::detail {

inline bool is_positive_and_finite(double value) {
    return value > 0 && std::isfinite(value);
}

/// Throws std::invalid_argument, or std::length_error of too many nodes.
inline const PlaneParameters& checked(const PlaneParameters& p) {
    if (!is_positive_and_finite(p.spacing) || !is_positive_and_finite(p.youngs_modulus) ||
        !is_positive_and_finite(p.density) || !is_positive_and_finite(p.time_step)) {
        throw std::invalid_argument(
            "spacing, Young's modulus, density and time step must be positive and finite");
    }
    if (p.nx == 0 || p.ny == 0) {
        throw std::invalid_argument("a plane needs interior nodes along both axes");
    }
    constexpr double most = 1e15;
    if (static_cast<double>(p.nx) * static_cast<double>(p.ny) > most) {
        throw std::length_error("so many nodes fit in no memory");
    }
    return p;
}

/// The model with the null Lagrangian of its passive sides; bonds have none. Throws
/// std::invalid_argument where model and sides do not go together.
inline PlaneModel model_between(const PlaneSides& sides, const PlaneModel& model) {
    require_made_for(sides, model);
    const auto* const correspondence = std::get_if<CorrespondenceModel>(&model.law());
    if (correspondence == nullptr) {
        checked_null_lagrangian(sides, 0, 0);
        return model;
    }
    if (correspondence->radius_squared == 0 || !is_positive_and_finite(correspondence->bulk) ||
        !is_positive_and_finite(correspondence->shear) ||
        !(correspondence->stabilisation >= 0 && std::isfinite(correspondence->stabilisation))) {
        throw std::invalid_argument(
            "a plane needs a model with positive moduli, such as nopd2d() makes");
    }
    CorrespondenceModel with = correspondence->influence.empty()
                                   ? *correspondence
                                   : with_influence(*correspondence, correspondence->influence);
    with.null_lagrangian =
        checked_null_lagrangian(sides, correspondence->null_lagrangian, 2 * with.shear);
    return with;
}

}  // namespace nmbc::detail
