// SPDX-License-Identifier: MIT
#include "generator/bonds/square_bonds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/exact/echelon.hpp"
#include "generator/exact/rational.hpp"
#include "generator/families/bond_lattice.hpp"

namespace nmbcgen {
namespace {

/// The mean of k sin(i k) on 0 .. pi.
Rational mean_of_sine(int i) {
    return i == 0 ? Rational(0) : Rational(i % 2 == 0 ? -1 : 1) / i;
}

/// (1 - cos k.b) b.T b over the zone, T = V_S^2 k^2 I + (V_P^2 - V_S^2) k k^T: factors of 1, pi^2.
std::array<Rational, 2> wanted_along(const BondClass& bond) {
    const auto [i, j] = bond;
    const Rational extra = squared_speeds[0] - squared_speeds[1];
    const Rational length = i * i + j * j;
    // b.T b = f_x k_x^2 + f_y k_y^2 + f_xy k_x k_y
    const Rational f_x = squared_speeds[1] * length + extra * (i * i);
    const Rational f_y = squared_speeds[1] * length + extra * (j * j);
    const Rational f_xy = 2 * extra * (i * j);
    std::array<Rational, 2> mean{0, (f_x + f_y) / 3};
    // cos k.b = cos i k_x cos j k_y - sin i k_x sin j k_y
    for (const std::size_t power : {0U, 1U}) {
        mean[power] -= j == 0 ? f_x * mean_of_square_times_cosine(i)[power] : Rational(0);
        mean[power] -= i == 0 ? f_y * mean_of_square_times_cosine(j)[power] : Rational(0);
    }
    mean[0] += f_xy * mean_of_sine(i) * mean_of_sine(j);
    return mean;
}

/// The least squares of weights w, D = sum over bonds of w b b^T (1 - cos k.b): gram w = wanted but
/// for multipliers of the two speeds.
struct Quadrature {
    Rows<Rational> gram;
    std::vector<std::array<Rational, 2>> wanted;  ///< factors of 1 and pi^2
    std::array<std::vector<Rational>, 2> speeds;  ///< sum speeds[.] w = V_P^2, V_S^2
};

Quadrature quadrature_of(const std::vector<BondClass>& classes) {
    const std::size_t count = classes.size();
    Quadrature all;
    all.gram.assign(count, std::vector<Rational>(count));
    all.wanted.resize(count);
    for (std::vector<Rational>& speed : all.speeds) {
        speed.resize(count);
    }
    for (std::size_t a = 0; a < count; ++a) {
        const std::array<Rational, 2> speeds = speeds_of_unit_weight(classes[a]);
        all.speeds[0][a] = speeds[0];
        all.speeds[1][a] = speeds[1];
        for (const auto& [i, j] : members(classes[a])) {
            const std::array<Rational, 2> wanted = wanted_along({i, j});
            all.wanted[a][0] += wanted[0];
            all.wanted[a][1] += wanted[1];
            for (std::size_t b = 0; b < count; ++b) {
                for (const auto& [x, y] : members(classes[b])) {
                    const bool is_same = (x == i && y == j) || (x == -i && y == -j);
                    const int inner = i * x + j * y;
                    all.gram[a][b] += inner * inner * (is_same ? Rational(3, 2) : Rational(1));
                }
            }
        }
    }
    return all;
}

/// The optimum without a bound, in closed form.
SquareBonds unbounded(unsigned horizon, const std::vector<BondClass>& classes) {
    const Quadrature all = quadrature_of(classes);
    const std::size_t count = classes.size();
    Rows<Rational> rows;
    for (std::size_t a = 0; a < count; ++a) {
        std::vector<Rational> row = all.gram[a];
        row.insert(row.end(),
                   {all.speeds[0][a], all.speeds[1][a], all.wanted[a][0], all.wanted[a][1]});
        rows.push_back(row);
    }
    for (const std::size_t speed : {0U, 1U}) {
        std::vector<Rational> row = all.speeds[speed];
        row.insert(row.end(), {0, 0, squared_speeds[speed], 0});
        rows.push_back(row);
    }
    if (reduce(rows, count + 2, nonzero).size() < count + 2) {
        throw std::logic_error("singular equations of bonds");
    }
    SquareBonds bonds{classes, {}, {}};
    for (std::size_t a = 0; a < count; ++a) {
        const std::array<Quadratic, 2> factors{rows[a][count + 2], rows[a][count + 3]};
        bonds.alpha.push_back(coefficient_of_weight(horizon, classes[a], factors));
        bonds.weights.push_back(double(weight_of(factors)));
    }
    return bonds;
}

/// The least squares in numbers, where some of the weights are at their bounds.
template <class T>
class BoundedSquares {
  public:
    BoundedSquares(const Quadrature& all, std::vector<T> bounds) : bounds_(std::move(bounds)) {
        const T square_of_pi(pi() * pi());
        for (std::size_t a = 0; a < count(); ++a) {
            std::vector<T> row;
            for (const Rational& entry : all.gram[a]) {
                row.push_back(T(entry));
            }
            gram_.push_back(row);
            wanted_.push_back(T(all.wanted[a][0]) + T(all.wanted[a][1]) * square_of_pi);
            speeds_.push_back({T(all.speeds[0][a]), T(all.speeds[1][a])});
        }
    }

