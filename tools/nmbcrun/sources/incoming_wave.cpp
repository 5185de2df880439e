// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/incoming_wave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tools/nmbcrun/ends/half_line.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/sources/pulse.hpp"

namespace nmbcrun {
namespace {

// Group velocities, in c, between which waves fade in. What does not move does not come in; and cut
// off at once it would leave a field that fades as 1/X only.
constexpr double slow = 0.05;
constexpr double fast = 0.15;

/// The pulse's waves of this period, those that come in.
std::vector<LatticeWave> waves_of(const Scene& scene, const Transform& transform, double period,
                                  const nmbc::Lattice& lattice, const nmbc::ChainParameters& p) {
    const auto towards =
        scene.incoming->end == nmbc::End::left ? nmbc::End::right : nmbc::End::left;
    const double c = p.wave_speed() / p.spacing;
    auto waves =
        one_way_waves(transform, 2 * std::size_t(std::ceil(period / 2)), towards, lattice, p);
    for (LatticeWave& wave : waves) {
        wave.amplitude *= share_of_incoming(std::abs(wave.group_velocity) / c);
    }
    std::erase_if(waves, [](const LatticeWave& wave) { return wave.amplitude == 0.0; });
    return waves;
}

/// Group velocities of what matters [dX/time].
struct Speeds {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = 0;
};

Speeds speeds_of(const std::vector<LatticeWave>& waves) {
    double largest = 0;
    for (const LatticeWave& wave : waves) {
        largest = std::max(largest, std::abs(wave.amplitude));
    }
    Speeds speeds;
    for (const LatticeWave& wave : waves) {
        constexpr double nothing = 1e-14;
        if (std::abs(wave.amplitude) > nothing * largest) {
            speeds.lowest = std::min(speeds.lowest, std::abs(wave.group_velocity));
            speeds.highest = std::max(speeds.highest, std::abs(wave.group_velocity));
        }
    }
    return speeds;
}

void require_few(double period, const Transform& transform) {
    constexpr double most = 1e5;
    const double components =
        period * std::min(transform.highest, std::numbers::pi) / (2 * std::numbers::pi);
    if (!(components <= most)) {
        throw SceneError(fmt::format(
            "incoming: a sum of {:.3g} waves would be needed to last for the run, and at most "
            "{:.0f} are taken: try a larger width, or an earlier time.end or incoming.arrival",
            components, most));
    }
}

}  // namespace

// It rises with all derivatives.
double share_of_incoming(double speed) {
    const auto rise = [](double x) { return x > 0 ? std::exp(-1 / x) : 0.0; };
    const double x = (speed - slow) / (fast - slow);
    return rise(x) / (rise(x) + rise(1 - x));
}

void add_incoming_wave(const Scene& scene, const nmbc::Lattice& lattice,
                       const nmbc::ChainParameters& p, std::size_t steps, IncidentField& incident) {
    if (!lattice.damping.empty()) {
        throw SceneError(
            "incoming: a damped lattice has no wave that comes from afar; model.damping must be 0");
    }
    const Incoming& incoming = *scene.incoming;
    const Boundary& boundary = incoming.end == nmbc::End::left ? scene.left : scene.right;
    const Transform transform = transform_of(incoming.pulse, 0, p.spacing);
    const double extent = extent_of(incoming.pulse, p.spacing);
    // Its speeds hardly depend on how finely the band is divided.
    const double rough_period = std::max(4096.0, 2 * extent);
    const auto rough = waves_of(scene, transform, rough_period, lattice, p);
    if (rough.empty()) {
        throw SceneError(fmt::format(
            "incoming: none of its waves has a group velocity above {} c, so nothing comes in",
            slow));
    }
    const Speeds speeds = speeds_of(rough);
    // How far from the outermost interior node an end may look, and to spare.
    const double unit = p.spacing / p.wave_speed();
    const std::size_t layer = layer_of(scene, boundary, lattice, p.time_step / unit);
    const double near =
        double(layer + 2 * lattice.reach()) + double(boundary.order) * boundary.stride + 10;
    const double end = double(steps) * p.time_step;
    // Where waves are faded in, the pulse has tails.
    const bool has_tails = speeds.lowest < fast * p.wave_speed() / p.spacing;
    const double reach = extent + (has_tails ? 1000 : 0);
    const double last = std::min(end, incoming.arrival + (reach + near) / speeds.lowest);
    // The copies of the pulse, a period ahead and behind, must not have been, or come, there.
    const double longest = std::max(incoming.arrival, last - incoming.arrival);
    const double period = speeds.highest * longest + 2 * reach + near;
    require_few(period, transform);
    incident.waves = waves_of(scene, transform, period, lattice, p);
    incident.origin = incoming.end == nmbc::End::left ? 1 : double(scene.nodes);
    incident.inside = reach;
    incident.arrival = incoming.arrival / p.time_step;
    incident.last_wave = last / p.time_step;
}

}  // namespace nmbcrun
