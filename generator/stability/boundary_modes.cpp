// SPDX-License-Identifier: MIT
#include "generator/stability/boundary_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/stability/polynomial_roots.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

/// (1 - w)^power
Polynomial power_of_one_minus_w(std::size_t power) {
    Polynomial result = constant(1);
    const Polynomial factor(std::vector<Rational>{1, -1});
    for (std::size_t i = 0; i < power; ++i) {
        result *= factor;
    }
    return result;
}

/// sigma^2 C^2 - B^2 of an undamped lattice, up to a factor, in w. Matching puts zeros at w = 0
/// (k = 1).
Polynomial boundary_mode_polynomial(const HalfSpace& h) {
    if (h.time_step == 0) {
        return h.modes;
    }
    const Rational half_step = Rational(h.time_step) / 2;
    return h.modes - constant(half_step * half_step) * h.modes_in_steps;
}

bool on_unit_circle(Complex w) {
    // k = (1+y)/(1-y) has |k| = 1 where y = sqrt(w) is imaginary.
    return w.real() < 0 && std::abs(w.imag()) < 1e-9 * std::abs(w);
}

double wave_number_of(Complex w) {
    return 2 * std::atan(std::sqrt(-w.real()));
}

/// y O(w) / E(w), which is sigma where sigma C = B.
Complex rate_at(const HalfSpace& h, Complex y) {
    const Complex k = (1.0 + y) / (1.0 - y);
    return evaluate_B(h, k) / evaluate_C(h, k);
}

/// A polynomial in w = y^2 as one in y.
Polynomial in_y(const Polynomial& in_w) {
    std::vector<Rational> coefficients;
    for (const Rational& coefficient : in_w.data()) {
        coefficients.insert(coefficients.end(), {coefficient, 0});
    }
    return Polynomial(std::move(coefficients));
}

/// C(k) and B(k) times (1-y)^{Ns}.
Polynomial C_in_y(const HalfSpace& h) {
    return in_y(h.E) + Polynomial(std::vector<Rational>{0, 1}) * in_y(h.F);
}

Polynomial B_in_y(const HalfSpace& h) {
    return in_y(h.H) + Polynomial(std::vector<Rational>{0, 1}) * in_y(h.O);
}

/// The same of a damped one, in y: with zeta from B/C = sigma, the interior's equation is
///     B^2 + tau sigma B (C - B dt/2) + omega^2 (C^2 - B^2 dt^2/4) = 0
Polynomial boundary_mode_polynomial_in_y(const HalfSpace& h) {
    const Polynomial dt = constant(Rational(h.time_step));
    const Polynomial C = C_in_y(h);
    const Polynomial B = B_in_y(h);
    const Polynomial whole = in_y(power_of_one_minus_w(h.reach())) * B * B;
    const Polynomial half_step = constant(Rational(1, 2)) * dt * B;
    return whole + in_y(h.D) * B * (C - half_step) - in_y(h.L) * (C - half_step) * (C + half_step);
}

/// The y = (k-1)/(k+1), |k| < 1, of all waves that obey the boundary condition for a zeta.
std::vector<Complex> evanescent_solutions(const HalfSpace& h) {
    std::vector<Complex> solutions;
    if (!h.is_damped()) {
        for (const Complex w : nonzero_roots(boundary_mode_polynomial(h))) {
            if (!on_unit_circle(w)) {
                solutions.push_back(-std::sqrt(w));
            }
        }
        return solutions;
    }
    for (const Complex y : nonzero_roots(boundary_mode_polynomial_in_y(h))) {
        if (y.real() < 0) {
            solutions.push_back(y);
        }
    }
    return solutions;
}

/// Wave numbers of the zeros of C and of B on the unit circle. Damping moves them off it, but what
/// they do near it is felt on it.
std::vector<double> zeros_near_unit_circle(const HalfSpace& h) {
    std::vector<double> wave_numbers;
    if (h.is_damped()) {
        for (const Polynomial& polynomial : {C_in_y(h), B_in_y(h)}) {
            for (const Complex y : nonzero_roots(polynomial)) {
                const Complex k = (1.0 + y) / (1.0 - y);
                constexpr double near = 0.2;
                if (std::abs(std::abs(k) - 1) < near) {
                    wave_numbers.push_back(std::abs(std::arg(k)));
                }
            }
        }
        return wave_numbers;
    }
    for (const Polynomial* polynomial : {&h.E, &h.O}) {
        for (const Complex w : nonzero_roots(*polynomial)) {
            if (on_unit_circle(w)) {
                wave_numbers.push_back(wave_number_of(w));
            }
        }
    }
    return wave_numbers;
}

/// ln |zeta| of one step, in continuous time Re s: modes compared with each other.
double growth_of(const HalfSpace& h, Complex sigma) {
    const Complex half = sigma * h.time_step / 2.0;
    return h.time_step > 0 ? std::log(std::abs((1.0 + half) / (1.0 - half))) : sigma.real();
}

}  // namespace

std::optional<Complex> growing_mode(const HalfSpace& half_space) {
    constexpr double roundings = 1e-9;
    std::optional<Complex> fastest;
    for (const Complex y : evanescent_solutions(half_space)) {
        const Complex sigma = rate_at(half_space, y);
        if (sigma.real() > roundings &&
            (!fastest || growth_of(half_space, sigma) > growth_of(half_space, *fastest))) {
            fastest = sigma;
        }
    }
    return fastest;
}

std::optional<double> resonance(const HalfSpace& h) {
    if (h.is_damped()) {
        return std::nullopt;  // its waves are not on the unit circle
    }
    for (const Complex w : nonzero_roots(boundary_mode_polynomial(h))) {
        if (!on_unit_circle(w)) {
            continue;
        }
        const double xi = wave_number_of(w);
        // i omega C = B at k = exp(i xi) for omega of either sign; at omega > 0 the wave is
        // k = exp(i sign xi), with group velocity -sign omega'(xi) inwards.
        const double omega = rate_at(h, Complex(0, std::tan(xi / 2))).imag();
        const double velocity = -omega_squared_slope(h, xi) / (2 * omega);
        if (velocity > 1e-6) {
            return xi;
        }
    }
    return std::nullopt;
}

std::vector<double> critical_frequencies(const HalfSpace& half_space) {
    std::vector<double> wave_numbers{std::numbers::pi};
    const auto zeros = zeros_near_unit_circle(half_space);
    wave_numbers.insert(wave_numbers.end(), zeros.begin(), zeros.end());
    // Extrema of omega: zeros of its slope in x = cos xi. Two about to meet may have become a
    // complex pair by roundings; they count all the same.
    for (const Complex x : polynomial_roots(derivative(in_cosine(half_space.symbol)))) {
        if (std::abs(x.imag()) < 1e-7 && std::abs(x.real()) < 1) {
            wave_numbers.push_back(std::acos(x.real()));
        }
    }
    // A frequency of 0 (at G = 0 there are several) is found as the root of what roundings leave.
    double sum = 0;
    for (const double coefficient : half_space.symbol) {
        sum += std::abs(coefficient);
    }
    const double roundings = 16 * std::numeric_limits<double>::epsilon() * sum;
    std::vector<double> frequencies{0};
    for (const double xi : wave_numbers) {
        const double square = omega_squared(half_space, xi);
        frequencies.push_back(square > roundings ? std::sqrt(square) : 0);
    }
    std::ranges::sort(frequencies);
    return frequencies;
}

}  // namespace nmbcgen
