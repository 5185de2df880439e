// SPDX-License-Identifier: MIT
/// Divided differences f[x_1 .. x_m] as functions of a matrix (Opitz 1964): with x_1 .. x_m on the
/// diagonal of Z and ones above it, f(Z) is upper triangular and its entry (i, k) is f[x_i .. x_k].
/// Points may coincide: then they are derivatives.
#pragma once

#include <optional>

#include "generator/enclosures/interval.hpp"

namespace nmbcgen {

class Triangular {
  public:
    /// Of a number times the identity.
    Triangular(std::size_t size, const Interval& diagonal);

    /// f(Z) of these points, closely enclosed where any two are apart or in one and the same
    /// interval, next to each other then.
    static Triangular of(const EnclosedPolynomial& f, const std::vector<Interval>& points);

    static Triangular of(const Expansion& f, const std::vector<Interval>& points);

    /// Z itself.
    static Triangular of(const std::vector<Interval>& points);

    /// f[x_1 .. x_m]
    const Interval& corner() const { return at(0, size_ - 1); }

    friend Triangular operator*(const Triangular& left, const Triangular& right);
    friend Triangular operator+(Triangular left, const Triangular& right);
    friend Triangular operator*(const Interval& factor, Triangular matrix);

    /// Nothing where a number on the diagonal may be 0.
    std::optional<Triangular> inverse() const;

  private:
    const Interval& at(std::size_t row, std::size_t column) const {
        return entries_[row * size_ + column];
    }
    Interval& at(std::size_t row, std::size_t column) { return entries_[row * size_ + column]; }

    /// To what it is by another way, too.
    void narrow(std::size_t row, std::size_t column, const Interval& also) {
        at(row, column) = intersect(at(row, column), also);
    }

    std::size_t size_;
    std::vector<Interval> entries_;
};

/// Whether every symmetric matrix in the enclosure (row by row, its lower triangle counts) is
/// positive semidefinite, by Cholesky's pivots, of which one may be exactly 0 with its column.
bool is_positive(std::vector<std::vector<Interval>> matrix);

}  // namespace nmbcgen
