// SPDX-License-Identifier: MIT
#include "generator/stability/boundary_modes.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_complex.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "generator/stability/mode_polynomial.hpp"
#include "generator/stability/polynomial_roots.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

bool on_unit_circle(Complex w) {
    // k = (1+y)/(1-y) has |k| = 1 where y = sqrt(w) is imaginary.
    return w.real() < 0 && std::abs(w.imag()) < 1e-9 * std::abs(w);
}

double wave_number_of(Complex w) {
    return 2 * std::atan(std::sqrt(-w.real()));
}

/// Whether C(k) has lost its digits; c_0 = 1.
bool cancels(Complex C) {
    constexpr double few_digits = 1e-5;
    return std::abs(C) < few_digits;
}

/// y O(w) / E(w), which is sigma where sigma C = B.
Complex rate_at(const HalfSpace& h, Complex y) {
    const Complex k = (1.0 + y) / (1.0 - y);
    const auto [C, B] = evaluate_condition(h, k);
    return B / C;
}

using Precise = boost::multiprecision::cpp_complex_100;

/// To a hundred digits.
std::vector<Precise::value_type> rounded(const auto& exact) {
    std::vector<Precise::value_type> coefficients;
    coefficients.reserve(exact.size());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        coefficients.emplace_back(exact[i]);
    }
    return coefficients;
}

/// rate_at() a zero of the mode polynomial that doubles only approximate, by exact coefficients:
/// next to a G where C and B share a zero near it, as near C(1) = 0, both nearly cancel there.
Complex precise_rate_at(const HalfSpace& h, const IntegerPolynomial& modes, Complex zero) {
    const auto coefficients = rounded(modes);
    Precise precise(zero.real(), zero.imag());
    constexpr int most = 50;
    for (int i = 0; i < most; ++i) {
        const auto [value, slope] = evaluate_with_slope(coefficients, precise);
        if (slope == 0 || value == 0) {
            break;
        }
        const Precise change = value / slope;
        precise -= change;
        if (abs(change) <= abs(precise) * Precise::value_type("1e-90")) {
            break;
        }
    }
    const auto at = [&](const Polynomial& f) {
        return evaluate_with_slope(rounded(f), precise).value;
    };
    const Precise sigma = h.is_damped() ? Precise(at(B_in_y(h)) / at(C_in_y(h)))
                                        : Precise(-sqrt(precise) * at(h.O) / at(h.E));
    return {sigma.real().convert_to<double>(), sigma.imag().convert_to<double>()};
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

BoundaryModes::BoundaryModes(const HalfSpace& half_space)
    : half_space_(half_space), modes_(mode_polynomial(half_space)), zeros_(nonzero_roots(modes_)) {}

std::optional<Complex> BoundaryModes::growing() const {
    constexpr double roundings = 1e-9;
    std::optional<Complex> fastest;
    for (const Complex zero : zeros_) {
        const bool decays = half_space_.is_damped() ? zero.real() < 0 : !on_unit_circle(zero);
        if (!decays) {
            continue;
        }
        const Complex y = half_space_.is_damped() ? zero : -std::sqrt(zero);
        // Chains are stepped in doubles: what grows in these grows, whatever exact numbers say.
        std::vector<Complex> rates{rate_at(half_space_, y)};
        if (cancels(evaluate_condition(half_space_, (1.0 + y) / (1.0 - y)).C)) {
            rates.push_back(precise_rate_at(half_space_, modes_, zero));
        }
        for (const Complex sigma : rates) {
            if (sigma.real() > roundings &&
                (!fastest || growth_of(half_space_, sigma) > growth_of(half_space_, *fastest))) {
                fastest = sigma;
            }
        }
    }
    return fastest;
}

std::optional<double> BoundaryModes::resonance() const {
    if (half_space_.is_damped()) {
        return std::nullopt;  // its waves are not on the unit circle
    }
    for (const Complex w : zeros_) {
        if (!on_unit_circle(w)) {
            continue;
        }
        const double xi = wave_number_of(w);
        // i omega C = B at k = exp(i xi) for omega of either sign; at omega > 0 the wave is
        // k = exp(i sign xi), with group velocity -sign omega'(xi) inwards.
        const double omega = rate_at(half_space_, Complex(0, std::tan(xi / 2))).imag();
        const double velocity = -omega_squared_slope(half_space_, xi) / (2 * omega);
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
    for (const Complex x : polynomial_roots(derivative(half_space.symbol_in_cosine))) {
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
