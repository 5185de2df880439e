// SPDX-License-Identifier: MIT
#include "generator/lattice/band.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/rational_function.hpp"

namespace nmbcgen {

InX plus(const InX& left, const InX& right, const Polynomial& factor) {
    InX sum = left;
    sum.resize(std::max(left.size(), right.size()));
    for (std::size_t i = 0; i < right.size(); ++i) {
        sum[i] += factor * right[i];
    }
    return sum;
}

InX times_x(const InX& polynomial) {
    InX product{Polynomial()};
    product.insert(product.end(), polynomial.begin(), polynomial.end());
    return product;
}

void trim(InX& polynomial) {
    while (!polynomial.empty() && polynomial.back().is_zero()) {
        polynomial.pop_back();
    }
}

InX band(const std::vector<Polynomial>& symbol) {
    InX before{constant(1)};
    InX now{Polynomial(), constant(1)};
    InX omega_squared{symbol[0]};
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        omega_squared = plus(omega_squared, now, symbol[m] * constant(2));
        const InX next = plus(plus({}, times_x(now), constant(2)), before, constant(-1));
        before = std::exchange(now, next);
    }
    trim(omega_squared);
    return omega_squared;
}

InX times(const InX& left, const InX& right) {
    InX product;
    for (std::size_t i = right.size(); i-- > 0;) {
        product = plus(times_x(product), left, right[i]);
    }
    trim(product);
    return product;
}

InX at_quotient(const InX& f, std::size_t degree, const InX& numerator, const InX& denominator) {
    InX result;
    InX power{constant(1)};  // denominator^(degree - i), by Horner's rule from the top
    for (std::size_t i = degree + 1; i-- > 0;) {
        result = times(result, numerator);
        if (i < f.size()) {
            result = plus(result, power, f[i]);
        }
        power = times(power, denominator);
    }
    trim(result);
    return result;
}

InX derivative(const InX& polynomial) {
    InX slope;
    for (std::size_t i = 1; i < polynomial.size(); ++i) {
        slope.push_back(polynomial[i] * constant(Rational(i)));
    }
    return slope;
}

Polynomial at(const InX& polynomial, int x) {
    Polynomial sum;
    for (std::size_t i = polynomial.size(); i-- > 0;) {
        sum = sum * constant(x) + polynomial[i];
    }
    return sum;
}

}  // namespace nmbcgen
