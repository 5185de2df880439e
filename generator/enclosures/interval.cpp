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
    EnclosedPolynomial sum = value;
    for (std::size_t i = 0; i < slope.size(); ++i) {
        sum[i] += offset * slope[i] + rest[i];
    }
    return sum;
}

Expansion Expansion::simplified() && {
    constexpr double of_roundings = 1e-14;
    return width(offset) <= of_roundings ? unexpanded(enclosed()) : std::move(*this);
}

Interval Expansion::at(const Interval& x) const {
    return of([&](const EnclosedPolynomial& part) { return value_at(part, x); });
}

ComplexInterval Expansion::at(const ComplexInterval& z) const {
    return of([&](const EnclosedPolynomial& part) { return value_at(part, z); });
}

Expansion unexpanded(EnclosedPolynomial polynomial) {
    return {.value = std::move(polynomial), .slope = {}, .rest = {}, .offset = 0};
}

Expansion derivative(const Expansion& expansion) {
    return {.value = derivative(expansion.value),
            .slope = derivative(expansion.slope),
            .rest = derivative(expansion.rest),
            .offset = expansion.offset};
}

Interval values_on(const Interval& x, const Expansion& f, const Interval& slope) {
    const Interval middle = median(x);
    return intersect(f.at(x), f.at(middle) + slope * (x - middle));
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
    return std::move(expansion).simplified();
}

}  // namespace nmbcgen
