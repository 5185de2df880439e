// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/incoming_wave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/pulse.hpp"

namespace nmbcrun {
namespace {

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

std::size_t checked_period(double period, const Transform& transform) {
    constexpr double most = 1e5;
    const double components =
        period * std::min(transform.highest, std::numbers::pi) / (2 * std::numbers::pi);
    if (!(components <= most)) {
        throw SceneError(fmt::format(
            "incoming: a sum of {:.3g} waves would be needed to last for the run, and at most "
            "{:.0f} are taken: try a larger width, or an earlier time.end or incoming.arrival",
            components, most));
    }
    return 2 * std::size_t(std::ceil(period / 2));
}

}  // namespace

void add_incoming_wave(const Scene& scene, const nmbc::Lattice& lattice,
                       const nmbc::ChainParameters& p, std::size_t steps, Background& background) {
    if (!lattice.damping.empty()) {
        throw SceneError(
            "incoming: a damped lattice has no wave that comes from afar; model.damping must be 0");
    }
    const Incoming& incoming = *scene.incoming;
    const Boundary& boundary = incoming.end == nmbc::End::left ? scene.left : scene.right;
    const auto towards = incoming.end == nmbc::End::left ? nmbc::End::right : nmbc::End::left;
    const Transform transform = transform_of(incoming.pulse, 0, p.spacing);
    const double extent = extent_of(incoming.pulse, p.spacing);
    // Its speeds hardly depend on how finely the band is divided.
    const auto rough_period = std::size_t(std::max(4096.0, std::ceil(2 * extent)));
    const Speeds speeds = speeds_of(one_way_waves(transform, rough_period, towards, lattice, p));
    // How far from the outermost interior node an end may look, and to spare.
    const double near = double(boundary.layer) + 100.0 * scene.horizon;
    const double end = double(steps) * p.time_step;
    const double last = std::min(end, incoming.arrival + (extent + near) / speeds.lowest);
    // The copies of the pulse, a period ahead and behind, must not have been, or come, there.
    const double longest = std::max(incoming.arrival, last - incoming.arrival);
    const double period = speeds.highest * longest + 2 * extent + near;
    background.waves =
        one_way_waves(transform, checked_period(period, transform), towards, lattice, p);
    background.origin = incoming.end == nmbc::End::left ? 1 : double(scene.nodes);
    background.inside = extent;
    background.arrival = incoming.arrival / p.time_step;
    background.last_wave = last / p.time_step;
}

}  // namespace nmbcrun
