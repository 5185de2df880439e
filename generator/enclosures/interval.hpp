// SPDX-License-Identifier: MIT
/// Intervals of doubles whose operations round outwards: what is computed holds for every number
/// of the operands.
#pragma once

#include <boost/numeric/interval.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "generator/table/exact.hpp"

#ifdef __FAST_MATH__
#error "intervals need the arithmetic as it is written: compile without -ffast-math"
#endif

namespace nmbcgen {

/// Rounds to nearest and then steps outwards by one unit in the last place or two, so that no
/// rounding mode of the processor, and no contraction to fused operations, matters. What is exactly
/// 0 stays 0.
struct OutwardArithmetic : boost::numeric::interval_lib::rounded_arith_exact<double> {
    static double below(double x) { return x - step(x); }
    static double above(double x) { return x + step(x); }

    // A sum that rounds to 0 is 0.
    static double add_down(double x, double y) { return x + y == 0 ? 0 : below(x + y); }
    static double add_up(double x, double y) { return x + y == 0 ? 0 : above(x + y); }
    static double sub_down(double x, double y) { return add_down(x, -y); }
    static double sub_up(double x, double y) { return add_up(x, -y); }
    static double mul_down(double x, double y) { return x == 0 || y == 0 ? 0 : below(x * y); }
    static double mul_up(double x, double y) { return x == 0 || y == 0 ? 0 : above(x * y); }
    static double div_down(double x, double y) { return x == 0 ? 0 : below(x / y); }
    static double div_up(double x, double y) { return x == 0 ? 0 : above(x / y); }
    static double sqrt_down(double x) { return x == 0 ? 0 : below(std::sqrt(x)); }
    static double sqrt_up(double x) { return x == 0 ? 0 : above(std::sqrt(x)); }

  private:
    static double step(double x) {
        return std::abs(x) * std::numeric_limits<double>::epsilon() +
               std::numeric_limits<double>::denorm_min();
    }
};

using Interval = boost::numeric::interval<
    double, boost::numeric::interval_lib::policies<
                boost::numeric::interval_lib::save_state_nothing<OutwardArithmetic>,
                boost::numeric::interval_lib::checking_base<double>>>;

/// Re and Im each in an interval.
struct ComplexInterval {
    Interval re;
    Interval im;
};

inline ComplexInterval operator+(const ComplexInterval& one, const ComplexInterval& other) {
    return {one.re + other.re, one.im + other.im};
}

inline ComplexInterval operator-(const ComplexInterval& one, const ComplexInterval& other) {
    return {one.re - other.re, one.im - other.im};
}

inline ComplexInterval operator*(const Interval& factor, const ComplexInterval& z) {
    return {factor * z.re, factor * z.im};
}

inline ComplexInterval operator*(const ComplexInterval& one, const ComplexInterval& other) {
    return {one.re * other.re - one.im * other.im, one.re * other.im + one.im * other.re};
}

/// Infinite where the other may be 0.
inline ComplexInterval operator/(const ComplexInterval& one, const ComplexInterval& other) {
    const Interval power = square(other.re) + square(other.im);
    return {(one.re * other.re + one.im * other.im) / power,
            (one.im * other.re - one.re * other.im) / power};
}

/// |z|
Interval modulus(const ComplexInterval& z);

/// A polynomial in one variable, ascending, known to within its coefficients.
using EnclosedPolynomial = std::vector<Interval>;

Interval value_at(const EnclosedPolynomial& polynomial, const Interval& x);
ComplexInterval value_at(const EnclosedPolynomial& polynomial, const ComplexInterval& x);

EnclosedPolynomial derivative(const EnclosedPolynomial& polynomial);

/// The interval about an exact number. Throws std::overflow_error where it has no double.
Interval enclose(const Rational& value);

/// Polynomials whose coefficients are functions of a parameter: at `offset` from its middle they
/// are value + offset * slope, but for the rest. Their values are narrower so than those of
/// polynomials whose coefficients are enclosed one by one. Without slope and rest, the value
/// encloses them.
struct Expansion {
    EnclosedPolynomial value;
    EnclosedPolynomial slope;
    EnclosedPolynomial rest;
    Interval offset;

    EnclosedPolynomial enclosed() const;

    /// Enclosed where the parameter is one number but for roundings, which is as narrow and takes a
    /// third of the time.
    Expansion simplified() &&;

    /// A function that is linear in the polynomial, such as its value at a point; of no other would
    /// this be an enclosure.
    template <class Linear>
    auto of(const Linear& linear) const {
        const auto own = linear(value);
        return slope.empty() ? own : own + offset * linear(slope) + linear(rest);
    }

    Interval at(const Interval& x) const;
    ComplexInterval at(const ComplexInterval& z) const;
};

/// Of a polynomial of which no more is known than its coefficients.
Expansion unexpanded(EnclosedPolynomial polynomial);

/// In the polynomials' own variable.
Expansion derivative(const Expansion& expansion);

/// f on all of x, by its slope there, too (mean value form).
Interval values_on(const Interval& x, const Expansion& f, const Interval& slope);

/// Between low and high, which are exact.
Expansion expand(const std::vector<Polynomial>& coefficients, double low, double high);

}  // namespace nmbcgen
