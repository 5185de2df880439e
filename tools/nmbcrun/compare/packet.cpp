// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/compare/packet.hpp"

#include <algorithm>
#include <cmath>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/energy.hpp>
#include <numbers>

#include "tools/nmbcrun/terminal/interrupt.hpp"

namespace nmbcrun {
namespace {

/// Wave numbers to each side of the middle, in steps of 1/(4 sigma), so that the periodic images
/// of the packet are 8 pi sigma away: to 6/sigma, where the envelope exp(-x^2/(2 sigma^2)) has
/// 1.5e-8 of its height and the energy 2e-16.
constexpr int per_sigma = 4;
constexpr int farthest = 6;         ///< [1/sigma]
constexpr double cut_off = 6.44;    ///< [sigma], 1e-9 of the height
constexpr int band_samples = 1000;  ///< of the band
/// Nodes at rest beside the end, in reaches of the lattice: an exact one wants some.
constexpr std::size_t gap_beside_end = 4;

/// sigma [dX]: 30, and more where the packet would reach xi = 0.
double width_about(double middle) {
    return std::max(30.0, 1.1 * farthest / middle);
}

}  // namespace

double group_velocity(const nmbc::Lattice& lattice, double xi, double time_step) {
    const double squared = std::max(nmbc::omega_squared(lattice, xi), 0.0);
    const double cosine = std::sqrt(std::max(1 - squared * time_step * time_step / 4, 1e-12));
    return squared > 0 ? nmbc::omega_squared_slope(lattice, xi) / (2 * std::sqrt(squared)) / cosine
                       : 0;
}

double Wave::energy() const {
    return std::pow(amplitude * omega * std::cos(half_angle), 2);
}

Packet::Packet(const nmbc::Lattice& lattice, double middle, double time_step)
    : lattice_(lattice),
      middle_(middle),
      time_step_(time_step),
      reach_(cut_off * width_about(middle)),
      forward_(group_velocity(lattice, middle, time_step) > 0),
      waves_(waves_about(per_sigma)) {
    slowest_ = std::numeric_limits<double>::infinity();
    for (const Wave& wave : waves_) {
        const double xi = forward_ ? wave.xi : -wave.xi;
        const double velocity = group_velocity(lattice, xi, time_step);
        const bool in_band = xi > 0 && xi < std::numbers::pi;
        slowest_ = std::min(slowest_, in_band ? (forward_ ? velocity : -velocity) : 0);
    }
    for (int i = 1; i < band_samples; ++i) {
        const double xi = i * std::numbers::pi / band_samples;
        fastest_ = std::max(fastest_, std::abs(group_velocity(lattice, xi, time_step)));
    }
    at_band_edge_ = holds_band_edge();
}

std::vector<Wave> Packet::waves_about(int parts_per_sigma) const {
    const double width = width_about(middle_);
    const int half_count = farthest * parts_per_sigma;
    std::vector<Wave> waves;
    waves.reserve(std::size_t(2 * half_count + 1));
    for (int m = -half_count; m <= half_count; ++m) {
        const double xi = middle_ + m / (parts_per_sigma * width);
        const double omega = std::sqrt(std::max(nmbc::omega_squared(lattice_, xi), 0.0));
        waves.push_back({forward_ ? xi : -xi, std::exp(-std::pow((xi - middle_) * width, 2) / 2),
                         omega, std::asin(std::min(omega * time_step_ / 2, 1.0))});
    }
    return waves;
}

bool Packet::holds_band_edge() const {
    const auto [lowest, highest] = std::ranges::minmax(waves_, {}, &Wave::omega);
    const auto square_at = [this](int i) {
        return nmbc::omega_squared(lattice_, i * std::numbers::pi / band_samples);
    };
    for (int i = 1; i <= band_samples; ++i) {
        const double here = square_at(i);  // the band is even about xi = pi
        const bool is_edge = (here - square_at(i - 1)) * (square_at(i + 1) - here) <= 0;
        const double omega = std::sqrt(std::max(here, 0.0));
        if (is_edge && lowest.omega < omega && omega < highest.omega) {
            return true;
        }
    }
    return false;
}

std::vector<Wave> Packet::spectrum() const {
    constexpr int finer = 64;
    return at_band_edge_ ? waves_about(finer * per_sigma) : waves_;
}

bool Packet::is_measurable() const {
    return slowest_ > 0.1 && reach_ < cut_off * width_about(2 * std::numbers::pi / 200);
}

std::size_t Packet::steps(std::size_t layer) const {
    const double way = 2 * reach_ + double(gap_beside_end * lattice_.reach() + 2 * layer);
    const double longer = at_band_edge_ ? 4 : 1;
    return std::size_t(std::ceil(longer * way / slowest_ / time_step_));
}

double Packet::reflected_by(const nmbc::ChainEnd& end, std::size_t layer) const {
    const auto length = std::size_t(2 * reach_);
    const std::size_t gap = gap_beside_end * lattice_.reach();
    const double duration = double(steps(layer)) * time_step_;
    nmbc::Chain chain(lattice_, end, nmbc::FixedEnd{},
                      {.nodes = gap + std::size_t(double(length) + fastest_ * duration),
                       .time_step = time_step_});
    std::vector<double> u(chain.nodes());
    std::vector<double> v(chain.nodes());
    for (std::size_t i = 0; i <= length; ++i) {
        for (const Wave& wave : waves_) {
            const double phase = wave.xi * (double(i) - reach_);
            u[chain.first_interior() + gap + i] += wave.amplitude * std::cos(phase);
            v[chain.first_interior() + gap + i] -=
                wave.amplitude * wave.omega * std::sin(phase) * std::cos(wave.half_angle);
        }
    }
    // start() moves v on to -dt/2 by the lattice's own acceleration, -omega^2 u: by that
    // omega cos(half_angle) sin(phase) becomes omega sin(phase - half_angle).
    chain.start(u, v);
    const double before = nmbc::energies(chain).staggered;
    for (std::size_t step = steps(layer); step > 0; --step) {
        chain.step();
        stop_if_interrupted();
    }
    return nmbc::energies(chain).staggered / before;
}

}  // namespace nmbcrun
