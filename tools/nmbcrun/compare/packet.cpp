// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/compare/packet.hpp"

#include <algorithm>
#include <cmath>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/energy.hpp>
#include <numbers>

namespace nmbcrun {
namespace {

/// Wave numbers to each side of the middle, in steps of 1/(4 sigma), so that the periodic images
/// of the packet are 8 pi sigma away: to 6/sigma, where the envelope exp(-x^2/(2 sigma^2)) has
/// 1.5e-8 of its height and the energy 2e-16.
constexpr int half_count = 24;
constexpr double per_sigma = 4;
constexpr double cut_off = 6.44;  ///< [sigma], 1e-9 of the height
/// Nodes at rest beside the end, in reaches of the lattice: an exact one wants some.
constexpr std::size_t gap_beside_end = 4;

/// sigma [dX]: 30, and more where the packet would reach xi = 0.
double width_about(double middle) {
    return std::max(30.0, 1.1 * half_count / per_sigma / middle);
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
    : lattice_(lattice), time_step_(time_step), reach_(cut_off * width_about(middle)) {
    const double width = width_about(middle);
    slowest_ = std::numeric_limits<double>::infinity();
    const bool forward = group_velocity(lattice, middle, time_step) > 0;
    for (int m = -half_count; m <= half_count; ++m) {
        const double xi = middle + m / (per_sigma * width);
        const double velocity = group_velocity(lattice, xi, time_step);
        const double omega = std::sqrt(std::max(nmbc::omega_squared(lattice, xi), 0.0));
        const bool in_band = xi > 0 && xi < std::numbers::pi;
        slowest_ = std::min(slowest_, in_band ? (forward ? velocity : -velocity) : 0);
        waves_.push_back({forward ? xi : -xi, std::exp(-std::pow((xi - middle) * width, 2) / 2),
                          omega, std::asin(std::min(omega * time_step / 2, 1.0))});
    }
    for (int i = 1; i < 1000; ++i) {
        const double xi = i * std::numbers::pi / 1000;
        fastest_ = std::max(fastest_, std::abs(group_velocity(lattice, xi, time_step)));
    }
}

bool Packet::is_measurable() const {
    return slowest_ > 0.1 && reach_ < cut_off * width_about(2 * std::numbers::pi / 200);
}

std::size_t Packet::steps(std::size_t layer) const {
    const double way = 2 * reach_ + double(gap_beside_end * lattice_.reach() + 2 * layer);
    return std::size_t(std::ceil(way / slowest_ / time_step_));
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
    }
    return nmbc::energies(chain).staggered / before;
}

}  // namespace nmbcrun
