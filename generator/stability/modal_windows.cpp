// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stability/modal_windows.hpp"

#include <algorithm>
#include <stdexcept>

#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "generator/exact/resultant.hpp"
#include "generator/stability/scalar.hpp"

namespace nmbcgen {
namespace {

using InX = std::vector<Polynomial>;  // ascending in x = cos xi, coefficients in Q[G]

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
    while (slope.back().is_zero()) {
        slope.pop_back();
    }
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
    while (!result.empty() && result.back().is_zero()) {
        result.pop_back();
    }
    return result;
}

Polynomial at_minus_one(const InX& polynomial) {
    Polynomial sum;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        sum += polynomial[i] * constant(i % 2 == 0 ? 1 : -1);
    }
    return sum;
}

/// A window narrower than this is left out. Such slivers are found where two extrema of the band
/// change their order: the band between them, with the amplified wave in it, is lost in roundings.
constexpr double narrowest_window = 5e-3;

/// The verdict; at a pole there is no condition, which is not stable either.
ModalVerdict verdict_at(const Table& table, const Rational& G) {
    try {
        return modal_verdict(make_half_space(table, G));
    } catch (const std::domain_error&) {
        return {.failure = ModalFailure::growing_mode};
    }
}

bool is_stable(const ModalVerdict& verdict) {
    return verdict.failure == ModalFailure::none;
}

/// The exact critical value an edge in [low, high] is: one that is as near as the bracket is
/// wide, or one that makes the window smaller and lies so near that the excess beyond it is below
/// what the verdict can tell from 1.
std::optional<AlgebraicNumber> exact_edge(const std::vector<AlgebraicNumber>& critical, double low,
                                          double high, bool opens) {
    constexpr double width = 1e-6;
    constexpr double indistinct = 1e-4;
    for (const AlgebraicNumber& value : critical) {
        const double candidate = nearest_double(value);
        const double from = low - (opens ? width : indistinct);
        const double to = high + (opens ? indistinct : width);
        if (from <= candidate && candidate <= to) {
            return value;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<AlgebraicNumber> modal_critical_values(const Table& table) {
    const InX slope = band_slope(table.model.symbol);
    Polynomial product = slope.back() * at_minus_one(slope);
    if (slope.size() > 2) {
        product *= discriminant(slope);
    }
    const auto parts = even_and_odd_parts(table);
    for (const auto* part : {&parts.E, &parts.O}) {
        const InX in_x = from_w(*part);
        if (in_x.size() > 1 && slope.size() > 1) {
            const Polynomial meeting = resultant(in_x, slope);
            if (!meeting.is_zero()) {
                product *= meeting;
            }
        }
    }
    std::vector<AlgebraicNumber> values = scalar_critical_values(table);
    for (const AlgebraicNumber& value : real_roots(square_free(product), 0)) {
        if (compare(value, 0) != 0) {
            values.push_back(value);
        }
    }
    std::ranges::sort(values, [](const AlgebraicNumber& left, const AlgebraicNumber& right) {
        return compare(left, right) < 0;
    });
    const auto same =
        std::ranges::unique(values, [](const AlgebraicNumber& left, const AlgebraicNumber& right) {
            return compare(left, right) == 0;
        });
    values.erase(same.begin(), same.end());
    return values;
}

std::vector<ModalWindow> modal_windows(const Table& table, const Rational& highest_G) {
    const auto critical = modal_critical_values(table);
    std::vector<double> samples{0, highest_G.convert_to<double>()};
    std::vector<double> splits = samples;
    for (const AlgebraicNumber& value : critical) {
        if (compare(value, highest_G) < 0) {
            splits.push_back(nearest_double(value));
        }
    }
    std::ranges::sort(splits);
    constexpr int parts = 24;
    for (std::size_t i = 0; i + 1 < splits.size(); ++i) {
        for (int part = 0; part < parts; ++part) {
            const double fraction = (part + 0.5) / parts;
            samples.push_back(splits[i] + (splits[i + 1] - splits[i]) * fraction);
        }
    }
    std::ranges::sort(samples);

    std::vector<ModalWindow> windows;
    ModalVerdict previous = verdict_at(table, 0);
    const ModalEdge at_zero{to_algebraic_number(0), {}};
    ModalEdge low = at_zero;
    double opened_at = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const ModalVerdict verdict = verdict_at(table, Rational(samples[i]));
        if (is_stable(verdict) != is_stable(previous)) {
            const bool opens = is_stable(verdict);
            double left = samples[i - 1];
            double right = samples[i];
            ModalVerdict beyond = opens ? previous : verdict;
            while (right - left > 5e-7) {
                const double middle = left + (right - left) / 2;
                const ModalVerdict found = verdict_at(table, Rational(middle));
                (is_stable(found) == opens ? right : left) = middle;
                if (!is_stable(found)) {
                    beyond = found;
                }
            }
            ModalEdge edge{Bracket{left, right}, beyond};
            if (const auto exact = exact_edge(critical, left, right, opens)) {
                edge.where = *exact;
            }
            if (opens) {
                low = edge;
                opened_at = left;
            } else if (right - opened_at > narrowest_window) {
                windows.push_back({low, edge});
            }
        }
        previous = verdict;
    }
    if (is_stable(previous)) {
        windows.push_back({low, {to_algebraic_number(highest_G), {}}});
    }
    return windows;
}

}  // namespace nmbcgen
