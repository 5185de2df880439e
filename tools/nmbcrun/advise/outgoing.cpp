// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/outgoing.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>

#include "tools/nmbcrun/advise/wave_grid.hpp"
#include "tools/nmbcrun/compare/packet.hpp"
#include "tools/nmbcrun/compare/reference.hpp"
#include "tools/nmbcrun/ends/silent_layer.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"
#include "tools/nmbcrun/sources/incoming_wave.hpp"
#include "tools/nmbcrun/sources/pulse.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

using Complex = std::complex<double>;

constexpr double moves = 1e-12;  // of the largest |u|: what is less may be a rounding

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

/// u a time after the sources, in continuous time.
std::vector<double> field_after(WaveGrid& grid, const Outgoing& outgoing, double time) {
    std::vector<Complex> waves;
    waves.reserve(outgoing.bands.size());
    for (const WaveBand& band : outgoing.bands) {
        const Complex turn = std::polar(1.0, -band.omega * time);
        // Re b exp(-i xi x) = Re conj(b) exp(i xi x)
        waves.push_back(band.forwards * turn + std::conj(band.backwards * turn));
    }
    return grid.field(waves);
}

/// Until when the sources act [dX/c]; of a file's force until the end of the run.
double duration_of_sources(const Scene& scene) {
    double last = scene.drive ? scene.drive->duration : 0;
    if (scene.force) {
        constexpr double widths = 6.5;  // exp(-42), times the 84 of a ricker
        const Force& force = *scene.force;
        last = std::max(last, force.history == History::file ? scene.end
                              : force.history == History::sine
                                  ? force.time + force.cycles / force.frequency
                                  : force.time + widths * force.duration);
    }
    last = scene.incoming ? std::max(last, scene.incoming->arrival) : last;
    return last / unit_of_time(scene);
}

/// Between layers so wide that nothing returns from them in any steps while the waves are followed,
/// and what the sources send out is all inside. Up to cfl = 0.8 the speed lies
/// between; near 1 that of the shortest waves goes up steeply, but only theirs.
Scene between_layers(Scene scene) {
    const nmbc::Lattice lattice = lattice_of(scene);
    const double omega_max = nmbc::maximum_frequency(lattice);
    const double unit = unit_of_time(scene);
    std::size_t width = 0;
    const double duration =
        std::min(scene.end / unit, 3 * duration_of_sources(scene) + time_to_follow(scene));
    for (const double cfl : {1e-3, 0.8 * nmbc::interior_cfl(lattice)}) {
        width = std::max(width, silent_layer(lattice, 2 * cfl / omega_max, duration));
    }
    width += scene.incoming ? std::size_t(extent_of(scene.incoming->pulse, scene.spacing)) : 0;
    scene.left = {.kind = BoundaryKind::extended, .layer = width};
    scene.right = scene.left;
    scene.cfl.reset();
    scene.preload.reset();
    scene.incoming.reset();
    return scene;
}

}  // namespace

double frequency_in_steps(double omega, double time_step) {
    return 2 / time_step * std::asin(std::min(omega * time_step / 2, 1.0));
}

double time_to_follow(const Scene& scene) {
    constexpr double slowest = 0.1;
    constexpr double least = 1000;
    const int physical = Mirrors(scene).count();
    return physical == 2 ? scene.end / unit_of_time(scene)  // nothing ever leaves
                         : std::max(least, double(scene.nodes) / slowest) * (1 + physical);
}

