// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/proof.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "generator/exact/rational_function.hpp"
#include "generator/lattice/symbol.hpp"
#include "generator/matching/points_proof.hpp"

namespace nmbcgen {
namespace {

void require(bool holds, const std::string& statement) {
    if (!holds) {
        throw std::logic_error("not proved: " + statement);
    }
}

/// base^power / power!
Rational power_over_factorial(const Rational& base, std::size_t power) {
    Rational result = 1;
    for (std::size_t k = 1; k <= power; ++k) {
        result *= base / k;
    }
    return result;
}

/// Coefficient of x^power, x = i xi, in  symbol[0] + sum_{m >= 1} symbol[m] (z^m + z^-m).
template <class Coefficient>
Coefficient moment(const std::vector<Coefficient>& symbol, std::size_t power) {
    Coefficient sum{};
    for (std::size_t m = 0; m < symbol.size(); ++m) {
        const Rational z = power_over_factorial(m, power);
        const Rational inverse = power % 2 == 0 ? z : Rational(-z);
        sum += symbol[m] * Coefficient(m == 0 ? z : Rational(z + inverse));
    }
    return sum;
}

void prove_damping(const Table& table) {
    const Rational& tau = table.specification.damping;
    require(tau >= 0, "damping tau >= 0");
    require((tau == 0) == table.model.damping.empty(), "damping where tau > 0, and only there");
    if (tau == 0) {
        return;
    }
    std::vector<ExactSquare> stabilisation;
    for (const ExactSquare& square : table.model.energy) {
        if (square.part == EnergyPart::stabilisation) {
            stabilisation.push_back(square);
        }
    }
    require(!stabilisation.empty(), "damping needs an energy of stabilisation");
    // The symbol of the stabilisation is G sigma, its weight being proportional to G.
    const Polynomial G(std::vector<Rational>{0, 1});
    const std::vector<Polynomial> expected = symbol_of(stabilisation);
    require(expected.size() == table.model.damping.size(), "damping reaches as far as its energy");
    for (std::size_t m = 0; m < expected.size(); ++m) {
        require(G * constant(table.model.damping[m]) == expected[m] * constant(tau),
                "damping follows from the energy of stabilisation");
    }
}

void prove_residual(const Table& table) {
    const std::size_t order = table.specification.order;
    require(table.c.size() == order + 1 && table.b.size() == order + 1 &&
                table.taylor.size() == 2 * order + 1,
            "sizes of the coefficient lists");
    require(table.c[0] == to_rational_function(constant(1)), "c_0 = 1");

    std::vector<ExactFunction> all = table.c;
    all.insert(all.end(), table.b.begin(), table.b.end());
    const Polynomial common = common_denominator(all);
    std::vector<Polynomial> c;
    std::vector<Polynomial> b;
    Polynomial c_at_one;
    for (std::size_t j = 0; j <= order; ++j) {
        c.push_back(times_multiple(table.c[j], common));
        b.push_back(times_multiple(table.b[j], common));
        c_at_one += c.back();
    }
    for (std::size_t k = 0; k < rows_at_zero(table.specification); ++k) {
        Polynomial row;
        for (std::size_t j = 0; j <= order; ++j) {
            const Rational offset = j * table.specification.stride;
            for (std::size_t i = 1; i <= k; ++i) {
                row += c[j] * table.taylor[i - 1] * constant(power_over_factorial(offset, k - i));
            }
            row -= b[j] * constant(power_over_factorial(offset, k));
        }
        require(row.is_zero(), fmt::format("residual of (49), row {}", k));
    }
    require(!c_at_one.is_zero(), "C(1) is not zero");
}

void prove_normal_form(const std::vector<ExactFunction>& functions) {
    for (const ExactFunction& f : functions) {
        require(reduce(over_rationals(f.numerator), over_rationals(f.denominator)) == f,
                "normal form of a coefficient");
    }
}

}  // namespace

void prove_taylor(const Table& table) {
    const auto& a = table.taylor;  // a[k-1] is a_k
    require(!a.empty() && a.front() == constant(1), "Taylor coefficients: a_1 = c = 1");
    const Rational half_step = table.specification.time_step / 2;
    require(half_step >= 0, "time step >= 0");
    const std::vector<Polynomial> symbol = symbol_of(table);
    std::vector<Polynomial> square(a.size() + 2);  // of s
    for (std::size_t k = 0; k < square.size(); ++k) {
        for (std::size_t i = 1; i < k && i <= a.size(); ++i) {
            if (k - i <= a.size()) {
                square[k] += a[i - 1] * a[k - i - 1];
            }
        }
        // Coefficient of x^k in s^2 + tau sigma s (1 - s dt/2) + omega^2 (1 - s^2 dt^2/4).
        Polynomial sum = square[k] + moment(symbol, k);
        for (std::size_t i = 1; i <= k && i <= a.size(); ++i) {
            sum += a[i - 1] * constant(moment(table.model.damping, k - i));
        }
        for (std::size_t i = 2; i <= k; ++i) {
            const Polynomial whole = constant(moment(table.model.damping, k - i)) +
                                     moment(symbol, k - i) * constant(half_step);
            sum -= square[i] * whole * constant(half_step);
        }
        require(sum.is_zero(), fmt::format("Taylor coefficients at x^{}", k));
    }
}

std::string prove(const Table& table) {
    require(table.model.symbol == symbol_of(table.model.energy), "symbol follows from the energy");
    prove_damping(table);
    prove_taylor(table);
    prove_residual(table);
    prove_normal_form(table.c);
    prove_normal_form(table.b);
    prove_points(table);
    const Specification& what = table.specification;
    const bool fixed = what.stabilisation.has_value();
    const std::string at_points =
        what.points.empty()
            ? std::string()
            : fmt::format(", in {} row{} at xi = 0, and below 1e-30 at the matching points{}",
                          rows_at_zero(what), rows_at_zero(what) == 1 ? "" : "s",
                          table.digits > 0
                              ? fmt::format(" (c and b are rounded to {} digits)", table.digits)
                              : std::string());
    return fmt::format(
        "residual of (49) {}{}{}; symbol = sum of the energy's squares; {}C(1) {}",
        fixed ? "zero at this G" : "identically zero in G",
        what.time_step != 0 ? ", in leapfrog steps of this length" : "", at_points,
        what.damping > 0 ? "damping = tau times those of stabilisation at G = 1; " : "",
        fixed ? "!= 0" : "not identically zero");
}

}  // namespace nmbcgen