    std::size_t count() const { return bounds_.size(); }

    /// The optimum with these bonds (bits) at their bounds, where it keeps all bounds and no
    /// multiplier of one is negative, up to roundings; empty where it does not.
    std::vector<T> optimum(std::size_t at_bound, const T& roundings) const {
        Rows<T> rows = equations(at_bound);
        const auto larger = [&roundings](const T& candidate, const T& best) {
            using std::abs;
            return abs(candidate) > abs(best) && abs(candidate) > roundings;
        };
        if (reduce(rows, count() + 2, larger).size() < count() + 2) {
            return {};
        }
        std::vector<T> weights;
        for (std::size_t a = 0; a < count(); ++a) {
            weights.push_back(rows[a].back());
        }
        for (std::size_t a = 0; a < count(); ++a) {
            T multiplier = -wanted_[a];
            for (std::size_t b = 0; b < count(); ++b) {
                multiplier += gram_[a][b] * weights[b];
            }
            for (const std::size_t speed : {0U, 1U}) {
                multiplier += speeds_[a][speed] * rows[count() + speed].back();
            }
            if (weights[a] < bounds_[a] - roundings || multiplier < -roundings) {
                return {};
            }
        }
        return weights;
    }

  private:
    Rows<T> equations(std::size_t at_bound) const {
        Rows<T> rows;
        for (std::size_t a = 0; a < count(); ++a) {
            std::vector<T> row(count() + 3);
            if ((at_bound >> a & 1U) != 0) {
                row[a] = 1;
                row.back() = bounds_[a];
            } else {
                std::ranges::copy(gram_[a], row.begin());
                row[count()] = speeds_[a][0];
                row[count() + 1] = speeds_[a][1];
                row.back() = wanted_[a];
            }
            rows.push_back(row);
        }
        for (const std::size_t speed : {0U, 1U}) {
            std::vector<T> row(count() + 3);
            for (std::size_t a = 0; a < count(); ++a) {
                row[a] = speeds_[a][speed];
            }
            row.back() = T(squared_speeds[speed]);
            rows.push_back(row);
        }
        return rows;
    }

