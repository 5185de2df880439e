// SPDX-License-Identifier: MIT
#include "generator/stability/merging_waves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/dense/decompositions.hpp"
#include "generator/stability/band_search.hpp"
#include "generator/stability/polynomial_roots.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// sum_m f_m T_m(X), or with `second` sum_m f_m U_m(X).
MatrixXd chebyshev_sum(const std::vector<double>& f, const MatrixXd& X, bool second = false) {
    MatrixXd before = MatrixXd::Identity(X.rows(), X.cols());
    MatrixXd now = second ? MatrixXd(2 * X) : X;
    MatrixXd sum = MatrixXd::Zero(X.rows(), X.cols());
    for (const double coefficient : f) {
        sum += coefficient * before;
        before = std::exchange(now, MatrixXd(2 * X * now - before));
    }
    return sum;
}

/// C~^2, B~^2 and T = C~ B~/sin xi by Chebyshev's polynomials, of the second kind for T.
struct Squares {
    std::vector<double> of_C;
    std::vector<double> of_B;
    std::vector<double> product;

    explicit Squares(const HalfSpace& h)
        : of_C((h.c.size() - 1) * std::size_t(h.stride) + 1), of_B(of_C), product(of_C) {
        for (std::size_t j = 0; j < h.c.size(); ++j) {
            for (std::size_t l = 0; l < h.c.size(); ++l) {
                const bool ascending = j >= l;
                const std::size_t apart = (ascending ? j - l : l - j) * std::size_t(h.stride);
                of_C[apart] += h.c[j] * h.c[l];
                of_B[apart] += h.b[j] * h.b[l];
                if (apart > 0) {  // C conj(B) = -i C~ B~
                    product[apart - 1] -= (ascending ? 1 : -1) * h.c[j] * h.b[l];
                }
            }
        }
    }
};

/// The cosines of the waves that travel, ascending.
using Points = std::vector<double>;

/// The forms of wave_grade.hpp as matrices, at some waves; those close to each other are a cluster.
class Forms {
  public:
    Forms(const Squares& squares, const Points& points, double seen_squared)
        : squares_(squares),
          points_(points),
          seen_squared_(seen_squared),
          size_(Index(points.size())),
          one_(MatrixXd::Identity(size_, size_)),
          Z_(bidiagonal(0, size_)) {}

    bool is_contractive() const {
        const Index of_q = (size_ - 1) / 2 + 1;
        const MatrixXd T = chebyshev_sum(squares_.product, Z_, true);
        const MatrixXd mixed =
            seen_squared_ * chebyshev_sum(squares_.of_C, Z_) + chebyshev_sum(squares_.of_B, Z_);
        const double seen = std::sqrt(seen_squared_);
        MatrixXd form = MatrixXd::Zero(size_, size_);
        form.topLeftCorner(of_q, of_q) = hankel(seen * p() * T, of_q, of_q);
        form.bottomRightCorner(size_ - of_q, size_ - of_q) =
            hankel(seen * q() * T, size_ - of_q, size_ - of_q);
        form.bottomLeftCorner(size_ - of_q, of_q) = hankel(-mixed / 2, size_ - of_q, of_q);
        return is_positive(form, mixed);
    }

    bool is_paired() const {
        const Index of_q = (size_ - 1) / 2 + 1;
        const MatrixXd weighted = chebyshev_sum(squares_.product, Z_, true) * weights();
        return is_positive(hankel(p() * weighted, of_q, of_q), weighted) &&
               is_positive(hankel(q() * weighted, size_ - of_q, size_ - of_q), weighted);
    }

  private:
    bool even() const { return size_ % 2 == 0; }
    MatrixXd p() const { return even() ? MatrixXd(one_ + Z_) : one_; }
    MatrixXd q() const { return even() ? MatrixXd(one_ - Z_) : MatrixXd(one_ - Z_ * Z_); }

    MatrixXd bidiagonal(Index first, Index size) const {
        MatrixXd matrix = MatrixXd::Zero(size, size);
        for (Index i = 0; i < size; ++i) {
            matrix(i, i) = points_[std::size_t(first + i)];
        }
        matrix.diagonal(1).setOnes();
        return matrix;
    }

    /// [x_1 .. x_m] f Z^{i+k}
    MatrixXd hankel(MatrixXd f, Index rows, Index columns) const {
        MatrixXd matrix(rows, columns);
        for (Index power = 0; power < rows + columns - 1; ++power) {
            for (Index i = std::max<Index>(0, power - columns + 1); i <= std::min(power, rows - 1);
                 ++i) {
                matrix(i, power - i) = f(0, size_ - 1);
            }
            f *= Z_;
        }
        return matrix;
    }

