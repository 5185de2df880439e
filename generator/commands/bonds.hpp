// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen bonds: optimised coefficients of the bonds of bond-based lattices.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/bonds/bond_method.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

struct BondsTask {
    unsigned dimension = 1;
    unsigned horizon = 0;
    std::optional<BondMethod> method{};
    std::optional<Rational> bound{};  ///< of bz-ls
    std::vector<Rational> alpha{};    ///< in place of a method; shortest first
};

/// A table for people, or JSON (docs/reference/json-other.md). Throws NoSuchBonds (bonds/
/// square_lattice.hpp).
std::string bonds_text(const BondsTask& task);
std::string bonds_json(const BondsTask& task);

}  // namespace nmbcgen
