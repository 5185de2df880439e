// SPDX-License-Identifier: MIT
/// The chains that waves along an axis see of a vector model.
#pragma once

#include <stdexcept>

#include "generator/table/vector_model.hpp"

namespace nmbcgen {

/// The waves of this polarisation do not make a chain; what() says why, for people.
struct NoProjection : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// Of P waves (0) or S waves (1).
NoProjection long_waves_do_not_travel(std::size_t polarisation);

/// The model of waves along x in which nodes move in one direction: 0 is x (P), 1 is y (S). Its
/// units are dX = 1 and the speed of its own long waves = 1; its parameter is g. Its symbol is not
/// filled in. Throws NoProjection where the direction is coupled to another one (each off-diagonal
/// entry of the dynamical matrix must vanish identically), where long waves do not travel, and
/// where their speed depends on g.
Model project(const VectorModel& model, std::size_t direction);

/// The square of the speed of long waves along x that move in this direction, in the units of the
/// model, a polynomial in g.
Polynomial speed_squared(const VectorModel& model, std::size_t direction);

}  // namespace nmbcgen
