// SPDX-License-Identifier: GPL-2.0-or-later
/// System (49) with everything symbolic, for those who set match() beside algebra systems.
#pragma once

#include <memory>
#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

/// (49) of order N with symbols for a_1, a_3, .. and dX, without a lattice.
class SymbolicSystem {
  public:
    explicit SymbolicSystem(unsigned order);
    ~SymbolicSystem();
    SymbolicSystem(const SymbolicSystem&) = delete;
    SymbolicSystem& operator=(const SymbolicSystem&) = delete;

    /// Solves it by match(), anew each time.
    void solve();

    /// c_0 .. c_N, b_0 .. b_N of the solution at a_k = (k^2 mod 11 + 1)/(k + 2), dX = 3/7: the
    /// numbers of tools/bench/solve_49.mac, .gp and .py.
    std::vector<Rational> values() const;

  private:
    struct Symbols;
    std::unique_ptr<Symbols> symbols_;
};

}  // namespace nmbcgen
