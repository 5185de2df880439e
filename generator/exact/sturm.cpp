// SPDX-License-Identifier: MIT
#include "generator/exact/sturm.hpp"

#include <boost/math/tools/polynomial_gcd.hpp>
#include <stdexcept>

#include "generator/exact/polynomial_gcd.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {

using boost::math::tools::leading_coefficient;

IntegerPolynomial primitive(const Polynomial& polynomial) {
    IntegerPolynomial result = to_rational_function(polynomial).numerator;
    const Integer content = abs(boost::math::tools::content(result));
    result /= leading_coefficient(result) < 0 ? Integer(-content) : content;
    return result;
}

IntegerPolynomial quotient(const IntegerPolynomial& polynomial, const IntegerPolynomial& divisor) {
    // Boost's division over Z would scale the quotient; over Q it is the quotient.
    return primitive(over_rationals(polynomial) / over_rationals(divisor));
}

IntegerPolynomial primitive_square_free(const Polynomial& polynomial) {
    if (polynomial.is_zero()) {
        throw std::domain_error("every number is a root of the polynomial 0");
    }
    const IntegerPolynomial f = primitive(polynomial);
    const IntegerPolynomial repeated = primitive_gcd(f, f.prime());
    return repeated.degree() == 0 ? f : quotient(f, repeated);
}

Integer scaled_value(const IntegerPolynomial& polynomial, const Rational& x) {
    const Integer p = numerator(x);
    const Integer q = denominator(x);
    Integer value = 0;
    Integer power = 1;
    for (std::size_t k = polynomial.size(); k-- > 0;) {
        value = value * p + polynomial[k] * power;
        power *= q;
    }
    return value;
}

int sign_of(const IntegerPolynomial& polynomial, const Rational& x) {
    return scaled_value(polynomial, x).sign();
}

bool changes_sign(const IntegerPolynomial& polynomial, const AlgebraicNumber& between) {
    return sign_of(polynomial, between.low) != sign_of(polynomial, between.high);
}

SturmChain::SturmChain(const IntegerPolynomial& polynomial) : chain_{polynomial} {
    if (polynomial.degree() > 0) {
        chain_.push_back(polynomial.prime());
    }
    while (chain_.back().degree() > 0) {
        IntegerPolynomial divisor = chain_.back();
        if (leading_coefficient(divisor) < 0) {
            divisor = -divisor;  // pseudo-division multiplies by powers of this coefficient
        }
        const IntegerPolynomial remainder = chain_[chain_.size() - 2] % divisor;
        chain_.push_back(remainder / Integer(-abs(boost::math::tools::content(remainder))));
    }
}

std::size_t SturmChain::changes(const Rational& x) const {
    std::size_t changes = 0;
    int last = 0;
    for (const IntegerPolynomial& member : chain_) {
        const int next = sign_of(member, x);
        changes += std::size_t(last * next < 0);
        last = next == 0 ? last : next;
    }
    return changes;
}

std::size_t SturmChain::roots_in_closed(const Rational& low, const Rational& high) const {
    return changes(low) - changes(high) + std::size_t(sign_of(chain_[0], low) == 0);
}

}  // namespace nmbcgen
