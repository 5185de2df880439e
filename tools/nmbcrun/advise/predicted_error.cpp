// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/predicted_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "generator/stability/half_space.hpp"
#include "generator/stability/reflection.hpp"
#include "tools/nmbcrun/simulation/exact_table.hpp"
#include "tools/nmbcrun/simulation/tables.hpp"

namespace nmbcrun {
namespace {

using Complex = std::complex<double>;

/// A wave that has come to an end, as Re amplitude exp(-i omega t) at its outermost interior node.
struct Arrival {
    const WaveBand* band;
    Complex amplitude;
};

/// The waves on their way to an end that may get there in time.
std::vector<Arrival> arrivals(const Outgoing& outgoing, nmbc::End end, std::size_t nodes) {
    const bool left = end == nmbc::End::left;
    const auto way = double(left ? outgoing.from_left : outgoing.from_right);
    std::vector<Arrival> result;
    for (const WaveBand& band : outgoing.bands) {
        const bool forwards = left == band.is_backward;  // the phase goes right
        const Complex amplitude = forwards ? band.forwards : band.backwards;
        const bool counts = std::abs(amplitude) > 1e-12 * outgoing.largest;
        if (counts && band.speed * outgoing.remaining >= way) {
            const double x = left ? 0 : double(nodes) - 1;
            result.push_back({&band, amplitude * std::polar(1.0, (forwards ? x : -x) * band.xi)});
        }
    }
    return result;
}

/// All that an incident wave is sent back as, over what it is itself at the outermost interior
/// node. Nodes are counted inwards from the innermost ghost, and time goes as exp(+i omega t).
Complex sent_back(const nmbcgen::Reflection& reflection, double xi) {
    const auto& outgoing = reflection.outgoing;
    const auto distance = [&](Eigen::Index column) {
        const Complex k = outgoing[std::size_t(column)].k;
        return std::abs(std::polar(1.0, xi) - k) * std::abs(std::polar(1.0, -xi) - k);
    };
    Eigen::Index incident = 0;
    for (Eigen::Index column = 1; column < reflection.matrix.cols(); ++column) {
        incident = distance(column) < distance(incident) ? column : incident;
    }
    const Complex inverse_incident = outgoing[std::size_t(incident)].k;
    Complex sum = 0;
    for (std::size_t o = 0; o < outgoing.size(); ++o) {
        sum += reflection.amplitudes(Eigen::Index(o), incident) * outgoing[o].k;
    }
    return sum * inverse_incident;
}

/// max over 0 <= t <= duration of |Re sum amplitude exp(-i omega' t)|, omega' in time steps.
double largest_sum(std::vector<Arrival> waves, double duration, double time_step) {
    constexpr double between = 0.5;  // [dX/c]: 1/5 of the shortest period of nopd1d at G <= 1
    constexpr double most = 4000;
    std::vector<Complex> turns;
    turns.reserve(waves.size());
    for (const Arrival& wave : waves) {
        const double omega = angle_of_step(wave.band->omega, time_step) / time_step;
        turns.push_back(std::polar(1.0, -omega * between));
    }
    double largest = 0;
    for (double time = 0; time <= std::min(duration, most * between); time += between) {
        double sum = 0;
        for (std::size_t i = 0; i < waves.size(); ++i) {
            sum += waves[i].amplitude.real();
            waves[i].amplitude *= turns[i];
        }
        largest = std::max(largest, std::abs(sum));
    }
    return largest;
}

}  // namespace

/// Waves of an undamped lattice, which all its boundaries share.
struct ReflectionError::Modes {
    explicit Modes(nmbcgen::HalfSpace any) : half_space(std::move(any)), known(half_space) {}

    nmbcgen::HalfSpace half_space;
    nmbcgen::KnownModes known;
};

ReflectionError::ReflectionError(const Scene& scene, const Outgoing& outgoing)
    : scene_(scene), outgoing_(outgoing) {}

ReflectionError::~ReflectionError() = default;

double ReflectionError::of(const Boundary& boundary, double time_step) {
    auto half_space =
        make_half_space(exact_table(table_of(scene_, boundary)), nmbcgen::Rational(scene_.G));
    if (modes_ == nullptr) {
        modes_ = std::make_unique<Modes>(half_space);
    }
    const auto in_steps =
        stepped(std::move(half_space), time_step,
                boundary.ghosts == nmbc::GhostRule::midpoint ? nmbcgen::GhostLevel::midpoint
                                                             : nmbcgen::GhostLevel::old);
    double error = 0;
    for (const nmbc::End end : {nmbc::End::left, nmbc::End::right}) {
        std::vector<Arrival> waves = arrivals(outgoing_, end, scene_.nodes);
        for (Arrival& wave : waves) {
            const auto reflection = in_steps.is_damped()
                                        ? nmbcgen::reflection(in_steps, wave.band->omega)
                                        : nmbcgen::reflection(in_steps, wave.band->omega,
                                                              modes_->known.at(wave.band->omega));
            wave.amplitude *= std::conj(sent_back(reflection, wave.band->xi));
        }
        error = std::max(error, largest_sum(std::move(waves), outgoing_.remaining, time_step));
    }
    return error / outgoing_.largest;
}

double ReflectionError::of_fixed_ends(double time_step) const {
    double error = 0;
    for (const nmbc::End end : {nmbc::End::left, nmbc::End::right}) {
        error = std::max(error, largest_sum(arrivals(outgoing_, end, scene_.nodes),
                                            outgoing_.remaining, time_step));
    }
    return error / outgoing_.largest;
}

double time_error(const Outgoing& outgoing, std::size_t nodes, double time_step) {
    constexpr int times = 40;
    constexpr std::size_t most_nodes_looked_at = 256;
    const std::size_t every = 1 + nodes / most_nodes_looked_at;
    double error = 0;
    for (int i = 1; i <= times; ++i) {
        const double time = outgoing.duration / 2 + outgoing.remaining * i / times;
        // Re b exp(-i xi x) = Re conj(b) exp(i xi x)
        std::vector<Complex> differences;
        std::vector<Complex> turns;  // from one node looked at to the next
        differences.reserve(outgoing.bands.size());
        turns.reserve(outgoing.bands.size());
        for (const WaveBand& band : outgoing.bands) {
            const double omega = angle_of_step(band.omega, time_step) / time_step;
            const Complex late =
                std::polar(1.0, -omega * time) - std::polar(1.0, -band.omega * time);
            differences.push_back(band.forwards * late + std::conj(band.backwards * late));
            turns.push_back(std::polar(1.0, band.xi * double(every)));
        }
        for (std::size_t node = 0; node < nodes; node += every) {
            double sum = 0;
            for (std::size_t b = 0; b < differences.size(); ++b) {
                sum += differences[b].real();
                differences[b] *= turns[b];
            }
            error = std::max(error, std::abs(sum));
        }
    }
    return error / outgoing.largest;
}

}  // namespace nmbcrun
