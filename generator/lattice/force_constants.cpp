// SPDX-License-Identifier: MIT
#include "generator/lattice/force_constants.hpp"

#include <algorithm>

#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

Offset difference(const Offset& to, const Offset& from) {
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

bool is_zero(const PolynomialMatrix& matrix) {
    return std::ranges::all_of(matrix, [](const auto& row) {
        return std::ranges::all_of(row, [](const Polynomial& entry) { return entry.is_zero(); });
    });
}

}  // namespace

ForceConstants force_constants(const VectorModel& model) {
    ForceConstants phi;
    for (const VectorSquare& square : model.energy) {
        for (const VectorTerm& own : square.terms) {
            for (const VectorTerm& other : square.terms) {
                PolynomialMatrix& matrix = phi[difference(other.offset, own.offset)];
                for (std::size_t a = 0; a < model.dimensions; ++a) {
                    for (std::size_t b = 0; b < model.dimensions; ++b) {
                        if (own.factors[a] != 0 && other.factors[b] != 0) {
                            matrix[a][b] +=
                                square.weight * constant(own.factors[a] * other.factors[b]);
                        }
                    }
                }
            }
        }
    }
    std::erase_if(phi, [](const auto& entry) { return is_zero(entry.second); });
    return phi;
}

}  // namespace nmbcgen
