// SPDX-License-Identifier: MIT
/// The chain of atoms with springs between neighbours, (56) of Nicely 2018.
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"

namespace nmbcgen {

Model chain1d(unsigned horizon, std::span<const Rational> /*weights: there is one bond*/) {
    if (horizon != 1) {
        throw NoSuchModel("the chain of atoms has bonds to next neighbours only: horizon 1");
    }
    return {.description = "chain of atoms, next neighbours",
            .source = "Nicely 2018: chain (56)",
            .energy = {{EnergyPart::strain, constant(1), {0, -1, 1}}},
            .symbol = {},
            .damping = {}};
}

}  // namespace nmbcgen
