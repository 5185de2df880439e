// SPDX-License-Identifier: MIT
#include "generator/enclosures/damped_modes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "generator/enclosures/band_grade.hpp"
#include "generator/enclosures/by_halves.hpp"
#include "generator/enclosures/condition.hpp"
#include "generator/enclosures/root_discs.hpp"
#include "generator/enclosures/weighted_sum.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/stability/half_space.hpp"

namespace nmbcgen {
namespace {

/// k = forward/backward: (1 + pt)/(1 - t), in powers up to a highest one.
class Powers {
  public:
    Powers(int p, std::size_t highest) : forward_{{constant(1)}}, backward_{{constant(1)}} {
        for (std::size_t i = 0; i < highest; ++i) {
            forward_.push_back(times(forward_.back(), {constant(1), constant(p)}));
            backward_.push_back(times(backward_.back(), {constant(1), constant(-1)}));
        }
    }

    /// k^i backward^all
    InX at(std::size_t i, std::size_t all) const { return times(forward_[i], backward_[all - i]); }

  private:
    std::vector<InX> forward_;
    std::vector<InX> backward_;
};

/// sum_j coefficients_j k^{sj} backward^{Ns}
InX of_condition(const std::vector<Polynomial>& coefficients, std::size_t stride,
                 const Powers& powers) {
    const std::size_t all = (coefficients.size() - 1) * stride;
    InX sum;
    for (std::size_t j = 0; j < coefficients.size(); ++j) {
        sum = plus(sum, powers.at(j * stride, all), coefficients[j]);
    }
    trim(sum);
    return sum;
}

/// (symbol_0 + sum_m symbol_m (k^m + k^-m)) k^n backward^{2n}
InX of_lattice(const std::vector<Polynomial>& symbol, const Powers& powers) {
    const std::size_t n = symbol.size() - 1;
    InX sum = times(powers.at(n, 2 * n), {symbol[0]});
    for (std::size_t m = 1; m <= n; ++m) {
        sum = plus(sum, plus(powers.at(n + m, 2 * n), powers.at(n - m, 2 * n), constant(1)),
                   symbol[m]);
    }
    trim(sum);
    return sum;
}

std::size_t zeros_at_0(const InX& polynomial) {
    return std::size_t(
        std::ranges::find_if_not(polynomial, [](const Polynomial& c) { return c.is_zero(); }) -
        polynomial.begin());
}

InX without_zeros_at_0(const InX& polynomial, std::size_t count) {
    return {polynomial.begin() + std::ptrdiff_t(std::min(count, polynomial.size())),
            polynomial.end()};
}

InX negated(const InX& polynomial) {
    return plus({}, polynomial, constant(-1));
}

std::vector<Polynomial> constants(const std::vector<Rational>& values) {
    std::vector<Polynomial> found;
    std::ranges::transform(values, std::back_inserter(found), constant);
    return found;
}

/// h: about which the modes are expanded.
DampedCondition::Chart chart(const Table& table, const DampedCondition::CAndB& coefficients,
                             const Rational& h, int p) {
    const std::size_t stride = table.specification.stride;
    const std::size_t n = table.model.symbol.size() - 1;
    const Powers powers(p, std::max((coefficients.C.size() - 1) * stride, 2 * n));
    const InX C = of_condition(coefficients.C, stride, powers);
    const InX B = of_condition(coefficients.B, stride, powers);
    const InX square = of_lattice(table.model.symbol, powers);
    const InX damping = of_lattice(constants(table.model.damping), powers);
    const InX square_of_B = times(B, B);
    const InX continuous =
        plus(times(square_of_B, powers.at(n, 2 * n)),
             times(C, plus(times(damping, B), times(square, C), constant(1))), constant(1));
    const InX slope = negated(times(damping, square_of_B));
    const InX curvature = negated(times(square, square_of_B));
    std::array<InX, 3> modes{plus(plus(continuous, slope, constant(h)), curvature, constant(h * h)),
                             plus(slope, curvature, constant(2 * h)), curvature};
    const std::size_t common =
        std::min({zeros_at_0(modes[0]), zeros_at_0(modes[1]), zeros_at_0(modes[2])});
    for (InX& part : modes) {
        part = without_zeros_at_0(part, common);
    }
    return {.p = p, .modes = std::move(modes), .condition = {C, B}};
}

/// Q as the header has it.
InX even_part(const DampedCondition::CAndB& in_y) {
    InX mirrored = in_y.C;
    for (std::size_t i = 1; i < mirrored.size(); i += 2) {
        mirrored[i] = mirrored[i] * constant(-1);
    }
    const InX product = times(in_y.B, mirrored);
    InX Q;
    for (std::size_t i = 0; i < product.size(); i += 2) {
        Q.push_back(i % 4 == 0 ? product[i] : product[i] * constant(-1));
    }
    trim(Q);
    return without_zeros_at_0(Q, zeros_at_0(Q));
}

/// Re z conj(other)
Interval real_part_with_conjugate(const ComplexInterval& z, const ComplexInterval& other) {
    return z.re * other.re + z.im * other.im;
}

/// At all G of a window.
class Enclosed {
  public:
    Enclosed(const DampedCondition& condition, const nmbc::Window& window)
        : low_(window.low),
          high_(window.high),
          c_(enclosed(condition.in_k.C)),
          b_(enclosed(condition.in_k.B)),
          stride_(condition.stride),
          own_half_step_(enclose(condition.half_step)),
          C_(enclosed(condition.in_y.C)),
          B_(enclosed(condition.in_y.B)),
          slope_of_C_(derivative(C_)),
          slope_of_B_(derivative(B_)),
          Q_(enclosed(condition.Q)) {
        for (const DampedCondition::Chart& exact : condition.charts) {
            const auto part = [&](std::size_t i) { return expand(exact.modes[i], low_, high_); };
            charts_.push_back({exact.p,
                               {part(0), part(1), part(2)},
                               enclosed(exact.condition.C),
                               // without its factor t
                               enclosed(without_zeros_at_0(exact.condition.B, 1))});
        }
    }

