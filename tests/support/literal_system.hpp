// SPDX-License-Identifier: GPL-2.0-or-later
/// System (49) as printed, assembled from (50) and (51) and solved without using any of its
/// structure: the second way to every coefficient.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen::test {

template <class Number>
using Matrix = std::vector<std::vector<Number>>;

/// A of (51): lower triangular Toeplitz, entry (i, j) = a_{i-j}.
template <class Number>
Matrix<Number> taylor_matrix(const std::vector<Number>& a, std::size_t order) {
    Matrix<Number> A(2 * order + 1, std::vector<Number>(2 * order + 1, Number(0)));
    for (std::size_t i = 0; i <= 2 * order; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            A[i][j] = a[i - j];
        }
    }
    return A;
}

/// H of (51) with the node spacing dX: h_kj = (j dX)^k / k!.
template <class Number>
Matrix<Number> offset_matrix(const Number& dX, std::size_t order) {
    Matrix<Number> H(2 * order + 1, std::vector<Number>(order + 1, Number(0)));
    for (std::size_t j = 0; j <= order; ++j) {
        Number entry(1);
        for (std::size_t k = 0; k <= 2 * order; ++k) {
            H[k][j] = entry;
            entry = entry * Number(int(j)) * dX / Number(int(k) + 1);
        }
    }
    return H;
}

/// The matrix of (49): [e_1^T z^T; A H, -H], unknowns c_0 .. c_N, b_0 .. b_N.
template <class Number>
Matrix<Number> literal_matrix(const std::vector<Number>& a, const Number& dX, std::size_t order) {
    const auto A = taylor_matrix(a, order);
    const auto H = offset_matrix(dX, order);
    Matrix<Number> M(2 * order + 2, std::vector<Number>(2 * order + 2, Number(0)));
    M[0][0] = Number(1);
    for (std::size_t k = 0; k <= 2 * order; ++k) {
        for (std::size_t j = 0; j <= order; ++j) {
            for (std::size_t i = 0; i <= 2 * order; ++i) {
                M[k + 1][j] = M[k + 1][j] + A[k][i] * H[i][j];
            }
            M[k + 1][order + 1 + j] = Number(0) - H[k][j];
        }
    }
    return M;
}

/// Determinant, and the solution of M x = e_1 where it is not zero, by Gaussian elimination.
struct Elimination {
    Rational determinant = 1;
    std::vector<Rational> solution;
};

inline Elimination eliminate(Matrix<Rational> M) {
    const std::size_t size = M.size();
    Elimination result;
    result.solution.assign(size, Rational(0));
    result.solution[0] = 1;
    for (std::size_t column = 0; column < size; ++column) {
        std::size_t pivot = column;
        while (pivot < size && M[pivot][column] == 0) {
            ++pivot;
        }
        if (pivot == size) {
            return {0, {}};
        }
        if (pivot != column) {
            std::swap(M[pivot], M[column]);
            std::swap(result.solution[pivot], result.solution[column]);
            result.determinant = -result.determinant;
        }
        result.determinant *= M[column][column];
        for (std::size_t row = 0; row < size; ++row) {
            if (row == column || M[row][column] == 0) {
                continue;
            }
            const Rational factor = M[row][column] / M[column][column];
            for (std::size_t k = column; k < size; ++k) {
                M[row][k] -= factor * M[column][k];
            }
            result.solution[row] -= factor * result.solution[column];
        }
    }
    for (std::size_t row = 0; row < size; ++row) {
        result.solution[row] /= M[row][row];
    }
    return result;
}

/// c_0 .. c_N, b_0 .. b_N of (49), or none where the system is singular.
/// a: a_0 .. a_2N at least; dX: stride times node spacing.
inline std::optional<std::vector<Rational>> solve_literally(const std::vector<Rational>& a,
                                                            const Rational& dX, std::size_t order) {
    auto result = eliminate(literal_matrix(a, dX, order));
    if (result.determinant == 0) {
        return std::nullopt;
    }
    return std::move(result.solution);
}

}  // namespace nmbcgen::test