    /// h = 1/max(C~^2, B~^2/Omega^2), of which in each cluster one is the greater one.
    MatrixXd weights() const {
        constexpr double close = 0.01;
        MatrixXd h = MatrixXd::Zero(size_, size_);
        std::vector<Index> cluster(points_.size());
        for (Index first = 0, next = 0; first < size_; first = next) {
            for (next = first + 1; next < size_ && at(next) - at(next - 1) < close; ++next) {
            }
            const MatrixXd Z = bidiagonal(first, next - first);
            const MatrixXd of_C = chebyshev_sum(squares_.of_C, Z);
            const MatrixXd of_B = chebyshev_sum(squares_.of_B, Z) / seen_squared_;
            h.block(first, first, next - first, next - first) =
                inverse_of(of_C(0, 0) > of_B(0, 0) ? of_C : of_B);
            std::fill_n(cluster.begin() + first, next - first, first);
        }
        for (Index order = 1; order < size_; ++order) {
            for (Index i = 0; i + order < size_; ++i) {
                const Index k = i + order;
                if (cluster[std::size_t(i)] != cluster[std::size_t(k)]) {
                    h(i, k) = (h(i + 1, k) - h(i, k - 1)) / (at(k) - at(i));
                }
            }
        }
        return h;
    }

    double at(Index i) const { return points_[std::size_t(i)]; }

    /// Forms of NMBC1 are 0 but for roundings, which are as large as those of what they are made
    /// of.
    static bool is_positive(const MatrixXd& form, const MatrixXd& made_of) {
        constexpr double roundings = 1e-9;
        return form.size() == 0 ||
               symmetric_eigenvalues(form).minCoeff() >= -roundings * made_of.cwiseAbs().maxCoeff();
    }

    const Squares& squares_;
    const Points& points_;
    double seen_squared_;
    Index size_;
    MatrixXd one_;
    MatrixXd Z_;
};

/// omega^2 as a function of x = cos xi, cut where it turns.
class Band {
  public:
    explicit Band(const HalfSpace& h) : f_(h.symbol_in_cosine), turns_{{-1, 0}, {1, 0}} {
        for (const auto& x : polynomial_roots(derivative(f_))) {
            // as in critical_frequencies()
            if (std::abs(x.imag()) < 1e-7 && std::abs(x.real()) < 1) {
                turns_.push_back({x.real(), 0});
            }
        }
        for (Turn& turn : turns_) {
            turn.square = value(turn.x);
        }
        std::ranges::sort(turns_, {}, &Turn::x);
    }

    /// How many extrema are so close to it.
    std::size_t turns_within(double distance, double square) const {
        return std::size_t(std::ranges::count_if(
            turns_, [&](const Turn& turn) { return std::abs(turn.square - square) <= distance; }));
    }

    /// The waves of a frequency. Of extrema within `unknown` of it maxima are taken to be above it,
    /// and minima below it.
    Points waves_at(double square, double unknown) const {
        Points waves;
        for (std::size_t i = 0; i + 1 < turns_.size(); ++i) {
            if (is_above(i, square, unknown) != is_above(i + 1, square, unknown)) {
                waves.push_back(where(i, square));
            }
        }
        return waves;
    }

  private:
    struct Turn {
        double x;
        double square;
    };

    double value(double x) const { return evaluate_with_slope(f_, x).value; }

    bool is_above(std::size_t turn, double square, double unknown) const {
        const double above = turns_[turn].square - square;
        if (std::abs(above) > unknown) {
            return above > 0;
        }
        // maxima and minima by turns, of which x = 1 is the last, with omega = 0
        return (turns_.size() - turn) % 2 == 0;
    }

    /// By bisection.
    double where(std::size_t turn, double square) const {
        double left = turns_[turn].x;
        double right = turns_[turn + 1].x;
        const bool falls = turns_[turn].square > turns_[turn + 1].square;
        constexpr int halves = 50;
        for (int half = 0; half < halves; ++half) {
            const double middle = left + (right - left) / 2;
            ((value(middle) > square) == falls ? left : right) = middle;
        }
        return left;
    }

    std::vector<double> f_;
    std::vector<Turn> turns_;
};

}  // namespace

NarrowPieces grade_of_narrow_pieces(const HalfSpace& half_space,
                                    const std::vector<double>& critical) {
    const double top = critical.back();
    NarrowPieces pieces;
    for (std::size_t i = 0; i + 1 < critical.size() && pieces.grade != Grade::none; ++i) {
        const double low = critical[i];
        const double high = critical[i + 1];
        const double square = low * high;
        const double slowed = 1 - square * half_space.time_step * half_space.time_step / 4;
        if (low == 0 || high - low > narrowest_piece * top || !(slowed > 0)) {
            continue;
        }
        constexpr double roundings = 1e-14;
        const bool blurred = high - low < roundings * top;
        const double unknown = blurred ? 2 * roundings * top * top : 0;
        const Band band(half_space);
        if (blurred && band.turns_within(unknown, square) < 2) {
            continue;  // a zero of B or C and an extremum in one: nothing lies between them
        }
        const Points waves = band.waves_at(square, unknown);
        if (waves.empty()) {
            continue;
        }
        const Squares squares(half_space);
        const Forms forms(squares, waves, square / slowed);
        if (!forms.is_contractive()) {
            pieces = {forms.is_paired() ? Grade::paired : Grade::none, std::sqrt(square)};
        }
    }
    return pieces;
}

}  // namespace nmbcgen
