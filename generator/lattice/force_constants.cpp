// SPDX-License-Identifier: MIT
#include "generator/lattice/force_constants.hpp"

#include <algorithm>
#include <vector>

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

/// A square's factors as whole numbers over a common denominator: sums of their products need no
/// fractions, which families of a hundred bonds would spend seconds on.
struct WholeSquare {
    struct Term {
        Offset offset{};
        std::array<Integer, 3> factors{};
    };
    std::vector<Term> terms;
    Integer denominator = 1;
};

WholeSquare in_whole_numbers(const VectorSquare& square) {
    WholeSquare whole;
    for (const VectorTerm& term : square.terms) {
        for (const Rational& factor : term.factors) {
            whole.denominator = lcm(whole.denominator, Integer(denominator(factor)));
        }
    }
    for (const VectorTerm& term : square.terms) {
        whole.terms.push_back({.offset = term.offset, .factors = {}});
        for (std::size_t a = 0; a < term.factors.size(); ++a) {
            whole.terms.back().factors[a] = numerator(term.factors[a] * whole.denominator);
        }
    }
    return whole;
}

using Products = std::array<std::array<Integer, 3>, 3>;

/// Over pairs of terms, by what they are apart: sums of the products of their factors.
std::map<Offset, Products> correlation(const WholeSquare& square) {
    std::map<Offset, Products> sums;
    for (const auto& own : square.terms) {
        for (const auto& other : square.terms) {
            Products& products = sums[difference(other.offset, own.offset)];
            for (std::size_t a = 0; a < own.factors.size(); ++a) {
                for (std::size_t b = 0; own.factors[a] != 0 && b < other.factors.size(); ++b) {
                    products[a][b] += own.factors[a] * other.factors[b];
                }
            }
        }
    }
    return sums;
}

}  // namespace

ForceConstants force_constants(const VectorModel& model) {
    ForceConstants phi;
    for (const VectorSquare& square : model.energy) {
        const WholeSquare whole = in_whole_numbers(square);
        const Rational scale(1, whole.denominator * whole.denominator);
        for (const auto& [offset, products] : correlation(whole)) {
            PolynomialMatrix& matrix = phi[offset];
            for (std::size_t a = 0; a < model.dimensions; ++a) {
                for (std::size_t b = 0; b < model.dimensions; ++b) {
                    if (products[a][b] != 0) {
                        matrix[a][b] += square.weight * constant(products[a][b] * scale);
                    }
                }
            }
        }
    }
    std::erase_if(phi, [](const auto& entry) { return is_zero(entry.second); });
    return phi;
}

}  // namespace nmbcgen
