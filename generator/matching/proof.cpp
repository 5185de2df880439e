// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/proof.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "generator/exact/rational_function.hpp"
#include "generator/exact/symbol.hpp"

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

void prove_taylor(const Table& table) {
    const auto& a = table.taylor;  // a[k-1] is a_k
    require(!a.empty() && a.front() == constant(1), "Taylor coefficients: a_1 = c = 1");
    for (std::size_t k = 0; k <= a.size() + 1; ++k) {
        Polynomial square;
        for (std::size_t i = 1; i < k && i <= a.size(); ++i) {
            if (k - i <= a.size()) {
                square += a[i - 1] * a[k - i - 1];
            }
        }
        Polynomial moment;  // coefficient of x^k in omega^2
        for (std::size_t m = 0; m < table.model.symbol.size(); ++m) {
            const Rational z = power_over_factorial(m, k);
            const Rational inverse = k % 2 == 0 ? z : Rational(-z);
            moment += table.model.symbol[m] * constant(m == 0 ? z : Rational(z + inverse));
        }
        require((square + moment).is_zero(), fmt::format("Taylor coefficients at x^{}", k));
    }
}

void prove_residual(const Table& table) {
    const std::size_t order = table.specification.order;
    require(table.c.size() == order + 1 && table.b.size() == order + 1 &&
                table.taylor.size() == 2 * order + 1,
            "sizes of the coefficient lists");
    require(table.c[0] == to_rational_function(constant(1)), "c_0 = 1");

    std::vector<RationalFunction> all = table.c;
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
    for (std::size_t k = 0; k <= 2 * order; ++k) {
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

void prove_normal_form(const std::vector<RationalFunction>& functions) {
    for (const RationalFunction& f : functions) {
        require(reduce(over_rationals(f.numerator), over_rationals(f.denominator)) == f,
                "normal form of a coefficient");
    }
}

}  // namespace

std::string prove(const Table& table) {
    require(table.model.symbol == symbol_of(table.model.energy), "symbol follows from the energy");
    prove_taylor(table);
    prove_residual(table);
    prove_normal_form(table.c);
    prove_normal_form(table.b);
    return table.specification.stabilisation
               ? "residual of (49) zero at this G; symbol = sum of the energy's squares; C(1) != 0"
               : "residual of (49) identically zero in G; symbol = sum of the energy's squares; "
                 "C(1) not identically zero";
}

}  // namespace nmbcgen
