// SPDX-License-Identifier: MIT
#include "generator/stability/half_space.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/stability/mode_polynomial.hpp"

namespace nmbcgen {
namespace {

IntegerPolynomial integer(const Integer& value) {
    return IntegerPolynomial(std::vector<Integer>{value});
}

Polynomial quotient(const IntegerPolynomial& numerator, const Integer& denominator) {
    std::vector<Rational> coefficients;
    for (const Integer& coefficient : numerator.data()) {
        coefficients.emplace_back(coefficient, denominator);
    }
    return Polynomial(std::move(coefficients));
}

/// Every second coefficient of a polynomial in y, from y^first on: a polynomial in w = y^2.
template <class Number>
boost::math::tools::polynomial<Number> every_second(
    const boost::math::tools::polynomial<Number>& in_y, std::size_t first) {
    std::vector<Number> coefficients;
    for (std::size_t k = first; k < in_y.size(); k += 2) {
        coefficients.push_back(in_y[k]);
    }
    return boost::math::tools::polynomial<Number>(std::move(coefficients));
}

/// symbol_0 + sum_m symbol_m (k^m + k^-m) times (1-w)^r, r the reach, as a polynomial in w, from
/// k^m + k^-m = ((1+y)^{2m} + (1-y)^{2m}) / (1-w)^m.
Polynomial in_w(const std::vector<Rational>& symbol) {
    const std::size_t reach = symbol.size() - 1;
    const Integer denominator = common_denominator(Polynomial(std::vector(symbol)));
    IntegerPolynomial sum;
    for (std::size_t m = 0; m <= reach; ++m) {
        const IntegerPolynomial pair =
            m == 0 ? integer(1) : every_second(binomial(1, 2 * m) + binomial(-1, 2 * m), 0);
        sum += integer(numerator(symbol[m] * denominator)) * pair * binomial(-1, reach - m);
    }
    return quotient(sum, denominator);
}

/// k^{sj} times (1-y)^{Ns}, a polynomial in y.
IntegerPolynomial power_in_y(std::size_t j, std::size_t order, std::size_t stride) {
    return binomial(1, j * stride) * binomial(-1, (order - j) * stride);
}

/// sum_j coefficients_j k^{sj} times (1-y)^{Ns}, a polynomial in y.
Polynomial in_y(const std::vector<Rational>& coefficients, std::size_t stride) {
    const std::size_t order = coefficients.size() - 1;
    const Integer denominator = common_denominator(Polynomial(std::vector(coefficients)));
    IntegerPolynomial sum;
    for (std::size_t j = 0; j <= order; ++j) {
        sum += integer(numerator(coefficients[j] * denominator)) * power_in_y(j, order, stride);
    }
    return quotient(sum, denominator);
}

/// Likewise for coefficients in Q[G]: every second power of y from y^first on, by power of w.
std::vector<Polynomial> every_second_in_y(const std::vector<Polynomial>& coefficients,
                                          std::size_t stride, std::size_t first) {
    const std::size_t order = coefficients.size() - 1;
    std::vector<Polynomial> sum(order * stride / 2 + 1);
    for (std::size_t j = 0; j <= order; ++j) {
        const IntegerPolynomial powers = every_second(power_in_y(j, order, stride), first);
        for (std::size_t i = 0; i < powers.size(); ++i) {
            sum[i] += coefficients[j] * constant(Rational(powers[i]));
        }
    }
    while (sum.back().is_zero()) {
        sum.pop_back();
    }
    return sum;
}

std::vector<Rational> evaluate_all(const std::vector<ExactFunction>& functions, const Rational& G) {
    std::vector<Rational> values;
    values.reserve(functions.size());
    for (const ExactFunction& function : functions) {
        values.push_back(evaluate(function, G));
    }
    return values;
}

std::vector<double> rounded(const std::vector<Rational>& exact) {
    std::vector<double> values;
    values.reserve(exact.size());
    for (const Rational& value : exact) {
        values.push_back(nearest_double(value));
    }
    return values;
}

std::complex<double> horner(const std::vector<double>& coefficients, std::complex<double> z) {
    std::complex<double> sum = 0;
    for (std::size_t j = coefficients.size(); j-- > 0;) {
        sum = sum * z + coefficients[j];
    }
    return sum;
}

/// symbol_0 + 2 sum symbol_m cos(m xi) as a polynomial in cos xi, ascending.
std::vector<double> in_cosine(const std::vector<double>& symbol) {
    if (symbol.empty()) {
        return {};
    }
    std::vector<double> before(symbol.size(), 0.0);  // T_{m-1}
    std::vector<double> now(symbol.size(), 0.0);     // T_m
    std::vector<double> sum(symbol.size(), 0.0);
    before[0] = 1;
    now[1] = 1;
    sum[0] = symbol[0];
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        for (std::size_t i = 0; i < symbol.size(); ++i) {
            sum[i] += 2 * symbol[m] * now[i];
        }
        std::vector<double> next(symbol.size(), 0.0);  // 2 x T_m - T_{m-1}
        for (std::size_t i = 0; i < symbol.size(); ++i) {
            next[i] = (i > 0 ? 2 * now[i - 1] : 0) - before[i];
        }
        before = std::exchange(now, next);
    }
    return sum;
}

}  // namespace