    std::vector<T> bounds_;
    Rows<T> gram_{};
    std::vector<T> wanted_{};
    std::vector<std::array<T, 2>> speeds_{};
};

/// What the bounds leave of the squared speeds has to be made of bonds with weights >= 0: each
/// makes at most as much of V_S^2 as of V_P^2, (1, 0) none of it and (1, 1) as much.
void require_speeds_within(const Quadrature& all, const std::vector<Real>& bounds,
                           const Rational& bound) {
    std::array<Real, 2> left{Real(squared_speeds[0]), Real(squared_speeds[1])};
    for (const std::size_t speed : {0U, 1U}) {
        for (std::size_t a = 0; a < bounds.size(); ++a) {
            left[speed] -= Real(all.speeds[speed][a]) * bounds[a];
        }
    }
    if (left[1] < 0 || left[0] < left[1]) {
        throw NoSuchBonds(
            fmt::format("no coefficients of {} or more have the speeds of long waves of the solid",
                        to_string(bound)));
    }
}

/// Every set of bonds at the bound is tried, in doubles first: the optimum is one of them.
SquareBonds bounded(unsigned horizon, const std::vector<BondClass>& classes,
                    const Rational& bound) {
    const Quadrature all = quadrature_of(classes);
    std::vector<Real> bounds;
    std::vector<double> rounded;
    for (const BondClass& bond : classes) {
        bounds.push_back(Real(bound) / alpha_of_unit_weight(horizon, bond));
        rounded.push_back(double(bounds.back()));
    }
    require_speeds_within(all, bounds, bound);
    const BoundedSquares<double> doubles(all, rounded);
    const BoundedSquares<Real> digits(all, bounds);
    for (std::size_t at_bound = 0; at_bound >> classes.size() == 0; ++at_bound) {
        if (doubles.optimum(at_bound, 1e-9).empty()) {
            continue;
        }
        const std::vector<Real> weights = digits.optimum(at_bound, Real("1e-100"));
        if (weights.empty()) {
            continue;
        }
        SquareBonds bonds{classes, {}, {}};
        for (std::size_t a = 0; a < classes.size(); ++a) {
            const bool is_at_bound = (at_bound >> a & 1U) != 0;
            bonds.alpha.push_back(
                is_at_bound
                    ? rational_coefficient(bound)
                    : BondCoefficient{
                          double(weights[a] * alpha_of_unit_weight(horizon, classes[a])), {}});
            bonds.weights.push_back(double(is_at_bound ? bounds[a] : weights[a]));
        }
        return bonds;
    }
    throw std::logic_error("no optimum of bounded bonds was found");
}

}  // namespace

SquareBonds square_bonds(unsigned horizon, const std::optional<Rational>& bound) {
    const std::vector<BondClass> classes = square_bond_classes(horizon);
    return bound ? bounded(horizon, classes, *bound) : unbounded(horizon, classes);
}

SquareBonds given_square_bonds(unsigned horizon, const std::vector<Rational>& alpha) {
    SquareBonds bonds{square_bond_classes(horizon), {}, {}};
    if (alpha.size() != bonds.classes.size()) {
        throw std::invalid_argument(fmt::format("{} coefficients, where horizon {} has {} classes",
                                                alpha.size(), horizon, bonds.classes.size()));
    }
    for (std::size_t a = 0; a < alpha.size(); ++a) {
        bonds.alpha.push_back(rational_coefficient(alpha[a]));
        bonds.weights.push_back(
            double(Real(alpha[a]) / alpha_of_unit_weight(horizon, bonds.classes[a])));
    }
    return bonds;
}

SquareFigures figures_of(const SquareBonds& bonds) {
    std::vector<Offset> classes;
    for (const auto& [i, j] : bonds.classes) {
        classes.push_back({i, j, 0});
    }
    const BondLattice lattice(classes, bonds.weights);
    const double P = nearest_double(squared_speeds[0]);
    const double S = nearest_double(squared_speeds[1]);
    SquareFigures figures;
    for (const std::size_t i : {0U, 1U}) {
        const auto [fast, slow] =
            lattice.of_long_waves(i == 0 ? 0 : std::numbers::pi / 4).eigenvalues();
        figures.speed_P[i] = std::sqrt(fast / P);
        figures.speed_S[i] = std::sqrt(slow / S);
    }
    for (std::size_t i = 0; i < listed_wave_numbers.size(); ++i) {
        constexpr int angles = 90;
        const double xi = listed_wave_numbers[i];
        for (int step = 0; step <= angles; ++step) {
            const double angle = std::numbers::pi / 4 * step / angles;
            const auto [fast, slow] =
                lattice.at(xi * std::cos(angle), xi * std::sin(angle)).eigenvalues();
            const std::array off{std::abs(std::sqrt(fast / P) / xi - 1),
                                 std::abs(std::sqrt(slow / S) / xi - 1)};
            for (const std::size_t wave : {0U, 1U}) {
                figures.speed_error[i][wave] = std::max(figures.speed_error[i][wave], off[wave]);
            }
        }
    }
    // O to M, M to Y, Y to O.
    constexpr int steps = 4000;
    constexpr double edge = std::numbers::pi;
    for (int i = 0; i < steps; ++i) {
        const double k = (i + 0.5) * edge / steps;
        const auto add = [&](double k_x, double k_y, double length) {
            const auto [fast, slow] = lattice.at(k_x, k_y).eigenvalues();
            const double square = k_x * k_x + k_y * k_y;
            figures.residual +=
                (std::abs(fast - P * square) + std::abs(slow - S * square)) * length * edge / steps;
        };
        add(k, 0, 1);
        add(edge, k, 1);
        add(k, k, std::numbers::sqrt2);
    }
    constexpr int along = 200;
    double largest = 0;
    for (int x = 0; x <= along; ++x) {
        for (int y = 0; y <= x; ++y) {
            largest =
                std::max(largest, lattice.at(x * edge / along, y * edge / along).eigenvalues()[0]);
        }
    }
    figures.largest_frequency = std::sqrt(largest);
    return figures;
}

}  // namespace nmbcgen
