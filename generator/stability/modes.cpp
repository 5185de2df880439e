// SPDX-License-Identifier: MIT
#include "generator/stability/modes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "generator/stability/polynomial_roots.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

/// The root k, |k| <= 1, of (k + 1/k)/2 = x, as the inverse of the other: next to a G where the
/// stencil is shorter x is so large that a difference would be 0.
Complex inner_root(Complex x) {
    const Complex root = std::sqrt(x * x - 1.0);
    return 1.0 / (std::norm(x + root) > 1 ? x + root : x - root);
}

/// Of k, |k| about 1, and 1/k the one that decays inwards when the wave grows in time. The
/// interior is Q(x, zeta) = omega^2(x) + (1 - 1/zeta)/dt tau sigma(x) + (zeta - 2 + 1/zeta)/dt^2;
/// slope is its derivative by x.
Complex decaying_one(const HalfSpace& h, double omega, Complex k, Complex damping, Complex slope) {
    const double sine = omega * h.time_step / 2;
    const double cosine = std::sqrt(1 - sine * sine);
    const Complex half_step(cosine, -sine);  // 1/sqrt(zeta)
    // dQ / d(log zeta) dt, of the sign of growth
    const Complex by_growth = Complex(0, 2 * omega * cosine) + damping * half_step * half_step;
    const Complex log_k_by_growth = -by_growth / slope * 2.0 / (k - 1.0 / k);
    return log_k_by_growth.real() < 0 ? k : 1.0 / k;
}

/// cosines: those of another frequency, or none; then those of this one.
std::vector<Mode> damped_outgoing_modes(const HalfSpace& h, double omega,
                                        std::vector<Complex>& cosines) {
    const Complex rate = damped_rate(h, omega);
    const std::vector<double>& square = h.symbol_in_cosine;
    const std::vector<double>& damping = h.damping_in_cosine;
    std::vector<Complex> polynomial(square.size());
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        polynomial[i] = square[i] + rate * damping[i];
    }
    polynomial[0] -= omega * omega;
    cosines = polynomial_roots(polynomial, cosines);
    std::vector<Mode> modes;
    modes.reserve(cosines.size());
    for (const Complex x : cosines) {
        Complex k = inner_root(x);
        // Nearer to the unit circle roundings would choose between k and 1/k.
        constexpr double near = 1 - 1e-6;
        if (std::norm(k) > near * near) {
            k = decaying_one(h, omega, k, evaluate_with_slope(damping, x).value,
                             evaluate_with_slope(polynomial, x).slope);
        }
        modes.push_back({k, 0});
    }
    return modes;
}

/// cosines: the x of omega.
std::vector<Mode> undamped_outgoing_modes(const HalfSpace& h, double omega,
                                          const LevelRoots& cosines) {
    std::vector<Mode> modes;
    for (const Complex x : cosines.at(omega * omega)) {
        if (x.imag() == 0 && std::abs(x.real()) < 1) {
            const double xi = std::acos(x.real());
            // exp(i(omega t + xi j)) has the group velocity -d omega/d xi along j.
            const double velocity = -omega_squared_slope(h, xi) / (2 * omega);
            modes.push_back({std::polar(1.0, velocity > 0 ? xi : -xi), std::abs(velocity)});
        } else {
            modes.push_back({inner_root(x), 0});
        }
    }
    return modes;
}

/// Travelling ones first, by ascending wave number.
void sort_modes(std::vector<Mode>& modes) {
    using Key = std::tuple<bool, double, double, double>;
    std::vector<std::pair<Key, Mode>> keyed;
    keyed.reserve(modes.size());
    for (const Mode& mode : modes) {
        const double angle = std::arg(mode.k);
        keyed.push_back({{!mode.travels(), std::abs(angle), std::norm(mode.k), angle}, mode});
    }
    std::ranges::sort(keyed, {}, &std::pair<Key, Mode>::first);
    std::ranges::transform(keyed, modes.begin(), &std::pair<Key, Mode>::second);
}

}  // namespace

OutgoingModes::OutgoingModes(const HalfSpace& half_space)
    : half_space_(half_space),
      undamped_(half_space.is_damped() ? std::vector<double>{} : half_space.symbol_in_cosine) {}

std::vector<Mode> OutgoingModes::at(double omega) {
    std::vector<Mode> modes = half_space_.is_damped()
                                  ? damped_outgoing_modes(half_space_, omega, damped_)
                                  : undamped_outgoing_modes(half_space_, omega, undamped_);
    sort_modes(modes);
    return modes;
}

std::vector<Mode> outgoing_modes(const HalfSpace& half_space, double omega) {
    return OutgoingModes(half_space).at(omega);
}

const Mode& least_fading(const std::vector<Mode>& modes) {
    return *std::ranges::max_element(modes, {}, [](const Mode& mode) { return std::abs(mode.k); });
}

}  // namespace nmbcgen
