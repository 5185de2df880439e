// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stability/modal.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/stability/band_search.hpp"
#include "generator/stability/reflection.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

/// An exact polynomial rounded, scaled to a largest coefficient of 1, zeros at w = 0 divided out.
std::vector<double> rounded_without_zeros(const Polynomial& polynomial) {
    std::size_t first = 0;
    while (first < polynomial.size() && polynomial[first] == 0) {
        ++first;
    }
    Rational largest = 0;
    for (std::size_t i = first; i < polynomial.size(); ++i) {
        largest = std::max(largest, Rational(abs(polynomial[i])));
    }
    std::vector<double> coefficients;
    for (std::size_t i = first; i < polynomial.size(); ++i) {
        coefficients.push_back(nearest_double(polynomial[i] / largest));
    }
    return coefficients;
}

/// (1 - w)^power
Polynomial power_of_one_minus_w(std::size_t power) {
    Polynomial result = constant(1);
    const Polynomial factor(std::vector<Rational>{1, -1});
    for (std::size_t i = 0; i < power; ++i) {
        result *= factor;
    }
    return result;
}

/// sigma^2 C^2 - B^2 = 0 as a polynomial in w, without its zeros at w = 0 (k = 1), which matching
/// puts there.
std::vector<double> boundary_mode_polynomial(const HalfSpace& h) {
    const Polynomial w(std::vector<Rational>{0, 1});
    const Rational half_step = Rational(h.time_step) / 2;
    const Polynomial slowed =
        power_of_one_minus_w(h.reach()) + constant(half_step * half_step) * h.L;
    return rounded_without_zeros(h.L * h.E * h.E - w * h.O * h.O * slowed);
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

/// The y = (k-1)/(k+1), |k| < 1, of all waves that obey the boundary condition for a zeta.
std::vector<Complex> evanescent_solutions(const HalfSpace& h) {
    std::vector<Complex> solutions;
    if (h.ghosts == GhostLevel::midpoint) {
        for (const Complex w : polynomial_roots(boundary_mode_polynomial(h))) {
            if (!on_unit_circle(w)) {
                solutions.push_back(-std::sqrt(w));
            }
        }
        return solutions;
    }
    // zeta = 1 + dt B/C in the interior's equation: B^2 = -omega^2 (C^2 + dt C B).
    const Polynomial dt_y(std::vector<Rational>{0, Rational(h.time_step)});
    const Polynomial w(std::vector<Rational>{0, 1});
    const Polynomial polynomial =
        in_y(h.L * h.E * h.E - w * h.O * h.O * power_of_one_minus_w(h.reach())) +
        dt_y * in_y(h.L * h.E * h.O);
    for (const Complex y : polynomial_roots(rounded_without_zeros(polynomial))) {
        if (y.real() < 0) {
            solutions.push_back(y);
        }
    }
    return solutions;
}

/// Growth [c/dX] per time of a wave with this sigma; > 0 where |zeta| > 1.
double growth_of(const HalfSpace& h, Complex sigma) {
    return h.ghosts == GhostLevel::midpoint
               ? sigma.real()
               : std::log(std::abs(1.0 + h.time_step * sigma)) / h.time_step;
}

double like_ends_supremum(const Reflection& reflection) {
    return std::sqrt(round_trip_supremum(reflection, reflection));
}

/// sigma_max(R).
double norm(const Reflection& reflection) {
    const Eigen::MatrixXcd& R = reflection.matrix;
    if (R.rows() == 0) {
        return 0;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> squared(R.adjoint() * R,
                                                                  Eigen::EigenvaluesOnly);
    return std::sqrt(squared.eigenvalues()(R.rows() - 1));
}

}  // namespace

std::optional<Complex> growing_mode(const HalfSpace& half_space) {
    std::optional<Complex> fastest;
    double most = 1e-9;
    for (const Complex y : evanescent_solutions(half_space)) {
        const Complex sigma = rate_at(half_space, y);
        if (growth_of(half_space, sigma) > most) {
            most = growth_of(half_space, sigma);
            fastest = sigma;
        }
    }
    return fastest;
}

std::optional<double> resonance(const HalfSpace& h) {
    if (h.ghosts == GhostLevel::old) {
        return std::nullopt;  // B/C is imaginary on the unit circle, sigma is not
    }
    for (const Complex w : polynomial_roots(boundary_mode_polynomial(h))) {
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
    for (const Polynomial* polynomial : {&half_space.E, &half_space.O}) {
        for (const Complex w : polynomial_roots(rounded_without_zeros(*polynomial))) {
            if (on_unit_circle(w)) {
                wave_numbers.push_back(wave_number_of(w));
            }
        }
    }
    // Extrema of omega: zeros of its slope in x = cos xi. Two about to meet may have become a
    // complex pair by roundings; they count all the same.
    const std::vector<double> band = omega_squared_in_cosine(half_space);
    std::vector<double> slope;
    for (std::size_t i = 1; i < band.size(); ++i) {
        slope.push_back(double(i) * band[i]);
    }
    for (const Complex x : polynomial_roots(slope)) {
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

Grade stability_grade(const HalfSpace& half_space) {
    KnownModes modes(half_space);
    return stability_grade(half_space, modes);
}

Grade stability_grade(const HalfSpace& half_space, KnownModes& modes) {
    if (growing_mode(half_space) || resonance(half_space)) {
        return Grade::none;
    }
    const std::vector<double> frequencies = critical_frequencies(half_space);
    const auto holds = [&](double (*size)(const Reflection&)) {
        const auto size_at = [&](double omega) {
            return size(reflection(half_space, omega, modes.at(omega)));
        };
        const Peak peak = largest_over_band(frequencies, size_at, amplification_limit);
        return peak.value <= amplification_limit;
    };
    if (holds(norm)) {
        return Grade::contractive;
    }
    return holds(like_ends_supremum) ? Grade::paired : Grade::none;
}

ModalVerdict modal_verdict(const HalfSpace& half_space) {
    if (const auto growth = growing_mode(half_space)) {
        return {.failure = ModalFailure::growing_mode, .growth = *growth};
    }
    if (const auto xi = resonance(half_space)) {
        return {.failure = ModalFailure::resonance, .wave_number = *xi};
    }
    double largest_norm = 0;
    const auto supremum = [&](double omega) {
        const Reflection R = reflection(half_space, omega);
        largest_norm = std::max(largest_norm, norm(R));
        return like_ends_supremum(R);
    };
    const Peak highest = largest_over_band(critical_frequencies(half_space), supremum);
    ModalVerdict verdict;
    verdict.supremum = highest.value;
    verdict.contractive = largest_norm <= amplification_limit;
    if (highest.value > amplification_limit) {
        verdict.failure = ModalFailure::amplified_wave;
    }
    if (highest.omega > 0) {
        const auto modes = outgoing_modes(half_space, highest.omega);
        verdict.wave_number = std::abs(std::arg(modes.front().k));
        verdict.backward = std::ranges::any_of(
            modes, [](const Mode& mode) { return mode.travels() && std::arg(mode.k) > 0; });
    }
    return verdict;
}

}  // namespace nmbcgen
