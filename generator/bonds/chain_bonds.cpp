// SPDX-License-Identifier: MIT
#include "generator/bonds/chain_bonds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "generator/exact/echelon.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

constexpr std::size_t powers_of_pi = 4;  // of right-hand sides: 1, pi, pi^2, pi^3

/// cos(k pi/n) in exact terms: n = 1, 2, 3, 4, 5 or 6 once the fraction is reduced.
Quadratic exact_cosine(int k, int n) {
    k = std::abs(k) % (2 * n);
    if (k > n) {
        k = 2 * n - k;
    }
    if (2 * k > n) {
        const Quadratic opposite = exact_cosine(n - k, n);
        return Quadratic(-1) * opposite;
    }
    if (k == 0) {
        return 1;
    }
    const Rational half(1, 2);
    const Rational quarter(1, 4);
    if (2 * k == n) {
        return 0;
    }
    if (3 * k == n) {
        return half;
    }
    if (4 * k == n) {
        return {0, half, 2};
    }
    if (6 * k == n) {
        return {0, half, 3};
    }
    if (5 * k == n) {
        return {quarter, quarter, 5};
    }
    if (5 * k == 2 * n) {
        return {-quarter, quarter, 5};
    }
    throw std::logic_error("a cosine that is not quadratic");
}

/// The equations of beta_j = 4 alpha_j/(N^2 j) in a field: the coefficients, then the factors of
/// the powers of pi. cosine(k, n) is cos(k pi/n).
template <class T, class Cosine>
class Equations {
  public:
    Equations(unsigned horizon, Cosine cosine) : bonds_(int(horizon)), cosine_(cosine) {}

    Rows<T> of(BondMethod method) {
        switch (method) {
            case BondMethod::point:
                return points();
            case BondMethod::subdomain:
                return subdomains();
            case BondMethod::galerkin:
                return galerkin();
            case BondMethod::least_squares:
                return least_squares();
            case BondMethod::taylor:
                return taylor();
            case BondMethod::bz_ls:
                break;
        }
        throw std::invalid_argument("not a method for chains");
    }

  private:
    std::vector<T> row(int unknowns) const {
        return std::vector<T>(std::size_t(unknowns) + powers_of_pi);
    }
    T& right(std::vector<T>& row, std::size_t power) const {
        return row[row.size() - powers_of_pi + power];
    }
    static T& at(std::vector<T>& row, int j) { return row[std::size_t(j) - 1]; }

    /// (34), sum j^2 beta_j = 2.
    std::vector<T> long_waves(int unknowns) const {
        std::vector<T> first = row(unknowns);
        for (int j = 1; j <= bonds_; ++j) {
            at(first, j) = T(j * j);
        }
        right(first, 0) = T(2);
        return first;
    }

    Rows<T> points() {
        Rows<T> rows{long_waves(bonds_)};
        const int parts = bonds_ - 1;
        for (int m = 1; m <= parts; ++m) {
            std::vector<T> equation = row(bonds_);
            for (int j = 1; j <= bonds_; ++j) {
                at(equation, j) = T(1);
                at(equation, j) -= cosine_(j * m, parts);
            }
            right(equation, 2) = T(Rational(m * m, parts * parts));
            rows.push_back(equation);
        }
        return rows;
    }

    /// The integrals of R from 0 to xi_m = m pi/(N - 1) vanish. At xi = pi that is sum beta_j =
    /// pi^2/3, which leaves sum beta_j sin(j xi_m)/j = xi_m pi^2/3 - xi_m^3/3 of the others.
    Rows<T> subdomains() {
        Rows<T> rows{long_waves(bonds_)};
        const int parts = bonds_ - 1;
        for (int m = 1; m <= parts; ++m) {
            std::vector<T> equation = row(bonds_);
            for (int j = 1; j <= bonds_; ++j) {
                // sin x = cos(pi/2 - x)
                at(equation, j) = m == parts ? T(1) : T(cosine_(parts - 2 * j * m, 2 * parts));
                if (m < parts) {
                    at(equation, j) /= T(j);
                }
            }
            const Rational part(m, parts);
            right(equation, m == parts ? 2 : 3) =
                T(m == parts ? Rational(1, 3) : Rational((part - part * part * part) / 3));
            rows.push_back(equation);
        }
        return rows;
    }

    /// The mean of (1 - cos k xi) R on 0 .. pi.
    std::vector<T> projected(int k, int unknowns) const {
        std::vector<T> equation = row(unknowns);
        for (int j = 1; j <= bonds_; ++j) {
            at(equation, j) = T(j == k ? Rational(3, 2) : Rational(1));
        }
        right(equation, 0) = T(Rational(k % 2 == 0 ? -2 : 2, k * k));
        right(equation, 2) = T(Rational(1, 3));
        return equation;
    }

    Rows<T> galerkin() const {
        Rows<T> rows{long_waves(bonds_)};
        for (int k = 1; k < bonds_; ++k) {
            rows.push_back(projected(k, bonds_));
        }
        return rows;
    }

