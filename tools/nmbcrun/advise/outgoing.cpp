// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/outgoing.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

#include "tools/nmbcrun/compare/packet.hpp"
#include "tools/nmbcrun/compare/reference.hpp"
#include "tools/nmbcrun/compare/spectrum.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"
#include "tools/nmbcrun/simulation/tables.hpp"
#include "tools/nmbcrun/simulation/time_step.hpp"

namespace nmbcrun {
namespace {

constexpr std::size_t band_count = 2048;
constexpr double moves = 1e-13;  // of the largest |u|: what less reaches an end is a rounding

/// u^k and u^{k-1} as waves a exp(i(xi x - theta k)) + b exp(i(xi x + theta k)): a and b.
struct TwoWaves {
    std::complex<double> forwards;   // phases go right
    std::complex<double> backwards;  // phases go left
};

TwoWaves two_waves(std::complex<double> u, std::complex<double> before, double theta) {
    // u^{k-1} = a e^{i theta} + b e^{-i theta}
    const std::complex<double> turn = std::polar(1.0, theta);
    const std::complex<double> difference = turn - std::conj(turn);
    return {(before - u * std::conj(turn)) / difference, (u * turn - before) / difference};
}

}  // namespace

double angle_of_step(double omega, double time_step) {
    return 2 * std::asin(std::min(omega * time_step / 2, 1.0));
}

Outgoing outgoing_waves(const Scene& scene, double cfl) {
    const double time_step = 2 * cfl / highest_frequency(scene, lattice_of(scene));
    Simulation simulation(endless(scene, time_step));
    const nmbc::Chain& chain = simulation.chain();
    const nmbc::ChainParameters& p = chain.parameters();
    const double unit = p.spacing / p.wave_speed();
    const double step = p.time_step / unit;
    Outgoing result;
    do {
        simulation.step();
        for (const double u : interior(chain)) {
            result.largest = std::max(result.largest, std::abs(u));
        }
    } while (!simulation.is_done() && simulation.is_driven(chain.time()));
    result.duration = chain.time() / unit;
    result.remaining = std::max(0.0, scene.end - chain.time()) / unit;

    const auto u = chain.displacement();
    std::vector<double> before(u.begin(), u.end());
    for (std::size_t node = 0; node < before.size(); ++node) {
        before[node] -= p.time_step * chain.velocity()[node];
    }
    for (std::size_t band = 0; band < band_count; ++band) {
        const double xi = std::numbers::pi * (double(band) + 0.5) / band_count;
        const double omega = std::sqrt(std::max(nmbc::omega_squared(chain.lattice(), xi), 0.0));
        const double theta = angle_of_step(omega, step);
        if (std::sin(theta) < 1e-6) {
            continue;  // stands still
        }
        const double velocity = group_velocity(chain.lattice(), xi, 0);
        const TwoWaves waves = two_waves(fourier_sum(u, xi), fourier_sum(before, xi), theta);
        // u(x) = 1/(2 pi) integral over -pi .. pi, and real: Re of twice the half above 0.
        const auto from_first_interior =
            std::polar(1.0 / band_count, xi * double(chain.first_interior()));
        result.bands.push_back({xi, omega, std::abs(velocity), waves.forwards * from_first_interior,
                                std::conj(waves.backwards * from_first_interior), velocity < 0});
    }
    const auto field = interior(chain);
    const auto is_moving = [&](double value) { return std::abs(value) > moves * result.largest; };
    const auto first = std::ranges::find_if(field, is_moving);
    const auto last = std::find_if(field.rbegin(), field.rend(), is_moving);
    result.from_left = std::size_t(first - field.begin());
    result.from_right = std::size_t(last - field.rbegin());
    return result;
}

}  // namespace nmbcrun
