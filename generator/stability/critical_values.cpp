// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stability/critical_values.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "generator/exact/resultant.hpp"

namespace nmbcgen {
namespace {

using InX = std::vector<Polynomial>;  // ascending in x = cos xi, coefficients in Q[G]

/// left + factor * right
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

/// d(omega^2)/dx, omega^2 = symbol_0 + 2 sum symbol_m T_m(x).
InX band_slope(const std::vector<Polynomial>& symbol) {
    InX before{constant(1)};
    InX now{Polynomial(), constant(1)};
    InX omega_squared{symbol[0]};
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        omega_squared = plus(omega_squared, now, symbol[m] * constant(2));
        const InX next = plus(plus({}, times_x(now), constant(2)), before, constant(-1));
        before = std::exchange(now, next);
    }
    InX slope;
    for (std::size_t i = 1; i < omega_squared.size(); ++i) {
        slope.push_back(omega_squared[i] * constant(Rational(i)));
    }
    trim(slope);
    return slope;
}

/// A polynomial in w = (x-1)/(x+1), times (x+1)^degree.
InX from_w(const std::vector<Polynomial>& in_w) {
    const InX plus_one{constant(1), constant(1)};
    InX result;
    InX power{constant(1)};  // (x+1)^(degree - i), by Horner's rule from the top
    for (std::size_t i = in_w.size(); i-- > 0;) {
        // result = result * (x-1) + in_w[i] * power
        result = plus(plus(times_x(result), result, constant(-1)), power, in_w[i]);
        power = plus(times_x(power), power, constant(1));
    }
    trim(result);
    return result;
}

Polynomial at_minus_one(const InX& polynomial) {
    Polynomial sum;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        sum += polynomial[i] * constant(i % 2 == 0 ? 1 : -1);
    }
    return sum;
}

std::vector<AlgebraicNumber> positive_roots(const Polynomial& polynomial) {
    auto roots = real_roots(square_free(polynomial), 0);
    std::erase_if(roots, [](const AlgebraicNumber& root) { return compare(root, 0) == 0; });
    return roots;
}

/// All of both, ascending, each once.
std::vector<AlgebraicNumber> merged(std::vector<AlgebraicNumber> values,
                                    const std::vector<AlgebraicNumber>& more) {
    values.insert(values.end(), more.begin(), more.end());
    std::ranges::sort(values, [](const AlgebraicNumber& left, const AlgebraicNumber& right) {
        return compare(left, right) < 0;
    });
    const auto same = [](const AlgebraicNumber& left, const AlgebraicNumber& right) {
        return compare(left, right) == 0;
    };
    values.erase(std::unique(values.begin(), values.end(), same), values.end());
    return values;
}

}  // namespace

std::vector<AlgebraicNumber> scalar_critical_values(const EvenAndOddParts& parts) {
    Polynomial product = parts.denominator;
    for (const auto* f : {&parts.E, &parts.O}) {
        product *= f->back();
        product *= *std::ranges::find_if(*f, [](const Polynomial& p) { return !p.is_zero(); });
        if (f->size() > 2) {
            product *= discriminant(*f);
        }
    }
    if (parts.E.size() > 1 && parts.O.size() > 1) {
        product *= resultant(parts.E, parts.O);
    }
    return positive_roots(product);
}

std::vector<AlgebraicNumber> modal_critical_values(const Table& table,
                                                   const EvenAndOddParts& parts) {
    const InX slope = band_slope(table.model.symbol);
    Polynomial product = slope.back() * at_minus_one(slope);
    if (slope.size() > 2) {
        product *= discriminant(slope);
    }
    for (const auto* part : {&parts.E, &parts.O}) {
        const InX in_x = from_w(*part);
        if (in_x.size() > 1 && slope.size() > 1) {
            const Polynomial meeting = resultant(in_x, slope);
            product *= meeting.is_zero() ? constant(1) : meeting;
        }
    }
    return merged(scalar_critical_values(parts), positive_roots(product));
}

std::vector<AlgebraicNumber> poles(const EvenAndOddParts& parts) {
    return real_roots(square_free(parts.denominator), 0);
}

std::vector<AlgebraicNumber> jordan_values(const EvenAndOddParts& parts) {
    // C(1) is E at w = 0. At a pole both may vanish.
    auto values = real_roots(square_free(parts.E.front()), 0);
    std::erase_if(values, [&](const AlgebraicNumber& value) {
        return sign_at(parts.denominator, value) == 0;
    });
    return values;
}

}  // namespace nmbcgen
