// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/outgoing.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>

#include "tools/nmbcrun/advise/wave_grid.hpp"
#include "tools/nmbcrun/compare/packet.hpp"
#include "tools/nmbcrun/compare/reference.hpp"
#include "tools/nmbcrun/simulation/silent_layer.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"
#include "tools/nmbcrun/simulation/tables.hpp"

namespace nmbcrun {
namespace {

using Complex = std::complex<double>;

constexpr double moves = 1e-13;  // of the largest |u|: what less reaches an end is a rounding

/// u^k and u^{k-1} as waves a exp(i(xi x - theta k)) + b exp(i(xi x + theta k)): a and b.
struct TwoWaves {
    Complex forwards;   // phases go right
    Complex backwards;  // phases go left
};

TwoWaves two_waves(Complex u, Complex before, double theta) {
    // u^{k-1} = a e^{i theta} + b e^{-i theta}
    const Complex turn = std::polar(1.0, theta);
    const Complex difference = turn - std::conj(turn);
    if (std::abs(difference) < 2e-6) {
        return {u / 2.0, u / 2.0};  // stands still
    }
    return {(before - u * std::conj(turn)) / difference, (u * turn - before) / difference};
}

void add_waves(const nmbc::Chain& chain, Outgoing& outgoing) {
    WaveGrid grid(chain.nodes());
    const auto u = chain.displacement();
    std::vector<double> before(u.begin(), u.end());
    for (std::size_t node = 0; node < before.size(); ++node) {
        before[node] -= chain.parameters().time_step * chain.velocity()[node];
    }
    const auto u_waves = grid.amplitudes(u);
    const auto before_waves = grid.amplitudes(before);
    for (std::size_t band = 0; band < outgoing.bands.size(); ++band) {
        WaveBand& own = outgoing.bands[band];
        const TwoWaves waves =
            two_waves(u_waves[band], before_waves[band],
                      frequency_in_steps(own.omega, outgoing.time_step) * outgoing.time_step);
        const Complex from_first_interior =
            std::polar(1.0, own.xi * double(chain.first_interior()));
        own.forwards = waves.forwards * from_first_interior;
        own.backwards = std::conj(waves.backwards * from_first_interior);
    }
}

/// So wide that nothing returns in any steps. Up to cfl = 0.8 the speed lies between; near 1 that
/// of the shortest waves goes up steeply, but only theirs.
std::size_t width_of_layers(const nmbc::Lattice& lattice, double omega_max, double duration) {
    std::size_t width = 0;
    for (const double cfl : {1e-3, 0.8 * nmbc::interior_cfl(lattice)}) {
        width = std::max(width, silent_layer(lattice, 2 * cfl / omega_max, duration));
    }
    return width;
}

}  // namespace

double frequency_in_steps(double omega, double time_step) {
    return 2 / time_step * std::asin(std::min(omega * time_step / 2, 1.0));
}

double largest_after(const Outgoing& outgoing, std::size_t interior_nodes) {
    constexpr int times = 8;
    WaveGrid grid(outgoing.nodes);
    double largest = 0;
    for (int i = 1; i <= times; ++i) {
        std::vector<Complex> waves;
        waves.reserve(outgoing.bands.size());
        for (const WaveBand& band : outgoing.bands) {
            const Complex turn =
                std::polar(1.0, -band.omega * outgoing.remaining * double(i) / times);
            // Re b exp(-i xi x) = Re conj(b) exp(i xi x)
            waves.push_back(band.forwards * turn + std::conj(band.backwards * turn));
        }
        const auto field = grid.field(waves);
        for (std::size_t node = 0; node < interior_nodes; ++node) {
            largest = std::max(largest, std::abs(field[node]));
        }
    }
    return largest;
}

double fastest_speed(const Outgoing& outgoing) {
    const double matters = 1e-3 / double(outgoing.bands.size());
    double fastest = 0;
    for (const WaveBand& band : outgoing.bands) {
        const double size = std::max(std::abs(band.forwards), std::abs(band.backwards));
        fastest = size > matters * outgoing.largest ? std::max(fastest, band.speed) : fastest;
    }
    return fastest;
}

EndlessScene::EndlessScene(const Scene& scene)
    : scene_(scene), unit_(scene.spacing / std::sqrt(scene.youngs_modulus / scene.density)) {
    const nmbc::Lattice lattice = lattice_of(scene);
    omega_max_ = nmbc::maximum_frequency(lattice);
    const std::size_t layer = width_of_layers(lattice, omega_max_, scene.end / unit_);
    scene_.left = {.kind = BoundaryKind::extended, .layer = layer};
    scene_.right = scene_.left;
    scene_.cfl.reset();
    scene_.preload.reset();
    const WaveGrid grid(scene.nodes + 2 * (layer + lattice.reach()));
    at_rest_.reserve(grid.bands());
    for (std::size_t band = 0; band < grid.bands(); ++band) {
        const double xi = grid.wave_number(band);
        const double velocity = group_velocity(lattice, xi, 0);
        at_rest_.push_back({.xi = xi,
                            .omega = std::sqrt(std::max(nmbc::omega_squared(lattice, xi), 0.0)),
                            .speed = std::abs(velocity),
                            .forwards = {},
                            .backwards = {},
                            .is_backward = velocity < 0});
    }
}

Outgoing EndlessScene::outgoing(double cfl) const {
    Scene scene = scene_;
    scene.step = 2 * cfl / omega_max_ * unit_;
    Simulation simulation(scene);
    const nmbc::Chain& chain = simulation.chain();
    Outgoing result{.bands = at_rest_, .nodes = chain.nodes(), .time_step = *scene.step / unit_};
    do {
        simulation.step();
        for (const double u : interior(chain)) {
            result.largest = std::max(result.largest, std::abs(u));
        }
    } while (!simulation.is_done() && simulation.is_driven(chain.time()));
    result.duration = chain.time() / unit_;
    result.remaining = std::max(0.0, scene.end - chain.time()) / unit_;
    add_waves(chain, result);
    const auto field = interior(chain);
    const auto is_moving = [&](double value) { return std::abs(value) > moves * result.largest; };
    const auto first = std::ranges::find_if(field, is_moving);
    const auto last = std::find_if(field.rbegin(), field.rend(), is_moving);
    result.from_left = std::size_t(first - field.begin());
    result.from_right = std::size_t(last - field.rbegin());
    return result;
}

}  // namespace nmbcrun
