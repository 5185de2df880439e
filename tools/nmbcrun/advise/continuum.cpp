// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/continuum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "tools/nmbcrun/advise/wave_grid.hpp"
#include "tools/nmbcrun/sources/forcing.hpp"
#include "tools/nmbcrun/sources/nodes_within.hpp"
#include "tools/nmbcrun/sources/pulse.hpp"

namespace nmbcrun {
namespace {

using Complex = std::complex<double>;

/// Adds the waves of one source after the other. Units dX = c = 1 but for displacements; nodes are
/// counted from 0, the outermost interior one at the left, and go on beyond the interior.
class Superposition {
  public:
    Superposition(const Scene& scene, const Outgoing& outgoing)
        : scene_(scene),
          outgoing_(outgoing),
          unit_(unit_of_time(scene)),
          grid_(outgoing.nodes),
          outside_((outgoing.nodes - scene.nodes) / 2),
          waves_{std::vector<Complex>(grid_.bands()), std::vector<Complex>(grid_.bands())} {}

    void add_initial();
    void add_drive();
    void add_force(const Pause& pause);
    void add_incoming();
    const ContinuumWaves& waves() const { return waves_; }

  private:
    /// Of value(node), node counted as above.
    template <class Value>
    std::vector<Complex> amplitudes(Value value) {
        std::vector<double> field;
        field.reserve(outgoing_.nodes);
        for (std::size_t entry = 0; entry < outgoing_.nodes; ++entry) {
            field.push_back(value(double(entry) - double(outside_)));
        }
        std::vector<Complex> result = grid_.amplitudes(field);
        for (std::size_t band = 0; band < result.size(); ++band) {
            result[band] *= std::polar(1.0, grid_.wave_number(band) * double(outside_));
        }
        return result;
    }

    /// Of a node [length].
    double position(double node) const { return (node + 1) * scene_.spacing; }

    /// From a state u, v [length/(dX/c)] a time ago.
    void add_state(const std::vector<Complex>& u, const std::vector<Complex>& v, double ago) {
        for (std::size_t band = 0; band < u.size(); ++band) {
            const double xi = grid_.wave_number(band);
            const Complex turn = std::polar(1.0, -xi * ago);
            // u = a exp(-i xi t) + b exp(i xi t)
            const Complex from_v = Complex(0, 1) * v[band] / xi;
            waves_.forwards[band] += (u[band] + from_v) / 2.0 * turn;
            waves_.backwards[band] += std::conj((u[band] - from_v) / 2.0) * turn;
        }
    }

    /// From a shape that travels one way, a time ago.
    void add_one_way(const std::vector<Complex>& u, nmbc::End towards, double ago) {
        for (std::size_t band = 0; band < u.size(); ++band) {
            const Complex turn = std::polar(1.0, -grid_.wave_number(band) * ago);
            if (towards == nmbc::End::right) {
                waves_.forwards[band] += u[band] * turn;
            } else {
                waves_.backwards[band] += std::conj(u[band]) * turn;
            }
        }
    }

    const Scene& scene_;
    const Outgoing& outgoing_;
    double unit_;
    WaveGrid grid_;
    std::size_t outside_;
    ContinuumWaves waves_;
};

void Superposition::add_initial() {
    const Initial& initial = *scene_.initial;
    const bool is_velocity = initial.kind == InitialKind::velocity;
    const auto shape = amplitudes([&](double node) {
        return value_at(initial.pulse, position(node) - initial.centre, scene_.spacing) *
               (is_velocity ? unit_ : 1);
    });
    const std::vector<Complex> none(shape.size());
    if (initial.kind == InitialKind::to_the_right || initial.kind == InitialKind::to_the_left) {
        add_one_way(shape,
                    initial.kind == InitialKind::to_the_right ? nmbc::End::right : nmbc::End::left,
                    outgoing_.duration);
    } else {
        add_state(is_velocity ? none : shape, is_velocity ? shape : none, outgoing_.duration);
    }
}

void Superposition::add_drive() {
    const Drive& drive = *scene_.drive;
    const auto driven =
        nodes_within(scene_, drive.centre, drive.half_width * scene_.horizon * scene_.spacing);
    const double duration = drive.duration / unit_;
    const double let_go = std::min(duration, outgoing_.duration);
    // How long before it is let go the drive sent out what is at a node then.
    const auto phase = [&](double node) {
        const double way =
            std::max({double(driven.front()) - node, node - double(driven.back()), 0.0});
        return std::numbers::pi * std::max(let_go - way, 0.0) / duration;
    };
    const auto is_driven = [&](double node) {
        return node >= double(driven.front()) && node <= double(driven.back());
    };
    const auto u =
        amplitudes([&](double node) { return drive.amplitude / 2 * (1 - std::cos(phase(node))); });
    const auto v = amplitudes([&](double node) {
        const double speed = std::numbers::pi / duration * std::sin(phase(node));
        return is_driven(node) && let_go >= duration ? 0 : drive.amplitude / 2 * speed;
    });
    add_state(u, v, outgoing_.duration - let_go);
}

void Superposition::add_force(const Pause& pause) {
    const Forcing forcing(scene_, outgoing_.time_step * unit_);
    const auto nodes = nodes_within(scene_, scene_.force->centre, scene_.force->half_width);
    const auto place = amplitudes([&](double node) {
        return node >= double(nodes.front()) && node <= double(nodes.back()) ? 1.0 : 0.0;
    });
    // integral f(t) exp(i xi t) dt by the trapezoidal rule, finer than the highest wave number.
    const double duration = outgoing_.duration;
    const auto steps = std::size_t(std::max(1000.0, std::ceil(10 * duration)));
    const double step = duration / double(steps);
    std::vector<double> force;
    force.reserve(steps + 1);
    for (std::size_t i = 0; i <= steps; ++i) {
        const double weight = i == 0 || i == steps ? step / 2 : step;
        force.push_back(weight * forcing.force_at(double(i) * step * unit_) / scene_.density *
                        unit_ * unit_);
    }
    for (std::size_t band = 0; band < place.size(); ++band) {
        pause();
        const double xi = grid_.wave_number(band);
        const Complex turn = std::polar(1.0, xi * step);
        Complex sum = 0;
        for (std::size_t i = force.size(); i-- > 0;) {  // Horner
            sum = sum * turn + force[i];
        }
        // u = place integral f(s) sin(xi (t - s))/xi ds
        const Complex turned = std::polar(1.0, -xi * duration) / (2 * xi) * Complex(0, 1) * sum;
        waves_.forwards[band] += place[band] * turned;
        waves_.backwards[band] += std::conj(place[band]) * turned;
    }
}

void Superposition::add_incoming() {
    const Incoming& incoming = *scene_.incoming;
    const bool from_left = incoming.end == nmbc::End::left;
    const double since = outgoing_.duration - incoming.arrival / unit_;
    const double middle = from_left ? since : double(scene_.nodes) - 1 - since;
    const auto shape = amplitudes([&](double node) {
        return value_at(incoming.pulse, (node - middle) * scene_.spacing, scene_.spacing);
    });
    add_one_way(shape, from_left ? nmbc::End::right : nmbc::End::left, 0);
}

}  // namespace

ContinuumWaves continuum_waves(const Scene& scene, const Outgoing& outgoing, const Pause& pause) {
    Superposition sum(scene, outgoing);
    if (scene.initial) {
        sum.add_initial();
    }
    if (scene.drive) {
        sum.add_drive();
    }
    if (scene.force) {
        sum.add_force(pause);
    }
    if (scene.incoming) {
        sum.add_incoming();
    }
    return sum.waves();
}

}  // namespace nmbcrun
