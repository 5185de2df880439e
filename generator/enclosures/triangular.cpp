// SPDX-License-Identifier: MIT
#include "generator/enclosures/triangular.hpp"

#include <algorithm>

namespace nmbcgen {
namespace {

/// In powers of x - centre.
EnclosedPolynomial shifted(EnclosedPolynomial f, double centre) {
    for (std::size_t done = 0; done + 1 < f.size(); ++done) {
        for (std::size_t i = f.size() - 1; i-- > done;) {
            f[i] += centre * f[i + 1];
        }
    }
    return f;
}

/// The derivative of this order over its factorial.
Interval taylor_coefficient(const EnclosedPolynomial& f, std::size_t order, const Interval& x) {
    Interval sum = 0;
    for (std::size_t i = f.size(); i-- > order;) {
        double choices = 1;  // i over order
        for (std::size_t l = 0; l < order; ++l) {
            choices = choices * double(i - l) / double(l + 1);
        }
        sum = sum * x + choices * f[i];
    }
    return sum;
}

}  // namespace

Triangular::Triangular(std::size_t size, const Interval& diagonal)
    : size_(size), entries_(size * size, Interval(0)) {
    for (std::size_t i = 0; i < size; ++i) {
        at(i, i) = diagonal;
    }
}

Triangular Triangular::of(const std::vector<Interval>& points) {
    Triangular Z(points.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        Z.at(i, i) = points[i];
        if (i + 1 < points.size()) {
            Z.at(i, i + 1) = 1;
        }
    }
    return Z;
}

Triangular Triangular::of(const EnclosedPolynomial& f, const std::vector<Interval>& points) {
    const std::size_t size = points.size();
    // Horner's rule is good for points near each other, quotients of differences for others.
    Triangular result(size, 0);
    const Triangular Z = of(points);
    for (std::size_t i = f.size(); i-- > 0;) {
        result = result * Z + Triangular(size, f[i]);
    }
    for (std::size_t i = 0; i < size; ++i) {
        const EnclosedPolynomial about = shifted(f, median(points[i]));
        const Interval offset = points[i] - median(points[i]);
        for (std::size_t k = i; k < size && equal(points[i], points[k]); ++k) {
            result.narrow(i, k, taylor_coefficient(about, k - i, offset));
        }
    }
    for (std::size_t order = 1; order < size && order < f.size(); ++order) {
        for (std::size_t i = 0; i + order < size; ++i) {
            const std::size_t k = i + order;
            if (!equal(points[i], points[k])) {
                result.narrow(
                    i, k, (result.at(i + 1, k) - result.at(i, k - 1)) / (points[k] - points[i]));
            }
        }
    }
    return result;
}

Triangular Triangular::of(const Expansion& f, const std::vector<Interval>& points) {
    return f.of([&](const EnclosedPolynomial& part) { return of(part, points); });
}

Triangular operator*(const Triangular& left, const Triangular& right) {
    Triangular product(left.size_, 0);
    for (std::size_t i = 0; i < left.size_; ++i) {
        for (std::size_t k = i; k < left.size_; ++k) {
            for (std::size_t j = i; j <= k; ++j) {
                product.at(i, k) += left.at(i, j) * right.at(j, k);
            }
        }
    }
    return product;
}

Triangular operator+(Triangular left, const Triangular& right) {
    for (std::size_t i = 0; i < left.entries_.size(); ++i) {
        left.entries_[i] += right.entries_[i];
    }
    return left;
}

Triangular operator*(const Interval& factor, Triangular matrix) {
    for (Interval& entry : matrix.entries_) {
        entry *= factor;
    }
    return matrix;
}

std::optional<Triangular> Triangular::inverse() const {
    Triangular result(size_, 0);
    for (std::size_t k = 0; k < size_; ++k) {
        if (zero_in(at(k, k))) {
            return std::nullopt;
        }
        result.at(k, k) = 1.0 / at(k, k);
        for (std::size_t i = k; i-- > 0;) {
            Interval sum = 0;
            for (std::size_t j = i + 1; j <= k; ++j) {
                sum += at(i, j) * result.at(j, k);
            }
            result.at(i, k) = -sum / at(i, i);
        }
    }
    return result;
}

bool is_positive(std::vector<std::vector<Interval>> matrix) {
    const auto is_zero = [](const Interval& x) { return x.lower() == 0 && x.upper() == 0; };
    for (std::size_t p = 0; p < matrix.size(); ++p) {
        const Interval pivot = matrix[p][p];
        if (is_zero(pivot)) {
            for (std::size_t i = p + 1; i < matrix.size(); ++i) {
                if (!is_zero(matrix[i][p])) {
                    return false;
                }
            }
            continue;
        }
        if (!(pivot.lower() > 0)) {
            return false;
        }
        for (std::size_t i = p + 1; i < matrix.size(); ++i) {
            for (std::size_t k = p + 1; k <= i; ++k) {
                matrix[i][k] -=
                    i == k ? square(matrix[i][p]) / pivot : matrix[i][p] * matrix[k][p] / pivot;
            }
        }
    }
    return true;
}

}  // namespace nmbcgen