HalfSpace make_half_space(const Table& table, const Rational& G) {
    const std::vector<Rational> c = evaluate_all(table.c, G);
    const std::vector<Rational> b = evaluate_all(table.b, G);
    std::vector<Rational> symbol;
    for (const Polynomial& coefficient : table.model.symbol) {
        symbol.push_back(evaluate(coefficient, G));
    }
    std::vector<Rational> damping = table.model.damping;
    // At a few G the stencil is shorter (n = 1, G = 1/2: the atom chain). A mode k = 0 is lost,
    // and the amplitudes of the others are the limits, since its factors in them tend to 1.
    while (symbol.back() == 0 && damping.empty()) {
        symbol.pop_back();
    }

    const auto stride = table.specification.stride;
    const Polynomial C = in_y(c, stride);
    const Polynomial B = in_y(b, stride);
    HalfSpace half_space{.L = -in_w(symbol),
                         .E = every_second(C, 0),
                         .O = every_second(B, 1),
                         .D = damping.empty() ? Polynomial() : in_w(damping),
                         .F = every_second(C, 1),
                         .H = every_second(B, 0),
                         .modes = {},
                         .symbol = rounded(symbol),
                         .damping = rounded(damping),
                         .symbol_in_cosine = in_cosine(rounded(symbol)),
                         .damping_in_cosine = in_cosine(rounded(damping)),
                         .c = rounded(c),
                         .b = rounded(b),
                         .stride = int(stride)};
    half_space.modes = mode_coefficients(half_space);
    return half_space;
}

EvenAndOddParts even_and_odd_parts(const Table& table) {
    std::vector<ExactFunction> all = table.c;
    all.insert(all.end(), table.b.begin(), table.b.end());
    const Polynomial denominator = common_denominator(all);
    std::vector<Polynomial> c;
    std::vector<Polynomial> b;
    for (std::size_t j = 0; j < table.c.size(); ++j) {
        c.push_back(times_multiple(table.c[j], denominator));
        b.push_back(times_multiple(table.b[j], denominator));
    }
    const auto stride = table.specification.stride;
    return {every_second_in_y(c, stride, 0), every_second_in_y(b, stride, 1), denominator, c, b};
}

HalfSpace stepped(HalfSpace half_space, double time_step) {
    half_space.time_step = time_step;
    return half_space;
}

std::complex<double> boundary_rate(const HalfSpace& half_space, double omega) {
    const double sine = omega * half_space.time_step / 2;  // of half the angle of zeta
    const double cosine = std::sqrt(1 - sine * sine);
    return {0, omega / cosine};
}

std::complex<double> damped_rate(const HalfSpace& half_space, double omega) {
    const double sine = omega * half_space.time_step / 2;
    return omega * std::complex<double>(sine, std::sqrt(1 - sine * sine));
}

CAndB evaluate_condition(const HalfSpace& half_space, std::complex<double> k) {
    std::complex<double> step = k;
    for (int i = 1; i < half_space.stride; ++i) {
        step *= k;
    }
    return {horner(half_space.c, step), horner(half_space.b, step)};
}

double omega_squared(const HalfSpace& half_space, double xi) {
    return symbol_at(half_space.symbol, xi);
}

double omega_squared_slope(const HalfSpace& half_space, double xi) {
    double sum = 0;
    for (std::size_t m = 1; m < half_space.symbol.size(); ++m) {
        sum -= 2 * half_space.symbol[m] * double(m) * std::sin(double(m) * xi);
    }
    return sum;
}

double symbol_at(const std::vector<double>& symbol, double xi) {
    double sum = symbol[0];
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        sum += 2 * symbol[m] * std::cos(double(m) * xi);
    }
    return sum;
}

}  // namespace nmbcgen
