// SPDX-License-Identifier: MIT
#include "generator/stability/mode_polynomial.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

template <class Number>
boost::math::tools::polynomial<Number> power_one() {
    return boost::math::tools::polynomial<Number>(std::vector<Number>{0, 1});
}

/// A polynomial in w = y^2 as one in y.
Polynomial in_y(const Polynomial& in_w) {
    std::vector<Rational> coefficients;
    for (const Rational& coefficient : in_w.data()) {
        coefficients.insert(coefficients.end(), {coefficient, 0});
    }
    return Polynomial(std::move(coefficients));
}

Integer common_denominator(const Polynomial& one, const Polynomial& other) {
    return lcm(nmbcgen::common_denominator(one), nmbcgen::common_denominator(other));
}

}  // namespace

Polynomial C_in_y(const HalfSpace& h) {
    return in_y(h.E) + power_one<Rational>() * in_y(h.F);
}

Polynomial B_in_y(const HalfSpace& h) {
    return in_y(h.H) + power_one<Rational>() * in_y(h.O);
}

std::array<IntegerPolynomial, 3> mode_coefficients(const HalfSpace& h) {
    const bool is_damped = h.is_damped();
    const auto in_variable = [&](const Polynomial& in_w) { return is_damped ? in_y(in_w) : in_w; };
    const Polynomial exact_C = is_damped ? C_in_y(h) : h.E;
    const Polynomial exact_B = is_damped ? B_in_y(h) : h.O;  // without its factor y
    const Integer of_condition = common_denominator(exact_C, exact_B);
    const IntegerPolynomial C = over_integers(exact_C, of_condition);
    const IntegerPolynomial B = over_integers(exact_B, of_condition);
    const IntegerPolynomial B_squared = is_damped ? B * B : power_one<Integer>() * B * B;

    const Integer of_lattice = common_denominator(h.L, h.D);
    const IntegerPolynomial L = over_integers(in_variable(h.L), of_lattice);
    const IntegerPolynomial D = over_integers(in_variable(h.D), of_lattice);
    const IntegerPolynomial whole =
        over_integers(in_variable(over_rationals(binomial(-1, h.reach()))), of_lattice);
    return {whole * B_squared + D * B * C - L * C * C, -(D * B_squared), L * B_squared};
}

IntegerPolynomial mode_polynomial(const HalfSpace& h) {
    if (h.time_step == 0) {
        return h.modes[0];
    }
    // dt/2 = numerator / 2^shift
    constexpr int digits = std::numeric_limits<double>::digits;
    int exponent = 0;
    const Integer numerator =
        std::int64_t(std::ldexp(std::frexp(h.time_step / 2, &exponent), digits));
    const auto shift = unsigned(digits - exponent);
    const Integer square = numerator * numerator;
    const auto& [constant, slope, curvature] = h.modes;
    const auto at = [](const IntegerPolynomial& f, std::size_t i) {
        return i < f.size() ? f[i] : Integer(0);
    };
    std::vector<Integer> sum;
    for (std::size_t i = 0; i < std::max({constant.size(), slope.size(), curvature.size()}); ++i) {
        sum.push_back((at(constant, i) << 2 * shift) + (at(slope, i) * numerator << shift) +
                      at(curvature, i) * square);
    }
    return IntegerPolynomial(std::move(sum));
}

}  // namespace nmbcgen
