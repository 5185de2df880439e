// SPDX-License-Identifier: GPL-2.0-or-later
/// A family of lattice models, one per horizon. Everything the project computes follows from a
/// model's symbol, and the symbol from the model's energy, so a new family is one file that
/// states an energy as a sum of squares, and one line in families.cpp.
#pragma once

#include <span>
#include <string_view>

#include "generator/table/table.hpp"

namespace nmbcgen {

struct Family {
    std::string_view name;
    /// The energy, description and source of the model with the given horizon >= 1; the symbol
    /// is filled in by make_model.
    Model (*describe)(unsigned horizon);
};

/// The families there are, in the order they are listed to a user.
std::span<const Family> families();

/// The model of a family at a horizon, its symbol derived from its energy.
/// Throws std::invalid_argument where there is no such family.
Model make_model(std::string_view family, unsigned horizon);

Model nopd1d(unsigned horizon);

}  // namespace nmbcgen
