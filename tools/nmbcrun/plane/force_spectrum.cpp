// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/force_spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "tools/nmbcrun/plane/plane_lattice.hpp"

namespace nmbcrun {
namespace {

using std::numbers::pi;

/// |F(omega)|^2 of the history, but for a factor; 0 where it is not known.
double spectral_energy(const ForceHistory& history, double omega) {
    const double x = omega * history.duration / 2;
    switch (history.history) {
        case History::gaussian:
            return std::exp(-2 * x * x);
        case History::ricker:
            return std::pow(x, 4) * std::exp(-2 * x * x);
        case History::sine: {
            const double own = 2 * pi * history.frequency;
            const double duration = history.cycles / history.frequency;
            const auto transform = [&](double difference) {
                const double phase = difference * duration / 2;
                return std::polar(phase == 0 ? 1.0 : std::sin(phase) / phase, phase);
            };
            return std::norm(transform(omega - own) - transform(omega + own));
        }
        case History::file:
            break;
    }
    return 0;
}

/// The nodes that it acts on, from its centre [dX].
std::vector<std::array<double, 2>> nodes_of(const PlaneScene& scene) {
    const PlaneForcing& force = *scene.force;
    std::vector<std::array<double, 2>> nodes;
    const double reach = force.half_width / scene.spacing * (1 + 1e-9);
    constexpr double widest = 30;  // of more nodes the waves are long
    const auto about = [&](std::size_t axis) { return force.centre[axis] / scene.spacing; };
    if (reach > widest) {
        return nodes;
    }
    for (double y = std::ceil(about(1) - reach); y <= about(1) + reach; ++y) {
        for (double x = std::ceil(about(0) - reach); x <= about(0) + reach; ++x) {
            if (std::hypot(x - about(0), y - about(1)) <= reach) {
                nodes.push_back({x - about(0), y - about(1)});
            }
        }
    }
    return nodes;
}

/// Whether waves about xi go at the speed of the solid's, nearly.
bool is_carried(const nmbc::PlaneModel& model, const std::array<double, 2>& xi, bool is_P) {
    const auto omega = [&](double x, double y) {
        return std::sqrt(std::max(0.0, nmbc::plane_wave(model, {x, y}, is_P).omega_squared));
    };
    constexpr double aside = 1e-4;
    const std::array<double, 2> group{
        (omega(xi[0] + aside, xi[1]) - omega(xi[0] - aside, xi[1])) / (2 * aside),
        (omega(xi[0], xi[1] + aside) - omega(xi[0], xi[1] - aside)) / (2 * aside)};
    const double forwards = (group[0] * xi[0] + group[1] * xi[1]) / std::hypot(xi[0], xi[1]);
    const double speed = forwards / (is_P ? model.speed_P() : model.speed_S());
    constexpr double far_off = 0.25;
    return std::abs(speed - 1) <= far_off;
}

}  // namespace

double not_carried(const PlaneScene& scene) {
    if (!scene.force) {
        return 0;
    }
    const auto nodes = nodes_of(scene);
    const nmbc::PlaneModel model = model_of(scene);
    constexpr int steps = 32;  // over half the zone
    double all = 0;
    double lost = 0;
    for (int y = 0; y < steps; ++y) {
        for (int x = -steps; x < steps; ++x) {
            const std::array<double, 2> xi{pi * (x + 0.5) / steps, pi * (y + 0.5) / steps};
            std::complex<double> shape = 0;
            for (const auto& [X, Y] : nodes) {
                shape += std::polar(1.0, xi[0] * X + xi[1] * Y);
            }
            for (const bool is_P : {true, false}) {
                const nmbc::PlaneWave wave = nmbc::plane_wave(model, xi, is_P);
                const double omega = rate_of(scene) * std::sqrt(std::max(0.0, wave.omega_squared));
                const double along = wave.direction[scene.force->component];
                const double energy =
                    std::norm(shape) * along * along * spectral_energy(scene.force->history, omega);
                all += energy;
                lost += is_carried(model, xi, is_P) ? 0 : energy;
            }
        }
    }
    return all > 0 ? lost / all : 0;
}

}  // namespace nmbcrun
