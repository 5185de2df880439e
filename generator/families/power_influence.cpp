// SPDX-License-Identifier: MIT
#include "generator/families/power_influence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstddef>

#include "generator/exact/rational.hpp"
#include "generator/exact/real.hpp"
#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
namespace {

Rational to_the(const Rational& base, int exponent) {
    Rational result = 1;
    for (int i = 0; i < std::abs(exponent); ++i) {
        result *= base;
    }
    return exponent < 0 ? 1 / result : result;
}

/// 2/(n+1)!
Rational two_over_factorial(unsigned n) {
    Rational result = 2;
    for (unsigned i = 2; i <= n + 1; ++i) {
        result /= i;
    }
    return result;
}

/// Both terms agree in n + 1 times as many digits as delta/eps has zeros: in 54 of 120 at most.
double value_of(const WithLog& number, const PowerInfluence& influence) {
    const auto real_of = [](const Rational& exact) {
        return Real(Integer(numerator(exact))) / Real(Integer(denominator(exact)));
    };
    const Real log = log1p(real_of(influence.horizon / influence.smoothing));
    return Real(real_of(number.rational) + real_of(number.of_log) * log).convert_to<double>();
}

/// sum_k k^n w_k
Rational sum_over_bonds(const std::vector<Rational>& weights, unsigned n) {
    Rational sum = 0;
    for (std::size_t k = 1; k <= weights.size(); ++k) {
        sum += to_the(Rational(k), int(n)) * weights[k - 1];
    }
    return sum;
}

}  // namespace

WithLog moment(const PowerInfluence& influence, unsigned n) {
    // t = 1 + xi/eps: int (t - 1)^n t^-p dt from 1 to 1 + delta/eps, by the binomial theorem.
    const Rational last = 1 + influence.horizon / influence.smoothing;
    WithLog sum;
    Rational binomial = 1;
    for (unsigned j = 0; j <= n; ++j) {
        const Rational factor = (n - j) % 2 == 0 ? binomial : Rational(-binomial);
        const int exponent = int(j) - int(influence.power) + 1;
        if (exponent == 0) {
            sum.of_log += factor;
        } else {
            sum.rational += factor * (to_the(last, exponent) - 1) / Rational(exponent);
        }
        binomial *= n - j;
        binomial /= j + 1;
    }
    return sum;
}

double dispersion_coefficient(const PowerInfluence& influence, unsigned n) {
    return nearest_double(two_over_factorial(n)) * value_of(moment(influence, n), influence) /
           value_of(moment(influence, 1), influence);
}

Rational chain_dispersion_coefficient(const PowerInfluence& influence, unsigned n) {
    // omega^2 = 2 sum_k w_k/k (1 - cos(k xi))
    const std::vector<Rational> weights = power_weights(influence);
    return two_over_factorial(n) * sum_over_bonds(weights, n) / sum_over_bonds(weights, 1) /
           to_the(influence.smoothing, int(n) - 1);
}

std::vector<Rational> power_weights(const PowerInfluence& influence) {
    std::vector<Rational> weights;
    for (unsigned k = 1; k <= influence.horizon; ++k) {
        const Rational ratio = (1 + influence.smoothing) / (k + influence.smoothing);
        weights.push_back(to_the(ratio, int(influence.power)));
    }
    weights.back() /= 2;
    return weights;
}

ClassWeights class_weights(unsigned power, const Rational& smoothing,
                           std::span<const Offset> classes) {
    const double eps = nearest_double(smoothing);
    ClassWeights weights;
    for (const Offset& bond : classes) {
        const auto rounded = [&](double value) {
            constexpr double digits = 1e12;
            if (!(value * digits >= 1)) {
                throw NoSuchModel(fmt::format(
                    "at p = {}, eps = {} the bond ({}) is weaker than 1e-12 of the nearest, which "
                    "weights are rounded to: take a smaller p, a larger eps or a smaller radius",
                    power, to_string(smoothing),
                    fmt::join(std::span(bond).first(bond[2] == 0 ? 2 : 3), ", ")));
            }
            return Rational(Integer(std::round(value * digits)), Integer(digits));
        };
        const double length = std::sqrt(double(length_squared(bond)));
        const double omega = std::pow((1 + eps) / (length + eps), power);
        weights.influence.push_back(rounded(omega / length));
        weights.springs.push_back(rounded(omega / (length * length * length)));
    }
    return weights;
}

double modulus_of_continuum_factor(const PowerInfluence& influence) {
    // In units of eps: sum_k xi omega(xi) dX over I(p, 1), xi = k dX.
    const Rational cell = 1 / influence.smoothing;
    const Rational scale = to_the(1 + cell, -int(influence.power)) * cell * cell;
    return nearest_double(scale * sum_over_bonds(power_weights(influence), 1)) /
           value_of(moment(influence, 1), influence);
}

}  // namespace nmbcgen
