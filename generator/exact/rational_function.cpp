// SPDX-License-Identifier: MIT
#include "generator/exact/rational_function.hpp"

#include <boost/math/tools/polynomial_gcd.hpp>
#include <stdexcept>

#include "generator/exact/polynomial_gcd.hpp"

namespace nmbcgen {
ExactFunction reduce(const Polynomial& numerator, const Polynomial& denominator) {
    if (denominator.is_zero()) {
        throw std::domain_error("a rational function needs a denominator other than 0");
    }
    if (numerator.is_zero()) {
        return {IntegerPolynomial(), IntegerPolynomial(std::vector<Integer>{1})};
    }
    // Boost divides integer polynomials by pseudo-division, which scales the quotient; over the
    // rationals the quotient is exact.
    const Polynomial divisor =
        over_rationals(primitive_gcd(over_integers(numerator, common_denominator(numerator)),
                                     over_integers(denominator, common_denominator(denominator))));
    const Polynomial reduced_numerator = numerator / divisor;
    const Polynomial reduced_denominator = denominator / divisor;
    const Integer scale =
        lcm(common_denominator(reduced_numerator), common_denominator(reduced_denominator));
    IntegerPolynomial top = over_integers(reduced_numerator, scale);
    IntegerPolynomial bottom = over_integers(reduced_denominator, scale);
    Integer content = gcd(boost::math::tools::content(top), boost::math::tools::content(bottom));
    if (bottom.data().back() < 0) {
        content = -content;
    }
    top /= content;
    bottom /= content;
    return {top, bottom};
}

ExactFunction to_rational_function(const Polynomial& polynomial) {
    return reduce(polynomial, constant(1));
}

Polynomial over_rationals(const IntegerPolynomial& polynomial) {
    return Polynomial(std::vector<Rational>(polynomial.data().begin(), polynomial.data().end()));
}

Integer common_denominator(const Polynomial& polynomial) {
    Integer result = 1;
    for (const Rational& coefficient : polynomial.data()) {
        result = lcm(result, denominator(coefficient));
    }
    return result;
}

IntegerPolynomial over_integers(const Polynomial& polynomial, const Integer& multiple) {
    std::vector<Integer> coefficients;
    for (const Rational& coefficient : polynomial.data()) {
        coefficients.push_back(numerator(coefficient) * (multiple / denominator(coefficient)));
    }
    return IntegerPolynomial(std::move(coefficients));
}

IntegerPolynomial binomial(int sign, std::size_t power) {
    std::vector<Integer> coefficients{1};
    for (std::size_t k = 0; k < power; ++k) {
        coefficients.push_back(coefficients[k] * sign * (power - k) / (k + 1));
    }
    return IntegerPolynomial(std::move(coefficients));
}

Polynomial constant(const Rational& value) {
    return Polynomial(std::vector<Rational>{value});
}

Rational evaluate(const Polynomial& polynomial, const Rational& argument) {
    Rational sum = 0;
    for (std::size_t k = polynomial.size(); k-- > 0;) {
        sum = sum * argument + polynomial[k];
    }
    return sum;
}

Rational evaluate(const ExactFunction& function, const Rational& argument) {
    const Rational bottom = evaluate(over_rationals(function.denominator), argument);
    if (bottom == 0) {
        throw std::domain_error("pole of a rational function at " + argument.str());
    }
    return evaluate(over_rationals(function.numerator), argument) / bottom;
}

Polynomial common_denominator(const std::vector<ExactFunction>& functions) {
    std::vector<IntegerPolynomial> distinct;
    Polynomial product = constant(1);
    for (const ExactFunction& function : functions) {
        if (std::find(distinct.begin(), distinct.end(), function.denominator) == distinct.end()) {
            distinct.push_back(function.denominator);
            product *= over_rationals(function.denominator);
        }
    }
    return product;
}

Polynomial times_multiple(const ExactFunction& function, const Polynomial& multiple) {
    const auto [quotient, remainder] =
        boost::math::tools::quotient_remainder(multiple, over_rationals(function.denominator));
    if (!remainder.is_zero()) {
        throw std::logic_error("times_multiple: not a multiple of the denominator");
    }
    return over_rationals(function.numerator) * quotient;
}

}  // namespace nmbcgen
