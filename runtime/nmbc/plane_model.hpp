// SPDX-License-Identifier: MIT
/// Models of a plane lattice, whichever law they follow.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/bond_model.hpp>
#include <nmbc/correspondence_model.hpp>
#include <nmbc/plane_wave.hpp>
#include <utility>
#include <variant>

namespace nmbc {

/// A model of one law or the other: nopd2d() and bond2d() make them.
class PlaneModel {
  public:
    PlaneModel(CorrespondenceModel law) : law_(law) {}
    PlaneModel(BondModel law) : law_(std::move(law)) {}

    const std::variant<CorrespondenceModel, BondModel>& law() const { return law_; }

    /// The farthest neighbour along an axis, and how far forces reach [dX].
    std::size_t horizon() const {
        return std::visit([](const auto& law) { return law.horizon(); }, law_);
    }
    std::size_t reach() const {
        return std::visit([](const auto& law) { return law.reach(); }, law_);
    }
    /// Of long waves along an axis, where E = density = 1.
    double speed_P() const {
        return std::visit([](const auto& law) { return law.speed_P(); }, law_);
    }
    double speed_S() const {
        return std::visit([](const auto& law) { return law.speed_S(); }, law_);
    }

  private:
    std::variant<CorrespondenceModel, BondModel> law_;
};

inline PlaneWave plane_wave(const PlaneModel& model, const std::array<double, 2>& xi, bool is_P) {
    return std::visit([&](const auto& law) { return plane_wave(law, xi, is_P); }, model.law());
}

/// The largest omega^2 of the interior, over wave vectors in steps of pi/64.
inline double highest_eigenvalue(const PlaneModel& model) {
    double highest = 0;
    detail::for_each_wave_vector([&](const std::array<double, 2>& xi) {
        for (const bool is_P : {true, false}) {
            highest = std::max(highest, plane_wave(model, xi, is_P).omega_squared);
        }
    });
    return highest;
}

}  // namespace nmbc