double largest_after(const Outgoing& outgoing, const Mirrors& mirrors) {
    constexpr int times = 8;
    WaveGrid grid(outgoing.nodes);
    double largest = 0;
    for (int i = 0; i <= times; ++i) {
        const double time = outgoing.followed * double(i) / times;
        for (const double u : mirrors.folded(field_after(grid, outgoing, time))) {
            largest = std::max(largest, std::abs(u));
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

EndlessScene::EndlessScene(const Scene& scene, const Pause& pause)
    : scene_(between_layers(scene)),
      pause_(pause),
      incoming_(scene.incoming),
      unit_(unit_of_time(scene)),
      followed_(time_to_follow(scene)),
      omega_max_(nmbc::maximum_frequency(lattice_of(scene))),
      grid_(scene.nodes + 2 * (scene_.left.layer + lattice_of(scene).reach())) {
    const nmbc::Lattice lattice = lattice_of(scene);
    at_rest_.reserve(grid_.bands());
    for (std::size_t band = 0; band < grid_.bands(); ++band) {
        const double xi = grid_.wave_number(band);
        const double velocity = group_velocity(lattice, xi, 0);
        at_rest_.push_back({.xi = xi,
                            .omega = std::sqrt(std::max(nmbc::omega_squared(lattice, xi), 0.0)),
                            .speed = std::abs(velocity),
                            .forwards = {},
                            .backwards = {},
                            .is_backward = velocity < 0});
    }
}

Outgoing EndlessScene::outgoing(double cfl) {
    Scene scene = scene_;
    scene.step = 2 * cfl / omega_max_ * unit_;
    Simulation simulation(scene);
    const nmbc::Chain& chain = simulation.chain();
    Outgoing result{.bands = at_rest_, .nodes = chain.nodes(), .time_step = *scene.step / unit_};
    do {
        pause_();
        simulation.step();
        for (const double u : interior(chain)) {
            result.largest = std::max(result.largest, std::abs(u));
        }
    } while (!simulation.is_done() && (simulation.is_driven(chain.time()) ||
                                       (incoming_ && chain.time() < incoming_->arrival)));
    result.duration = chain.time() / unit_;
    result.remaining = std::max(0.0, scene.end - chain.time()) / unit_;
    result.followed = std::min(result.remaining, followed_);
    add_waves(chain, result);
    if (incoming_) {
        add_incoming(result);
    }
    std::vector<double> field = field_after(grid_, result, 0);
    field.resize(scene.nodes);
    const double size = std::abs(
        *std::ranges::max_element(field, {}, [](double value) { return std::abs(value); }));
    const auto is_moving = [size](double value) { return std::abs(value) > moves * size; };
    const auto first = std::ranges::find_if(field, is_moving);
    const auto last = std::find_if(field.rbegin(), field.rend(), is_moving);
    result.from_left = std::size_t(first - field.begin());
    result.from_right = std::size_t(last - field.rbegin());
    return result;
}

void EndlessScene::add_waves(const nmbc::Chain& chain, Outgoing& outgoing) {
    const auto u = chain.displacement();
    std::vector<double> before(u.begin(), u.end());
    for (std::size_t node = 0; node < before.size(); ++node) {
        before[node] -= chain.parameters().time_step * chain.velocity()[node];
    }
    const auto u_waves = grid_.amplitudes(u);
    const auto before_waves = grid_.amplitudes(before);
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

void EndlessScene::add_incoming(Outgoing& outgoing) {
    const bool from_left = incoming_->end == nmbc::End::left;
    const std::size_t outside = (outgoing.nodes - scene_.nodes) / 2;
    const double middle = double(outside) + (from_left ? 0 : double(scene_.nodes) - 1);
    std::vector<double> shape;
    shape.reserve(outgoing.nodes);
    for (std::size_t entry = 0; entry < outgoing.nodes; ++entry) {
        shape.push_back(
            value_at(incoming_->pulse, (double(entry) - middle) * scene_.spacing, scene_.spacing));
    }
    const auto amplitudes = grid_.amplitudes(shape);
    const double since = outgoing.duration - incoming_->arrival / unit_;
    for (std::size_t band = 0; band < outgoing.bands.size(); ++band) {
        WaveBand& own = outgoing.bands[band];
        const double half_angle = std::min(own.omega * outgoing.time_step / 2, 1 - 1e-12);
        const double speed = own.speed / std::sqrt(1 - half_angle * half_angle);
        const Complex at_arrival =
            amplitudes[band] * std::polar(1.0, own.xi * double(outside)) * share_of_incoming(speed);
        const Complex turn =
            std::polar(1.0, -frequency_in_steps(own.omega, outgoing.time_step) * since);
        if (from_left != own.is_backward) {  // phases go right
            own.forwards += at_arrival * turn;
        } else {
            own.backwards += std::conj(at_arrival) * turn;
        }
    }
}

}  // namespace nmbcrun