    bool all_decay(const Interval& half_step) const {
        return std::ranges::any_of(charts_,
                                   [&](const Chart& chart) { return all_decay(chart, half_step); });
    }

  private:
    struct Chart {
        int p;
        std::array<Expansion, 3> modes;
        EnclosedPolynomial C;
        EnclosedPolynomial B_by_t;
    };

    EnclosedPolynomial enclosed(const InX& polynomial) const {
        return expand(polynomial, low_, high_).enclosed();
    }

    bool all_decay(const Chart& chart, const Interval& half_step) const {
        const Interval more = half_step - own_half_step_;
        const WeightedSum modes(
            {{chart.modes[0], 1}, {chart.modes[1], more}, {chart.modes[2], square(more)}});
        const std::vector<RootDisc> discs =
            root_discs(modes.enclosed(), [&](const ComplexInterval& t) { return modes.at(t); });
        return !discs.empty() && std::ranges::all_of(discs, [&](const RootDisc& disc) {
            return std::isfinite(disc.radius) && decay(chart, box_about(disc));
        });
    }

    bool decay(const Chart& chart, const ComplexInterval& t) const {
        const double more = chart.p - 1;
        if ((more * (square(t.re) + square(t.im)) + 2.0 * t.re).lower() > 0) {
            return true;
        }
        const ComplexInterval B = t * value_at(chart.B_by_t, t);
        if (real_part_with_conjugate(B, value_at(chart.C, t)).upper() < 0) {
            return true;
        }
        const ComplexInterval forward{1.0 + double(chart.p) * t.re, double(chart.p) * t.im};
        const ComplexInterval backward{1.0 - t.re, -t.im};
        if (const Interval k = modulus(forward / backward);
            k.upper() < 1 && rate_is_below_0(c_, b_, stride_, k)) {
            return true;
        }
        const ComplexInterval denominator{more * t.re + 2.0, more * t.im};
        return denominator.re.lower() > 0 && decay_in_y((more + 2) * (t / denominator));
    }

