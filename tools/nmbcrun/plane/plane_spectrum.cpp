// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include "tools/nmbcrun/plane/patch_spectrum.hpp"
#include "tools/nmbcrun/plane/plane_initial.hpp"
#include "tools/nmbcrun/sources/short_waves.hpp"
#include "tools/nmbcrun/sources/two_digits.hpp"

namespace nmbcrun {
namespace {

using std::numbers::pi;

constexpr double widest = 30;  // [dX], fits in a patch: what reaches farther has long waves

/// The spectrum of a lattice with nothing in it. Its waves take long to look at: it is made when it
/// is first asked for.
class EmptySpectrum {
  public:
    /// Of the scene only the lattice counts.
    explicit EmptySpectrum(const PlaneScene& scene) : scene_(scene) {}

    const PatchSpectrum& get() { return spectrum_ ? *spectrum_ : spectrum_.emplace(scene_); }

  private:
    const PlaneScene& scene_;
    std::optional<PatchSpectrum> spectrum_{};
};

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

/// Of the nodes of an endless lattice within a reach [length] of a centre.
template <class Gives>
Patch patch_about(const std::array<double, 2>& centre, double reach, double spacing,
                  const Gives& gives) {
    const double radius = reach / spacing * (1 + 1e-9);
    const std::array<double, 2> about{centre[0] / spacing, centre[1] / spacing};
    const auto first = [&](std::size_t axis) { return std::ceil(about[axis] - radius); };
    const auto last = [&](std::size_t axis) { return std::floor(about[axis] + radius); };
    Patch patch{.nx = std::size_t(std::max(0.0, last(0) - first(0) + 1))};
    for (double y = first(1); y <= last(1); ++y) {
        for (double x = first(0); x <= last(0); ++x) {
            const bool is_within = std::hypot(x - about[0], y - about[1]) <= radius;
            patch.gives.push_back(is_within ? gives(x * spacing, y * spacing) : StartOfNode{});
        }
    }
    return patch;
}

/// The square from node `first` of the scene on, tapered as in Welch's method: cut off, it would
/// have the short waves of its edges. Beyond its nodes a plane goes on as a mirror has it.
Patch tapered_patch(const PlaneSimulation& simulation, const std::array<std::ptrdiff_t, 2>& first) {
    const auto weight = [](std::size_t i) {
        const double sine = std::sin(pi * (double(i) + 0.5) / Patch::across);
        return sine * sine;
    };
    const auto node = [&](std::size_t axis, std::size_t i) {
        const auto n = std::ptrdiff_t(simulation.scene().nodes[axis]);
        const std::ptrdiff_t turned = (first[axis] + std::ptrdiff_t(i)) % (2 * n);
        const std::ptrdiff_t folded = turned < 0 ? turned + 2 * n : turned;
        return std::size_t(std::min(folded, 2 * n - 1 - folded));
    };
    Patch patch{.nx = Patch::across};
    for (std::size_t y = 0; y < Patch::across; ++y) {
        for (std::size_t x = 0; x < Patch::across; ++x) {
            const std::size_t entry = simulation.entry(node(0, x), node(1, y));
            const double w = weight(x) * weight(y);
            StartOfNode& start = patch.gives.emplace_back();
            for (const std::size_t a : {0U, 1U}) {
                start.u[a] = w * simulation.plane().displacement(a)[entry];
                start.v[a] = w * simulation.plane().velocity(a)[entry];
            }
        }
    }
    return patch;
}

/// Of a packet, whose transform is exp(-(width |xi - k|/2)^2).
double not_carried_of_packet(const PlaneScene& scene) {
    const PlaneInitial& initial = *scene.initial;
    constexpr int steps = 16;
    constexpr double farthest = 4;  // exp(-8) of the largest energy
    const double step = farthest / steps / (initial.width / scene.spacing);
    const double radians = initial.angle * pi / 180;
    const std::array<double, 2> k{initial.wave_number * std::cos(radians),
                                  initial.wave_number * std::sin(radians)};
    Waves waves(scene);
    const auto own = waves.wave(k, initial.is_P).direction;
    for (int y = -steps; y <= steps; ++y) {
        for (int x = -steps; x <= steps; ++x) {
            const auto folded = [](double xi) { return std::remainder(xi, 2 * pi); };
            const double r = farthest / steps * std::hypot(x, y);
            for (const bool is_P : {true, false}) {
                const PlaneLatticeWave wave =
                    waves.wave({folded(k[0] + x * step), folded(k[1] + y * step)}, is_P);
                const double along = wave.direction[0] * own[0] + wave.direction[1] * own[1];
                waves.add(wave, wave.omega * wave.omega * along * along * std::exp(-r * r / 2));
            }
        }
    }
    return waves.not_carried();
}

/// Of a field that was read from a file, in squares that overlap by half.
double not_carried_of_field(const PlaneSimulation& simulation, EmptySpectrum& empty) {
    constexpr std::ptrdiff_t apart = Patch::across / 2;
    const auto last = [&](std::size_t axis) {
        return std::ptrdiff_t(simulation.scene().nodes[axis]) - 1;
    };
    PatchSpectrum spectrum = empty.get();
    for (std::ptrdiff_t y = -apart; y <= last(1); y += apart) {
        for (std::ptrdiff_t x = -apart; x <= last(0); x += apart) {
            const Patch patch = tapered_patch(simulation, {x, y});
            if (patch.moves()) {
                spectrum.add(patch, [](double) { return 1.0; });
            }
        }
    }
    return spectrum.not_carried();
}

double not_carried_of_force(const PlaneScene& scene, EmptySpectrum& empty) {
    const PlaneForcing& force = *scene.force;
    if (force.half_width > widest * scene.spacing) {
        return 0;
    }
    StartOfNode alike;
    alike.v[force.component] = 1;
    PatchSpectrum spectrum = empty.get();
    spectrum.add(patch_about(force.centre, force.half_width, scene.spacing,
                             [&](double, double) { return alike; }),
                 [&](double omega) { return spectral_energy(force.history, omega); });
    return spectrum.not_carried();
}

double not_carried_of_initial(const PlaneScene& scene, EmptySpectrum& empty) {
    const PlaneInitial& initial = *scene.initial;
    if (initial.shape == PlaneShape::packet) {
        return not_carried_of_packet(scene);
    }
    constexpr double widths = 3;  // exp(-9)
    const double reach = (initial.shape == PlaneShape::cosine ? 1 : widths) * initial.width;
    if (reach > widest * scene.spacing) {
        return 0;
    }
    const InitialShape shape(scene);
    PatchSpectrum spectrum = empty.get();
    spectrum.add(patch_about(initial.centre, reach, scene.spacing,
                             [&](double x, double y) {
                                 return shape.at({x, y});
                             }),
                 [](double) { return 1.0; });
    return spectrum.not_carried();
}

/// "; KEY = VALUE would do", or that none would.
std::string what_would_do(PlaneScene scene, EmptySpectrum& empty) {
    const bool is_packet = scene.initial->shape == PlaneShape::packet;
    double& value = is_packet ? scene.initial->wave_number : scene.initial->width;
    const char* const key = is_packet ? "initial.wave_number" : "initial.width";
    const double own = value;
    for (double factor = 1.25; factor < 1e3; factor *= 1.25) {
        value = two_digits(is_packet ? own / factor : own * factor, is_packet);
        if (not_carried_of_initial(scene, empty) <= most_not_carried) {
            return fmt::format("; {} = {:.2g} would do", key, value);
        }
    }
    return fmt::format("; no {} within a factor of 1000 cures it", key);
}

std::string in_short_waves(double share, const char* source) {
    return fmt::format(
        "{:.0f} % of what {} sends out is in waves so short that the lattice disperses them or "
        "turns them back",
        100 * share, source);
}

}  // namespace

std::vector<std::string> warnings_of_short_waves(const PlaneSimulation& simulation) {
    const PlaneScene& scene = simulation.scene();
    EmptySpectrum empty(scene);
    std::vector<std::string> warnings;
    const bool is_read = scene.initial && scene.initial->shape == PlaneShape::file;
    if (scene.initial && !(is_read && simulation.plane().steps() > 0)) {
        const double share = is_read ? not_carried_of_field(simulation, empty)
                                     : not_carried_of_initial(scene, empty);
        if (share > most_not_carried) {
            warnings.push_back(in_short_waves(share, "initial") +
                               (is_read ? "; a smoother field or a finer lattice has less"
                                        : what_would_do(scene, empty)));
        }
    }
    if (scene.force) {
        const double share = not_carried_of_force(scene, empty);
        if (share > most_not_carried) {
            warnings.push_back(in_short_waves(share, "force") +
                               ", and their energy may stay: a longer force.duration, a larger "
                               "force.half_width or a finer lattice has less");
        }
    }
    return warnings;
}

}  // namespace nmbcrun
