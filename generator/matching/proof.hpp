// SPDX-License-Identifier: GPL-2.0-or-later
/// Proof of a finished table, from its own exact data: no algebra system, no memory of how the
/// table was made.
#pragma once

#include <string>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// Establishes, exactly and identically in G, that
///   - the symbol is the one that follows from the energy,
///   - tau sigma is tau times the symbol of the stabilisation at G = 1 (not at a fixed G = 0, where
///     its weight is lost), and empty where tau = 0,
///   - a_1 = 1 (the root of omega^2 that (47) means: a wave coming in is one with +omega),
///   - s = sum a_k x^k solves s^2 + tau sigma s + omega^2 = 0 as a power series in x = i xi
///     through x^{2N+2} (47), or its like in time steps (taylor.hpp),
///   - the residual of (49) vanishes in every row k = 0 .. 2N that is not given to matching points,
///     and c_0 = 1,
///   - at matching points it vanishes but for roundings (points_proof.hpp),
///   - C(1) is not zero, and every rational function is in its normal form.
/// Returns the sentence a table carries about it. Throws std::logic_error naming what fails.
std::string prove(const Table& table);

/// The two of these that are about a_k, from the table's model, a_k and time step.
void prove_taylor(const Table& table);

}  // namespace nmbcgen