    /// With the multiplier of (34) as the last unknown.
    Rows<T> least_squares() const {
        Rows<T> rows{long_waves(bonds_ + 1)};
        for (int k = 1; k <= bonds_; ++k) {
            rows.push_back(projected(k, bonds_ + 1));
            at(rows.back(), bonds_ + 1) = T(k * k);
        }
        return rows;
    }

    /// 1 - cos(j xi) = (j xi)^2/2 - (j xi)^4/24 + ..: the sums of j^{2p} beta_j vanish from p = 2
    /// on.
    Rows<T> taylor() const {
        Rows<T> rows{long_waves(bonds_)};
        for (int p = 2; p <= bonds_; ++p) {
            std::vector<T> equation = row(bonds_);
            for (int j = 1; j <= bonds_; ++j) {
                at(equation, j) = T(Rational(pow(Integer(j), unsigned(2 * p))));
            }
            rows.push_back(equation);
        }
        return rows;
    }

    int bonds_;
    Cosine cosine_;
};

/// The coefficients, as the factors of the powers of pi.
template <class T, class Cosine, class Better>
std::vector<std::vector<T>> solved(BondMethod method, unsigned horizon, Cosine cosine,
                                   Better better) {
    Rows<T> rows = Equations<T, Cosine>(horizon, cosine).of(method);
    const std::size_t unknowns = rows.size();
    if (reduce(rows, unknowns, better).size() < unknowns) {
        throw std::logic_error("singular equations of bonds");
    }
    std::vector<std::vector<T>> alpha;
    for (unsigned j = 1; j <= horizon; ++j) {
        std::vector<T> powers(rows[j - 1].begin() + std::ptrdiff_t(unknowns), rows[j - 1].end());
        for (T& factor : powers) {
            factor *= T(Rational(horizon * horizon * j, 4));
        }
        alpha.push_back(powers);
    }
    return alpha;
}

bool is_exact(BondMethod method, unsigned horizon) {
    const unsigned parts = horizon - 1;
    return (method != BondMethod::point && method != BondMethod::subdomain) || parts < 5 ||
           parts == 6 || (method == BondMethod::point && parts == 5);
}

constexpr int steps = 20'000;

double omega_squared(std::span<const double> alpha, double xi) {
    const auto bonds = double(alpha.size());
    double sum = 0;
    for (std::size_t j = 1; j <= alpha.size(); ++j) {
        sum += 4 * alpha[j - 1] / (bonds * bonds * double(j)) * (1 - std::cos(double(j) * xi));
    }
    return sum;
}

}  // namespace

BondCoefficient rational_coefficient(const Rational& alpha) {
    return {nearest_double(alpha), PiPolynomial{Quadratic(alpha)}};
}

std::vector<BondCoefficient> chain_bonds(BondMethod method, unsigned horizon) {
    if (horizon < 1 || horizon > most_chain_bonds) {
        throw std::invalid_argument("no such number of bonds");
    }
    std::vector<BondCoefficient> coefficients;
    if (is_exact(method, horizon)) {
        for (const PiPolynomial& alpha :
             solved<Quadratic>(method, horizon, exact_cosine, nonzero)) {
            coefficients.push_back({double(value_of(alpha)), alpha});
        }
        return coefficients;
    }
    const auto cosine = [](int k, int n) { return Real(cos(Real(k) * pi() / n)); };
    const auto larger = [](const Real& candidate, const Real& best) {
        const Real zero("1e-90");  // 30 digits above the roundings
        return abs(candidate) > abs(best) && abs(candidate) > zero;
    };
    for (const std::vector<Real>& powers : solved<Real>(method, horizon, cosine, larger)) {
        const Real value = powers[0] + pi() * (powers[1] + pi() * (powers[2] + pi() * powers[3]));
        coefficients.push_back({double(value), std::nullopt});
    }
    return coefficients;
}

double residual_of_chain(std::span<const double> alpha) {
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double xi = (i + 0.5) * std::numbers::pi / steps;
        sum += std::abs(omega_squared(alpha, xi) - xi * xi);
    }
    return sum * std::numbers::pi / steps;
}

double speed_error_of_chain(std::span<const double> alpha, double xi) {
    return std::abs(std::sqrt(omega_squared(alpha, xi)) / xi - 1);
}

ChainBand band_of_chain(std::span<const double> alpha) {
    ChainBand band{.least_squared_speed = HUGE_VAL};
    double largest = 0;
    for (int i = 1; i <= steps; ++i) {
        const double xi = i * std::numbers::pi / steps;
        const double square = omega_squared(alpha, xi);
        band.least_squared_speed = std::min(band.least_squared_speed, square / (xi * xi));
        largest = std::max(largest, square);
    }
    band.largest_frequency = std::sqrt(largest);
    return band;
}

}  // namespace nmbcgen
