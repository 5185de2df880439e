// SPDX-License-Identifier: MIT
/// All that a run of a plane goes on from. A part of plane.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nmbc/bond_force.hpp>
#include <nmbc/bond_states.hpp>
#include <nmbc/plane.hpp>
#include <span>
#include <stdexcept>
#include <variant>
#include <vector>

namespace nmbc {

/// All that a run goes on from.
template <class Real>
struct PlaneState {
    std::size_t steps = 0;
    std::array<std::vector<Real>, 2> displacement{};
    std::array<std::vector<Real>, 2> velocity{};
    std::vector<Real> ghosts{};          ///< what the conditions of ghosts remember
    std::array<double, 4> gone{};        ///< sums of what left() counts
    std::vector<std::uint32_t> bonds{};  ///< which hold, of a bond-based plane
    double broken = 0;
    double released = 0;  ///< over E
    double damped = 0;    ///< sums of what damped() counts
};

template <class Real>
PlaneState<Real> BasicPlane<Real>::state() const {
    PlaneState<Real> state{steps_, u_, v_, {}, gone_, {}, broken_, released_, damped_};
    if (const auto* const bonds = std::get_if<detail::BondForce<Real>>(&force_)) {
        state.bonds = bonds->states().state();
    }
    for (const auto& lines : ghost_lines_) {
        lines.remembered(state.ghosts);
    }
    return state;
}

template <class Real>
void BasicPlane<Real>::resume(const PlaneState<Real>& state) {
    std::size_t remembered = 0;
    for (const auto& lines : ghost_lines_) {
        remembered += lines.remembered_size();
    }
    if (state.ghosts.size() != remembered) {
        throw std::invalid_argument("the state of a plane with other sides");
    }
    for (const std::size_t a : {0U, 1U}) {
        if (state.displacement[a].size() != u_[a].size() ||
            state.velocity[a].size() != v_[a].size()) {
            throw std::invalid_argument("the state of a plane of another size");
        }
    }
    auto* const bonds = std::get_if<detail::BondForce<Real>>(&force_);
    if (state.bonds.size() != (bonds == nullptr ? 0 : bonds->states().state_size())) {
        throw std::invalid_argument("the state of a plane with other bonds");
    }
    if (bonds != nullptr) {
        bonds->states().resume(state.bonds);
    }
    broken_ = state.broken;
    released_ = state.released;
    damped_ = state.damped;
    steps_ = state.steps;
    u_ = state.displacement;
    v_ = state.velocity;
    gone_ = state.gone;
    std::span<const Real> ghosts = state.ghosts;
    for (auto& lines : ghost_lines_) {
        lines.remember(ghosts);
    }
}

}  // namespace nmbc
