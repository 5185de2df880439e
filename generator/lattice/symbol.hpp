// SPDX-License-Identifier: MIT
/// The symbol of a lattice model, from its energy.
#pragma once

#include <span>
#include <vector>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// The symbol of an energy: omega^2 = sum over its squares of weight * |stencil(z)|^2, since the
/// equations of motion are u_tt = -d(energy)/du. Throws std::logic_error for an empty energy.
std::vector<Polynomial> symbol_of(std::span<const ExactSquare> energy);

/// Whether omega^2 is above 0 for all 0 < xi <= pi, exactly, of a symbol without G that vanishes at
/// xi = 0.
bool is_positive(const std::vector<Polynomial>& symbol);

/// The symbol of a table's lattice, at the table's G where that is fixed.
std::vector<Polynomial> symbol_of(const Table& table);

}  // namespace nmbcgen
