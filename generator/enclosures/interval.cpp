// SPDX-License-Identifier: MIT
#include "generator/enclosures/interval.hpp"

#include <utility>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {

Interval modulus(const ComplexInterval& z) {
    return sqrt(square(z.re) + square(z.im));
}

Interval value_at(const EnclosedPolynomial& polynomial, const Interval& x) {
    Interval sum = 0;
    for (std::size_t i = polynomial.size(); i-- > 0;) {
        sum = sum * x + polynomial[i];
    }
    return sum;
}

ComplexInterval value_at(const EnclosedPolynomial& polynomial, const ComplexInterval& x) {
    ComplexInterval sum{0, 0};
    for (std::size_t i = polynomial.size(); i-- > 0;) {
        sum = sum * x;
        sum.re += polynomial[i];
    }
    return sum;
}

EnclosedPolynomial derivative(const EnclosedPolynomial& polynomial) {
    EnclosedPolynomial slope;
    for (std::size_t i = 1; i < polynomial.size(); ++i) {
        slope.push_back(polynomial[i] * double(i));
    }
    return slope;
}

Interval enclose(const Rational& value) {
    const double nearest = nearest_double(value);
    return Rational(nearest) == value
               ? Interval(nearest)
               : Interval(OutwardArithmetic::below(nearest), OutwardArithmetic::above(nearest));
}

EnclosedPolynomial Expansion::enclosed() const {
    EnclosedPolynomial sum;
    for (std::size_t i = 0; i < value.size(); ++i) {
        sum.push_back(value[i] + offset * slope[i] + rest[i]);
    }
    return sum;
}

Interval Expansion::at(const Interval& x) const {
    return value_at(value, x) + offset * value_at(slope, x) + value_at(rest, x);
}

ComplexInterval Expansion::at(const ComplexInterval& z) const {
    return value_at(value, z) + offset * value_at(slope, z) + value_at(rest, z);
}

Expansion unexpanded(EnclosedPolynomial polynomial) {
    const EnclosedPolynomial zeros(polynomial.size(), Interval(0));
    return {.value = std::move(polynomial), .slope = zeros, .rest = zeros, .offset = 0};
}

Expansion derivative(const Expansion& expansion) {
    return {.value = derivative(expansion.value),
            .slope = derivative(expansion.slope),
            .rest = derivative(expansion.rest),
            .offset = expansion.offset};
}

Expansion expand(const std::vector<Polynomial>& coefficients, double low, double high) {
    const Rational middle = (Rational(low) + Rational(high)) / 2;
    const Interval range(low, high);
    Expansion expansion{.value = {}, .slope = {}, .rest = {}, .offset = range - enclose(middle)};
    const Interval half_square = square(expansion.offset) / 2.0;
    for (const Polynomial& coefficient : coefficients) {
        const bool varies = coefficient.size() > 1 && low < high;
        const Polynomial slope = varies ? coefficient.prime() : Polynomial();
        const Polynomial bend = varies ? slope.prime() : Polynomial();
        EnclosedPolynomial curvature;
        for (const Rational& part : bend.data()) {
            curvature.push_back(enclose(part));
        }
        expansion.value.push_back(enclose(evaluate(coefficient, middle)));
        expansion.slope.push_back(enclose(evaluate(slope, middle)));
        expansion.rest.push_back(value_at(curvature, range) * half_square);
    }
    return expansion;
}

}  // namespace nmbcgen
