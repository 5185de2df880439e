// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/spectral_factor.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace nmbcrun {
namespace {

using Real = long double;
using Factor = std::vector<LongComplex>;
using ComplexMatrix = Eigen::Matrix<LongComplex, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<LongComplex, Eigen::Dynamic, 1>;

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

Real largest(const std::vector<LongComplex>& values) {
    Real result = 0;
    for (const LongComplex& value : values) {
        result = std::max(result, std::abs(value));
    }
    return result;
}

/// sum_i f_i f_{i+m}.
LongComplex correlation(const Factor& f, std::size_t m) {
    LongComplex sum = 0;
    for (std::size_t i = 0; i + m < f.size(); ++i) {
        sum += f[i] * f[i + m];
    }
    return sum;
}

/// The roots in x = (lambda + 1/lambda)/2 of a_0 + 2 sum a_m T_m(x), T_m Chebyshev's: the
/// eigenvalues of its colleague matrix, transposed to be upper Hessenberg.
Vector chebyshev_roots(const std::vector<LongComplex>& a, Eigen::Index degree) {
    const auto at = [&a](Eigen::Index m) { return a[std::size_t(m)]; };
    if (degree == 1) {
        return Vector::Constant(1, -at(0) / (Real(2) * at(1)));
    }
    ComplexMatrix colleague = ComplexMatrix::Zero(degree, degree);
    colleague(1, 0) = 1;
    for (Eigen::Index k = 1; k + 1 < degree; ++k) {
        colleague(k - 1, k) = colleague(k + 1, k) = Real(0.5);
    }
    colleague(degree - 2, degree - 1) = Real(0.5);
    for (Eigen::Index m = 0; m < degree; ++m) {
        colleague(m, degree - 1) -= at(m) / (Real(m == 0 ? 4 : 2) * at(degree));
    }
    Eigen::ComplexSchur<ComplexMatrix> schur(degree);
    schur.computeFromHessenberg(colleague, ComplexMatrix(), false);
    return schur.matrixT().diagonal();
}

/// From the roots: good to the rounding of an eigenvalue problem, whose scale is a_r.
Factor factor_by_roots(const std::vector<LongComplex>& a) {
    const Real negligible = epsilon * largest(a);
    std::size_t degree = a.size() - 1;
    while (degree > 0 && std::abs(a[degree]) <= negligible) {
        --degree;  // a root at lambda = 0
    }
    Factor f(a.size(), LongComplex(0));
    f[0] = 1;
    if (degree > 0) {
        for (const LongComplex& x : chebyshev_roots(a, Eigen::Index(degree))) {
            LongComplex root = std::sqrt((x - Real(1)) * (x + Real(1)));
            if (std::real(std::conj(x) * root) < 0) {
                root = -root;
            }
            const LongComplex decaying = Real(1) / (x + root);
            for (std::size_t i = f.size() - 1; i > 0; --i) {
                f[i] -= decaying * f[i - 1];
            }
        }
    }
    std::size_t best = 0;
    for (std::size_t m = 1; m < a.size(); ++m) {
        if (std::abs(correlation(f, m)) > std::abs(correlation(f, best))) {
            best = m;
        }
    }
    const LongComplex scale = std::sqrt(a[best] / correlation(f, best));
    for (LongComplex& value : f) {
        value *= scale;
    }
    return f;
}

/// Newton's iteration for sum_i f_i f_{i+m} = a_m. Whether the residual came down to rounding.
bool improve(Factor& f, const std::vector<LongComplex>& a) {
    const auto size = Eigen::Index(a.size());
    const Real rounding = epsilon * largest(a);
    Vector residual(size);
    ComplexMatrix jacobian(size, size);
    Real last = std::numeric_limits<Real>::infinity();
    constexpr int most = 30;  // 3 as a rule; more where two roots are about to coalesce on the
                              // circle, where each halves the error only
    for (int iteration = 0; iteration < most; ++iteration) {
        for (std::size_t m = 0; m < a.size(); ++m) {
            residual[Eigen::Index(m)] = a[m] - correlation(f, m);
        }
        const Real size_of_residual = residual.cwiseAbs().maxCoeff();
        const bool is_small = size_of_residual <= Real(a.size()) * 8 * rounding;
        if (size_of_residual <= rounding || (is_small && size_of_residual > last / 4)) {
            return true;
        }
        if (!std::isfinite(size_of_residual)) {
            return false;
        }
        last = size_of_residual;
        jacobian.setZero();
        for (Eigen::Index m = 0; m < size; ++m) {
            for (Eigen::Index i = 0; i + m < size; ++i) {
                jacobian(m, i) += f[std::size_t(i + m)];
                jacobian(m, i + m) += f[std::size_t(i)];
            }
        }
        const Vector change = jacobian.partialPivLu().solve(residual);
        for (std::size_t i = 0; i < f.size(); ++i) {
            f[i] += change[Eigen::Index(i)];
        }
    }
    return false;
}

/// Schur and Cohn: whether every root of sum_i f_i lambda^{r-i} is within the unit circle.
bool decays(Factor f) {
    while (f.size() > 1) {
        const LongComplex ratio = f.back() / f.front();
        if (!(std::abs(ratio) < 1)) {
            return false;
        }
        Factor less(f.size() - 1);
        for (std::size_t i = 0; i < less.size(); ++i) {
            less[i] = f[i] / f[0] - ratio * std::conj(f[f.size() - 1 - i] / f[0]);
        }
        f = std::move(less);
    }
    return true;
}

}  // namespace

const std::vector<LongComplex>& SpectralFactor::find(const std::vector<LongComplex>& a) {
    Factor guess = factor_;
    if (before_.size() == guess.size()) {
        for (std::size_t i = 0; i < guess.size(); ++i) {
            guess[i] = Real(2) * guess[i] - before_[i];
        }
    }
    if (guess.size() != a.size() || !improve(guess, a) || !decays(guess)) {
        guess = factor_by_roots(a);
        factor_.clear();  // its sign may be another one
        if (!improve(guess, a) || !decays(guess)) {
            throw std::invalid_argument(
                "the polynomial of the exact end has a root on the unit circle");
        }
    }
    before_ = std::exchange(factor_, std::move(guess));
    return factor_;
}

}  // namespace nmbcrun
