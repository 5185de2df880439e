// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "tools/nmbcrun/plane/plane_initial.hpp"
#include "tools/nmbcrun/plane/plane_lattice.hpp"
#include "tools/nmbcrun/sources/two_digits.hpp"

namespace nmbcrun {
namespace {

using std::numbers::pi;

constexpr double widest = 30;  // [dX]: what reaches farther has long waves

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

/// What a source gives a node, u and v or one of them, for its transforms.
struct OfNode {
    std::array<double, 2> place{};  ///< from the source's centre [dX]
    StartOfNode gives{};
};

/// Of the nodes of an endless lattice within a reach [length] of a centre.
template <class Gives>
std::vector<OfNode> nodes_about(const std::array<double, 2>& centre, double reach, double spacing,
                                const Gives& gives) {
    std::vector<OfNode> nodes;
    const double radius = reach / spacing * (1 + 1e-9);
    const auto about = [&](std::size_t axis) { return centre[axis] / spacing; };
    for (double y = std::ceil(about(1) - radius); y <= about(1) + radius; ++y) {
        for (double x = std::ceil(about(0) - radius); x <= about(0) + radius; ++x) {
            if (std::hypot(x - about(0), y - about(1)) <= radius) {
                nodes.push_back({{x - about(0), y - about(1)}, gives(x * spacing, y * spacing)});
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

/// Energy in waves of a lattice.
class Waves {
  public:
    explicit Waves(const PlaneScene& scene) : rate_(rate_of(scene)), model_(model_of(scene)) {}

    const nmbc::PlaneModel& model() const { return model_; }

    /// energy(wave, omega [1/time]): of the P and the S wave about xi, but for a factor.
    template <class Energy>
    void add(const std::array<double, 2>& xi, const Energy& energy) {
        for (const bool is_P : {true, false}) {
            const nmbc::PlaneWave wave = nmbc::plane_wave(model_, xi, is_P);
            const double one = energy(wave, rate_ * std::sqrt(std::max(0.0, wave.omega_squared)));
            all_ += one;
            lost_ += is_carried(model_, xi, is_P) ? 0 : one;
        }
    }

    /// The part in waves that the lattice does not carry.
    double not_carried() const { return all_ > 0 ? lost_ / all_ : 0; }

  private:
    double rate_;
    nmbc::PlaneModel model_;
    double all_ = 0;
    double lost_ = 0;
};

/// Of a source. weight(omega): what a wave has of the power of `gives.v`.
template <class Weight>
double not_carried(const PlaneScene& scene, const std::vector<OfNode>& nodes,
                   const Weight& weight) {
    constexpr int steps = 32;  // over half the zone
    Waves waves(scene);
    for (int y = 0; y < steps; ++y) {
        for (int x = -steps; x < steps; ++x) {
            const std::array<double, 2> xi{pi * (x + 0.5) / steps, pi * (y + 0.5) / steps};
            std::array<std::complex<double>, 2> u{};
            std::array<std::complex<double>, 2> v{};
            for (const OfNode& node : nodes) {
                const auto turn = std::polar(1.0, -xi[0] * node.place[0] - xi[1] * node.place[1]);
                for (const std::size_t a : {0U, 1U}) {
                    u[a] += turn * node.gives.u[a];
                    v[a] += turn * node.gives.v[a];
                }
            }
            waves.add(xi, [&](const nmbc::PlaneWave& wave, double omega) {
                const auto along = [&](const std::array<std::complex<double>, 2>& field) {
                    return std::norm(wave.direction[0] * field[0] + wave.direction[1] * field[1]);
                };
                return omega * omega * along(u) + weight(omega) * along(v);
            });
        }
    }
    return waves.not_carried();
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
    const auto own = nmbc::plane_wave(waves.model(), k, initial.is_P).direction;
    for (int y = -steps; y <= steps; ++y) {
        for (int x = -steps; x <= steps; ++x) {
            const auto folded = [](double xi) { return std::remainder(xi, 2 * pi); };
            const double r = farthest / steps * std::hypot(x, y);
            waves.add({folded(k[0] + x * step), folded(k[1] + y * step)},
                      [&](const nmbc::PlaneWave& wave, double omega) {
                          const double along =
                              wave.direction[0] * own[0] + wave.direction[1] * own[1];
                          return omega * omega * along * along * std::exp(-r * r / 2);
                      });
        }
    }
    return waves.not_carried();
}

double not_carried_of_force(const PlaneScene& scene) {
    const PlaneForcing& force = *scene.force;
    if (force.half_width > widest * scene.spacing) {
        return 0;
    }
    StartOfNode alike;
    alike.v[force.component] = 1;
    return not_carried(scene,
                       nodes_about(force.centre, force.half_width, scene.spacing,
                                   [&](double, double) { return alike; }),
                       [&](double omega) { return spectral_energy(force.history, omega); });
}

double not_carried_of_initial(const PlaneScene& scene) {
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
    return not_carried(scene,
                       nodes_about(initial.centre, reach, scene.spacing,
                                   [&](double x, double y) {
                                       return shape.at({x, y});
                                   }),
                       [](double) { return 1.0; });
}

constexpr double most_not_carried = 0.1;

/// "; KEY = VALUE would do", or that none would.
std::string what_would_do(PlaneScene scene) {
    const bool is_packet = scene.initial->shape == PlaneShape::packet;
    double& value = is_packet ? scene.initial->wave_number : scene.initial->width;
    const char* const key = is_packet ? "initial.wave_number" : "initial.width";
    const double own = value;
    for (double factor = 1.25; factor < 1e3; factor *= 1.25) {
        value = two_digits(is_packet ? own / factor : own * factor, is_packet);
        if (not_carried_of_initial(scene) <= most_not_carried) {
            return fmt::format("; {} = {:.2g} would do", key, value);
        }
    }
    return fmt::format("; no {} alone would do", key);
}

std::string in_short_waves(double share, const char* source) {
    return fmt::format(
        "{:.0f} % of what {} sends out is in waves so short that the lattice disperses them or "
        "turns them back",
        100 * share, source);
}

}  // namespace

std::vector<std::string> warnings_of_short_waves(const PlaneScene& scene) {
    std::vector<std::string> warnings;
    if (scene.initial && scene.initial->shape != PlaneShape::file) {
        const double share = not_carried_of_initial(scene);
        if (share > most_not_carried) {
            warnings.push_back(in_short_waves(share, "initial") + what_would_do(scene));
        }
    }
    if (scene.force) {
        const double share = not_carried_of_force(scene);
        if (share > most_not_carried) {
            warnings.push_back(in_short_waves(share, "force") +
                               ", and their energy may stay: a longer force.duration, a larger "
                               "force.half_width or a finer lattice has less");
        }
    }
    return warnings;
}

}  // namespace nmbcrun
