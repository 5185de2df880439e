// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen bonds: optimised coefficients of the bonds of bond-based lattices.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/bonds/chain_bonds.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

struct BondsTask {
    unsigned dimension = 1;
    unsigned horizon = 0;
    std::optional<ChainMethod> method{};  ///< of a chain; none: bz-ls, of the square lattice
    std::optional<Rational> bound{};      ///< of bz-ls
    std::vector<Rational> alpha{};        ///< in place of a method; shortest first
};

/// The method of this name; nothing where it is none of a chain's.
std::optional<ChainMethod> chain_method(std::string_view name);

/// "point, subdomain, .."
std::string chain_method_names();

/// A table for people, or JSON (docs/reference/json.md). Throws BoundsNotMet (bonds/
/// square_bonds.hpp).
std::string bonds_text(const BondsTask& task);
std::string bonds_json(const BondsTask& task);

}  // namespace nmbcgen
