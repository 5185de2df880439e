// SPDX-License-Identifier: MIT
#include "generator/stability/step_edges.hpp"

#include <algorithm>
#include <cmath>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "generator/exact/resultant.hpp"
#include "generator/lattice/band.hpp"
#include "generator/stability/critical_values.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"

namespace nmbcgen {
namespace {

/// Ascending in w, coefficients in Q[T], T = (dt/2)^2.
using InW = std::vector<Polynomial>;

/// constant + T * slope
InW affine(const Polynomial& constant, const Polynomial& slope) {
    InW found;
    for (std::size_t i = 0; i < std::max(constant.size(), slope.size()); ++i) {
        const auto at = [i](const Polynomial& f) { return i < f.size() ? f[i] : Rational(0); };
        found.push_back(Polynomial(std::vector<Rational>{at(constant), at(slope)}));
    }
    trim(found);
    return found;
}

/// Without zeros at w = 0: long waves.
InW without_zeros(InW polynomial) {
    const auto first =
        std::ranges::find_if(polynomial, [](const Polynomial& p) { return !p.is_zero(); });
    polynomial.erase(polynomial.begin(), first);
    return polynomial;
}

InW mode_polynomial_in_w(const HalfSpace& h) {
    return without_zeros(affine(over_rationals(h.modes[0]), over_rationals(h.modes[2])));
}

/// Zero at every T at which two modes have the same omega^2, as a pair of complex k has where it is
/// real: the discriminant of N(z) = prod over modes (z - omega^2), which has the degree r (2d - 2)
/// in T, d modes.
Polynomial modes_of_one_frequency(const HalfSpace& h) {
    const InW modes = mode_polynomial_in_w(h);
    if (modes.size() < 3) {
        return {};  // there are no two
    }
    const std::size_t count = modes.size() - 1;
    // (1-w)^r (z - omega^2)
    const InW apart = affine(h.L, over_rationals(binomial(-1, h.reach())));
    std::vector<Integer> points;
    std::vector<Rational> values;
    for (Integer T = 1; points.size() <= h.reach() * (2 * count - 2); ++T) {
        const Polynomial there = at_parameter(modes, Rational(T));
        const Polynomial N = resultant(free_of_parameter(there), apart);
        if (there.size() == modes.size() && N.size() == count + 1) {
            points.push_back(T);
            const Polynomial square = discriminant(free_of_parameter(N));
            values.push_back(square.is_zero() ? Rational(0) : square[0]);
        }
    }
    return interpolate(points, std::move(values));
}

/// (1-w)^{r+1} times the slope of omega^2
InW slope_of(const HalfSpace& h) {
    const InW L = free_of_parameter(h.L);
    InW slope =
        plus(times(derivative(L), {constant(-1), constant(1)}), L, constant(-Rational(h.reach())));
    trim(slope);
    return slope;
}

/// All w of the frequencies of extrema inside the band, and of xi = pi.
std::vector<Polynomial> waves_of_extrema(const HalfSpace& h) {
    const Polynomial interior = over_rationals(binomial(-1, h.reach()));
    // L(w) (1-v)^r - L(v) (1-w)^r, ascending in v
    InW alike;
    for (std::size_t i = 0; i < interior.size(); ++i) {
        const Rational of_L = i < h.L.size() ? h.L[i] : Rational(0);
        alike.push_back(h.L * constant(interior[i]) - interior * constant(of_L));
    }
    const Rational at_pi = h.L.size() == interior.size()
                               ? Rational(h.L.data().back() / interior.data().back())
                               : Rational(0);
    std::vector<Polynomial> found{h.L - interior * constant(at_pi)};
    const InW slope = slope_of(h);
    if (slope.size() > 1) {
        found.push_back(square_free(resultant(slope, alike)));
    }
    return found;
}

/// Of cfl = dt omega_max/2, rounded down.
double cfl_at(const AlgebraicNumber& square, double top) {
    return top * std::sqrt(nearest_double(square)) * (1 - 1e-15);
}

}  // namespace

std::vector<AlgebraicNumber> critical_steps(const HalfSpace& h) {
    const InW modes = mode_polynomial_in_w(h);
    // (1-w)^r (1 - (omega dt/2)^2)
    const InW slowed = affine(over_rationals(binomial(-1, h.reach())), h.L);
    const InW slope = slope_of(h);
    std::vector<Polynomial> polynomials{modes.front(), modes.back(), slowed.back()};
    if (modes.size() > 2) {
        polynomials.push_back(discriminant(modes));
    }
    if (slope.size() > 1) {
        polynomials.push_back(resultant(modes, slope));
        polynomials.push_back(resultant(slowed, slope));
    }
    if (h.E.size() > 1) {
        polynomials.push_back(resultant(slowed, free_of_parameter(h.E)));
    }
    // Of larger ones the roots take ten seconds and more.
    constexpr std::size_t largest = 90;
    if (h.reach() * (modes.size() - 1) <= largest) {
        polynomials.push_back(modes_of_one_frequency(h));
        for (const Polynomial& waves : waves_of_extrema(h)) {
            polynomials.push_back(resultant(modes, free_of_parameter(waves)));
        }
    }
    return positive_roots(std::move(polynomials));
}

StepEdges::StepEdges(const HalfSpace& half_space)
    : half_space_(half_space),
      grades_(half_space),
      top_(grades_.maximum_frequency()),
      critical_(half_space.is_damped() ? std::vector<AlgebraicNumber>()
                                       : critical_steps(half_space)) {}

StepRange StepEdges::range(Grade least) {
    return stable_range(grades_, least);
}

std::optional<StepEdge> StepEdges::edge(Grade least) {
    const auto [from, stable] = range(least);
    if (stable == 0) {
        return std::nullopt;
    }
    const auto holds = [&](double cfl) { return cfl < 1 && grades_.in(2 * cfl / top_) >= least; };
    double low = from;
    double high = std::min(1.0, stable + 0.01);
    for (const double cfl : middles_between(from, stable)) {
        if (!holds(cfl)) {
            high = cfl;
            break;
        }
        low = cfl;
    }
    low = high > stable ? stable : low;
    constexpr double width = 1e-9;
    while (high - low > width) {
        const double middle = low + (high - low) / 2;
        (holds(middle) ? low : high) = middle;
    }
    return described(low, high);
}

/// One cfl in each piece between critical steps that lies between.
std::vector<double> StepEdges::middles_between(double from, double to) const {
    std::vector<double> found;
    double before = from;
    for (const AlgebraicNumber& square : critical_) {
        const double at = cfl_at(square, top_);
        if (from < at && at < to) {
            found.push_back((before + at) / 2);
            before = at;
        }
    }
    return found;
}

StepEdge StepEdges::described(double low, double high) const {
    constexpr double near = 1e-6;
    constexpr double indistinct = 1e-4;
    StepEdge edge{.where = CflBracket{low, high}, .cfl = low};
    double distance = HUGE_VAL;
    for (const AlgebraicNumber& square : critical_) {
        const double at = cfl_at(square, top_);
        if (low - indistinct <= at && at <= high + near && std::abs(at - low) < distance) {
            distance = std::abs(at - low);
            edge.where = square;
            edge.cfl = at;
        }
    }
    const double farther = std::min(1e-4, (1 - high) / 2);
    if (farther > 0) {
        edge.beyond = failure_of(modal_verdict(stepped(half_space_, 2 * (high + farther) / top_)));
    }
    return edge;
}

}  // namespace nmbcgen