    bool decay_in_y(const ComplexInterval& y) const {
        if (y.re.lower() >= 0) {
            return true;
        }
        const ComplexInterval to_axis{{y.re.lower(), 0}, y.im};
        const Interval on_axis = Q_.empty() ? Interval(0) : value_at(Q_, square(y.im));
        const Interval slope =
            real_part_with_conjugate(value_at(slope_of_B_, to_axis), value_at(C_, to_axis)) +
            real_part_with_conjugate(value_at(B_, to_axis), value_at(slope_of_C_, to_axis));
        return on_axis.upper() <= 0 && slope.lower() > 0;
    }

    double low_;
    double high_;
    EnclosedPolynomial c_;
    EnclosedPolynomial b_;
    unsigned stride_;
    Interval own_half_step_;
    EnclosedPolynomial C_;
    EnclosedPolynomial B_;
    EnclosedPolynomial slope_of_C_;
    EnclosedPolynomial slope_of_B_;
    EnclosedPolynomial Q_;
    std::vector<Chart> charts_{};
};

Expansion band_of(const DampedCondition& condition, const nmbc::Window& window) {
    return expand(condition.band, window.low, window.high);
}

/// h (tau sigma + h omega^2) < 1 for all waves and all h up to this one.
bool interior_is_stable(const DampedCondition& condition, const EnclosedPolynomial& band,
                        double half_step) {
    EnclosedPolynomial load;
    for (std::size_t i = 0; i < std::max(band.size(), condition.damping.size()); ++i) {
        const Interval square = i < band.size() ? band[i] : 0;
        const Interval damping = i < condition.damping.size()
                                     ? enclose(evaluate(condition.damping[i], Rational(0)))
                                     : Interval(0);
        load.push_back(half_step * (damping + half_step * square));
    }
    return std::ranges::all_of(load,
                               [](const Interval& part) {
                                   return std::isfinite(part.lower()) &&
                                          std::isfinite(part.upper());
                               }) &&
           highest_square(unexpanded(load)).upper() < 1;
}

}  // namespace

DampedCondition damped_condition(const Table& table) {
    const EvenAndOddParts parts = even_and_odd_parts(table);
    const DampedCondition::CAndB coefficients{parts.c, parts.b};
    const Rational h = table.specification.time_step / 2;
    DampedCondition condition{
        .band = band(table.model.symbol),
        .damping = band(constants(table.model.damping)),
        .in_k = coefficients,
        .stride = table.specification.stride,
        .half_step = h,
        .charts = {chart(table, coefficients, h, 1), chart(table, coefficients, h, 3)},
        .in_y = {},
        .Q = {}};
    condition.in_y = condition.charts[0].condition;
    // A factor t of B is taken out, and those of the modes, which are k = 1 at rest then.
    if (zeros_at_0(condition.in_y.B) == 0 || zeros_at_0(condition.in_y.C) > 0) {
        throw std::invalid_argument("damped_condition: B(1) is not 0, or C(1) is at every G");
    }
    condition.Q = even_part(condition.in_y);
    return condition;
}

bool no_mode_grows(const DampedCondition& condition, const nmbc::Window& window,
                   const Interval& half_step) {
    const Expansion band = band_of(condition, window);
    if (!(window.low > 0) || !interior_is_stable(condition, band.enclosed(), half_step.upper())) {
        return false;
    }
    const Enclosed enclosed(condition, window);
    return holds_by_halves(half_step, spread_of(band),
                           [&](const Interval& part) { return enclosed.all_decay(part); });
}

Interval highest_square(const DampedCondition& condition, const nmbc::Window& window) {
    return highest_square(band_of(condition, window));
}

}  // namespace nmbcgen
