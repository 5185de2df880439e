// SPDX-License-Identifier: MIT
/// Influence functions: how much a bond counts by its length m dX, m = 1 .. n.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

struct Influence {
    std::string_view name;
    Rational (*weight)(unsigned m, unsigned horizon);  ///< > 0, for 1 <= m <= horizon
};

/// The named ones; the first is the usual one.
std::span<const Influence> influences();

/// w_1 .. w_n of an influence function.
std::vector<Rational> weights_of(const Influence& influence, unsigned horizon);

/// The same influence, of which a factor > 0 says nothing, with |w_1| = 1; empty where all are 1,
/// as Specification has it. No weight is 0.
std::vector<Rational> normalised(std::vector<Rational> weights);

}  // namespace nmbcgen
