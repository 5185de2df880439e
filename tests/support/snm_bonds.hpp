// SPDX-License-Identifier: MIT
/// The chain of bonds of SNM 2023.
#pragma once

#include <cstddef>
#include <nmbc/lattice.hpp>
#include <vector>

namespace nmbcgen::test {

/// (2): beta_k/(m k^2), beta_1 = 3/2 as corrected, and the last one half.
inline nmbc::Lattice snm_bonds(std::size_t horizon) {
    nmbc::Lattice lattice;
    lattice.symbol.resize(horizon + 1);
    for (std::size_t k = 1; k <= horizon; ++k) {
        const double beta = (k == horizon ? 0.5 : 1) + (k == 1 ? 0.5 : 0);
        const double weight = beta / double(horizon * k * k);
        lattice.symbol[k] = -weight;
        lattice.symbol[0] += 2 * weight;
        std::vector<double> stencil(2 * horizon + 1);
        stencil[horizon] = -1;
        stencil[horizon + k] = 1;
        lattice.energy.push_back({nmbc::EnergyPart::strain, weight, stencil});
    }
    return lattice;
}

}  // namespace nmbcgen::test
