// SPDX-License-Identifier: MIT
#include "generator/enclosures/condition.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "generator/exact/rational_function.hpp"
#include "generator/stability/half_space.hpp"

namespace nmbcgen {
namespace {

/// Without the factor (1-x)^2, which it has.
InX without_long_waves(InX polynomial) {
    for (int once = 0; once < 2; ++once) {
        InX quotient(polynomial.size() - 1);
        Polynomial carried;
        for (std::size_t i = 0; i < quotient.size(); ++i) {
            carried += polynomial[i];
            quotient[i] = carried;
        }
        if (!(carried + polynomial.back()).is_zero()) {
            throw std::invalid_argument("exact_condition: it does not match long waves");
        }
        polynomial = quotient;
    }
    return polynomial;
}

/// band/scale, which is affine in 1/G or in G, since the band is in G.
Expansion ratio(const InX& band, const Polynomial& scale, const Interval& G) {
    const bool is_per_G = scale.size() > 1;
    const Interval variable = is_per_G ? 1.0 / G : G;
    const Interval middle = median(variable);
    Expansion expansion{.value = {}, .slope = {}, .rest = {}, .offset = variable - middle};
    for (const Polynomial& coefficient : band) {
        const auto part = [&](std::size_t power) {
            return enclose(power < coefficient.size() ? coefficient[power] : Rational(0));
        };
        const Interval slope = part(is_per_G ? 0 : 1);
        expansion.value.push_back(part(is_per_G ? 1 : 0) + slope * middle);
        expansion.slope.push_back(slope);
        expansion.rest.emplace_back(0);
    }
    return std::move(expansion).simplified();
}

}  // namespace

ExactCondition exact_condition(const Table& table, const Polynomial& scale) {
    if (!table.model.damping.empty()) {
        throw std::invalid_argument("exact_condition: the lattice is damped");
    }
    if (std::ranges::any_of(table.model.symbol,
                            [](const Polynomial& part) { return part.size() > 2; })) {
        throw std::invalid_argument("exact_condition: omega^2 is not affine in G");
    }
    const EvenAndOddParts parts = even_and_odd_parts(table);
    const std::size_t shift = std::size_t(table.specification.order) * table.specification.stride;
    const std::size_t degree_E = parts.E.size() - 1;
    const std::size_t degree_O = parts.O.size() - 1;
    if (degree_E != shift / 2 || degree_O != (shift - 1) / 2) {
        throw std::invalid_argument("exact_condition: a leading coefficient is 0 at every G");
    }
    const bool half_odd = shift % 2 == 1;  // C~ vanishes at x = -1
    const InX one_plus_x{constant(1), constant(1)};
    const InX one_minus_x{constant(1), constant(-1)};
    const auto from_w = [&](const std::vector<Polynomial>& in_w) {
        return at_quotient(in_w, in_w.size() - 1, {constant(-1), constant(1)}, one_plus_x);
    };
    const InX O = from_w(parts.O);
    ExactCondition condition;
    condition.scale = scale;
    condition.band = band(table.model.symbol);
    condition.E = from_w(parts.E);
    condition.O = half_odd ? O : times(O, one_plus_x);
    condition.product = times(condition.E, O);
    condition.square_of_C = times(condition.E, condition.E);
    condition.square_of_B = times(times(O, O), one_minus_x);
    InX& more = half_odd ? condition.square_of_C : condition.square_of_B;
    more = times(more, one_plus_x);
    const InX modes = times(without_long_waves(plus(times(condition.band, condition.square_of_C),
                                                    condition.square_of_B, constant(-1))),
                            {scale});
    const InX in_steps = without_long_waves(times(condition.band, condition.square_of_B));
    const std::size_t degree = std::max(modes.size(), in_steps.size()) - 1;
    const auto to_w = [&](const InX& f) {
        return at_quotient(f, degree, one_plus_x, one_minus_x);  // x = (1+w)/(1-w)
    };
    const auto to_v = [](const InX& f, std::size_t power) {
        return at_quotient(f, power, {constant(1), constant(3)}, {Polynomial(), constant(1)});
    };
    condition.C = parts.c;
    condition.B = parts.b;
    condition.stride = table.specification.stride;
    condition.in_w = {
        .modes = to_w(modes), .modes_in_steps = to_w(in_steps), .E = parts.E, .O = parts.O};
    const std::size_t reach = std::max(condition.E.size(), condition.O.size()) - 1;
    condition.in_v = {.modes = to_v(modes, degree),
                      .modes_in_steps = to_v(in_steps, degree),
                      .E = to_v(condition.E, reach),
                      .O = to_v(condition.O, reach)};
    return condition;
}

EnclosedCondition enclose(const ExactCondition& condition, double low, double high) {
    const auto expanded = [=](const InX& polynomial) { return expand(polynomial, low, high); };
    const auto all = [&](const ModePolynomials<InX>& exact) {
        return ModePolynomials<Expansion>{.modes = expanded(exact.modes),
                                          .modes_in_steps = expanded(exact.modes_in_steps),
                                          .E = expanded(exact.E),
                                          .O = expanded(exact.O)};
    };
    const Interval scale = expanded({condition.scale}).enclosed().front();
    return {.scale = scale,
            .band = ratio(condition.band, condition.scale, Interval(low, high)),
            .product = expanded(condition.product),
            .square_of_C = expanded(condition.square_of_C),
            .square_of_B = expanded(condition.square_of_B),
            .E = expanded(condition.E),
            .O = expanded(condition.O),
            .C = expanded(condition.C),
            .B = expanded(condition.B),
            .stride = condition.stride,
            .in_w = all(condition.in_w),
            .in_v = all(condition.in_v)};
}

bool rate_is_below_0(const EnclosedPolynomial& c, const EnclosedPolynomial& b, unsigned stride,
                     const Interval& modulus_of_k) {
    const auto others = [&](const EnclosedPolynomial& coefficients) {
        Interval sum = 0;
        for (std::size_t j = coefficients.size() - 1; j > 0; --j) {
            sum = (sum + abs(coefficients[j])) * pow(modulus_of_k, int(stride));
        }
        return sum;
    };
    const Interval of_C = others(c);
    const Interval of_B = others(b);
    return (b[0] * c[0] + abs(b[0]) * of_C + abs(c[0]) * of_B + of_B * of_C).upper() < 0;
}

}  // namespace nmbcgen
