// SPDX-License-Identifier: MIT
#include "generator/exact/resultant.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

/// In powers of w, ascending.
using Coefficients = std::vector<Polynomial>;

Coefficients without_zeros_at_the_end(Coefficients f) {
    while (!f.empty() && f.back().is_zero()) {
        f.pop_back();
    }
    return f;
}

std::size_t largest_degree(const Coefficients& f) {
    std::size_t degree = 0;
    for (const Polynomial& coefficient : f) {
        degree = std::max(degree, coefficient.is_zero() ? 0 : coefficient.degree());
    }
    return degree;
}

/// The resultant of two polynomials over Z, neither of them zero, by the subresultant algorithm:
/// Euclid's with every remainder divided by the factor it is known to have (Cohen, A Course in
/// Computational Algebraic Number Theory, algorithm 3.3.7).
Integer resultant_over_integers(IntegerPolynomial f, IntegerPolynomial g) {
    const auto both_odd = [&] { return f.degree() % 2 == 1 && g.degree() % 2 == 1; };
    bool negative = f.degree() < g.degree() && both_odd();
    if (f.degree() < g.degree()) {
        std::swap(f, g);
    }
    Integer leading = 1;
    Integer height = 1;
    while (g.degree() > 0) {
        const auto drop = unsigned(f.degree() - g.degree());
        negative = negative != both_odd();
        const IntegerPolynomial remainder = f % g;  // of g's leading coefficient^(drop + 1) * f
        if (remainder.is_zero()) {
            return 0;
        }
        f = std::exchange(g, remainder / Integer(leading * pow(height, drop)));
        leading = f.data().back();
        height = drop == 0 ? height : Integer(pow(leading, drop) / pow(height, drop - 1));
    }
    const auto degree = unsigned(f.degree());
    const Integer size =
        degree == 0 ? Integer(1) : Integer(pow(g[0], degree) / pow(height, degree - 1));
    return negative ? Integer(-size) : size;
}

/// Likewise over Q.
Rational resultant_of_values(const Polynomial& f, const Polynomial& g) {
    const ExactFunction F = to_rational_function(f);
    const ExactFunction H = to_rational_function(g);
    const auto m = unsigned(f.degree());
    const auto n = unsigned(g.degree());
    return {resultant_over_integers(F.numerator, H.numerator),
            pow(F.denominator[0], n) * pow(H.denominator[0], m)};
}

Coefficients derivative(const Coefficients& f) {
    Coefficients result;
    for (std::size_t k = 1; k < f.size(); ++k) {
        result.push_back(f[k] * constant(Rational(k)));
    }
    return result;
}

}  // namespace

Polynomial interpolate(const std::vector<Integer>& points, std::vector<Rational> values) {
    // Newton's divided differences
    for (std::size_t order = 1; order < points.size(); ++order) {
        for (std::size_t i = points.size() - 1; i >= order; --i) {
            values[i] = (values[i] - values[i - 1]) / (points[i] - points[i - order]);
        }
    }
    Polynomial result;
    for (std::size_t i = points.size(); i-- > 0;) {
        result = result * Polynomial(std::vector<Rational>{-points[i], 1}) + constant(values[i]);
    }
    return result;
}

Polynomial resultant(const std::vector<Polynomial>& f, const std::vector<Polynomial>& g) {
    const Coefficients F = without_zeros_at_the_end(f);
    const Coefficients H = without_zeros_at_the_end(g);
    if (F.empty() || H.empty()) {
        return {};
    }
    // Sylvester's matrix has deg g rows of coefficients of f and deg f rows of g.
    const std::size_t degree =
        (H.size() - 1) * largest_degree(F) + (F.size() - 1) * largest_degree(H);
    std::vector<Integer> points;
    std::vector<Rational> values;
    for (Integer point = 0; points.size() <= degree; point = point > 0 ? -point : 1 - point) {
        const Polynomial f_there = at_parameter(F, Rational(point));
        const Polynomial h_there = at_parameter(H, Rational(point));
        // Where a leading coefficient vanishes, the resultant of the values is another one.
        if (f_there.size() == F.size() && h_there.size() == H.size()) {
            points.push_back(point);
            values.push_back(resultant_of_values(f_there, h_there));
        }
    }
    return interpolate(points, values);
}

Polynomial discriminant(const std::vector<Polynomial>& f) {
    const Coefficients F = without_zeros_at_the_end(f);
    if (F.size() < 2) {
        throw std::domain_error("a polynomial constant in w has no discriminant");
    }
    const std::size_t degree = F.size() - 1;
    const Polynomial quotient = resultant(F, derivative(F)) / F.back();
    return degree * (degree - 1) / 2 % 2 == 0 ? quotient : -quotient;
}

std::vector<Polynomial> free_of_parameter(const Polynomial& in_w) {
    std::vector<Polynomial> found;
    for (const Rational& coefficient : in_w.data()) {
        found.push_back(constant(coefficient));
    }
    return found;
}

Polynomial at_parameter(const std::vector<Polynomial>& in_w, const Rational& G) {
    std::vector<Rational> values;
    values.reserve(in_w.size());
    for (const Polynomial& coefficient : in_w) {
        values.push_back(evaluate(coefficient, G));
    }
    return Polynomial(std::move(values));
}

}  // namespace nmbcgen
