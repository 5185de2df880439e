// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/predicted_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "generator/stability/reflection.hpp"
#include "tools/nmbcrun/certification/half_space.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

using Complex = std::complex<double>;

/// The waves on their way to an end that may get there in time. The weakest, which add up to less
/// than `negligible`, are left out.
std::vector<Arrival> arrivals(const Outgoing& outgoing, nmbc::End end, std::size_t nodes,
                              double negligible) {
    const bool left = end == nmbc::End::left;
    const auto way = double(left ? outgoing.from_left : outgoing.from_right);
    const double fastest = fastest_speed(outgoing);
    const auto more_trips =
        int(std::max(0.0, (fastest * outgoing.remaining - way) / double(nodes)));
    std::vector<Arrival> result;
    for (const WaveBand& band : outgoing.bands) {
        const bool forwards = left == band.is_backward;  // the phase goes right
        const Complex amplitude = forwards ? band.forwards : band.backwards;
        if (band.omega > 1e-6 && band.speed * outgoing.remaining >= way) {
            const double x = left ? 0 : double(nodes) - 1;
            result.push_back(
                {&band, amplitude * std::polar(1.0, (forwards ? x : -x) * band.xi), more_trips});
        }
    }
    const auto size = [](const Arrival& wave) { return std::abs(wave.amplitude); };
    std::ranges::sort(result, std::ranges::greater(), size);
    double left_out = 0;
    while (!result.empty() && left_out + size(result.back()) <= negligible) {
        left_out += size(result.back());
        result.pop_back();
    }
    return result;
}

/// Interior nodes, counted inwards from the end, at which what is sent back is looked at: waves
/// that add up to little at one may not at another.
constexpr std::array<int, 11> depths{0, 1, 2, 3, 5, 8, 13, 21, 34, 55, 89};
using AtDepths = std::array<Complex, depths.size()>;

/// What a wave is sent back as.
struct SentBack {
    AtDepths amplitudes;  ///< of all of it, over the wave's own at the outermost interior node
    double most =
        0;  ///< a bound of what any wave that arrives becomes on the other side of the chain
};

/// Nodes are counted inwards from the innermost ghost, and time goes as exp(+i omega t).
SentBack sent_back(const nmbcgen::Reflection& reflection, double xi, std::size_t nodes) {
    const auto& outgoing = reflection.outgoing;
    const auto k_of = [&](Eigen::Index mode) { return outgoing[std::size_t(mode)].k; };
    const auto distance = [&](Eigen::Index column) {
        const Complex k = k_of(column);
        return std::abs(std::polar(1.0, xi) - k) * std::abs(std::polar(1.0, -xi) - k);
    };
    const auto fading = [&](Eigen::Index mode) {
        return std::pow(std::abs(k_of(mode)), double(nodes));
    };
    Eigen::Index incident = 0;
    double most = 0;
    for (Eigen::Index column = 0; column < reflection.matrix.cols(); ++column) {
        incident = distance(column) < distance(incident) ? column : incident;
        double sum = 0;
        for (Eigen::Index o = 0; o < reflection.amplitudes.rows(); ++o) {
            sum += std::abs(reflection.amplitudes(o, column)) * fading(o);
        }
        constexpr double arrives = 1e-12;
        most = fading(column) > arrives ? std::max(most, sum) : most;
    }
    AtDepths amplitudes{};
    for (Eigen::Index o = 0; o < reflection.amplitudes.rows(); ++o) {
        for (std::size_t i = 0; i < depths.size(); ++i) {
            amplitudes[i] += reflection.amplitudes(o, incident) * k_of(incident) *
                             std::pow(k_of(o), depths[i] + 1);
        }
    }
    return {amplitudes, most};
}

/// most^2 + .. + most^(1 + trips): the second round trip, and those that follow.
double later_trips(double most, int trips) {
    double sum = 0;
    double power = most;
    for (int trip = 0; trip < trips && power > 0; ++trip) {
        power *= most;
        sum += power;
    }
    return sum;
}

/// When the first wave arrives, and when the run ends [dX/c].
struct Span {
    double first;
    double last;
};

/// max over these times of |Re sum amplitude exp(-i omega' t)|, omega' in time steps: of the first
/// 4000 times, ten in the shortest period, between two of which a crest rises by 5 %.
double largest_sum(std::vector<Arrival> waves, const Span& span, double time_step,
                   const Pause& pause) {
    double highest = 0;
    for (const Arrival& wave : waves) {
        highest = std::max(highest, frequency_in_steps(wave.band->omega, time_step));
    }
    if (highest == 0) {
        return 0;
    }
    constexpr double most_times = 4000;
    const double between = 2 * std::numbers::pi / highest / 10;
    std::vector<Complex> turns;
    turns.reserve(waves.size());
    for (Arrival& wave : waves) {
        const double omega = frequency_in_steps(wave.band->omega, time_step);
        turns.push_back(std::polar(1.0, -omega * between));
        wave.amplitude *= std::polar(1.0, -omega * span.first);
    }
    double largest = 0;
    const double last = std::min(span.last, span.first + most_times * between);
    for (double time = span.first; time <= last; time += between) {
        pause();
        double sum = 0;
        for (std::size_t i = 0; i < waves.size(); ++i) {
            sum += waves[i].amplitude.real();
            waves[i].amplitude *= turns[i];
        }
        largest = std::max(largest, std::abs(sum));
    }
    return largest;
}

Span span_of(const Outgoing& outgoing, nmbc::End end) {
    const auto way = double(end == nmbc::End::left ? outgoing.from_left : outgoing.from_right);
    const double fastest = fastest_speed(outgoing);
    return {fastest > 0 ? std::min(way / fastest, outgoing.remaining) : 0, outgoing.remaining};
}

}  // namespace

ReflectionError::ReflectionError(const Scene& scene, const Outgoing& outgoing, double negligible,
                                 const Pause& pause)
    : scene_(scene),
      outgoing_(outgoing),
      pause_(pause),
      left_(arrivals(outgoing, nmbc::End::left, scene.nodes, negligible * outgoing.largest)),
      right_(arrivals(outgoing, nmbc::End::right, scene.nodes, negligible * outgoing.largest)) {}

const nmbcgen::HalfSpace& ReflectionError::half_space(const Boundary& boundary) {
    const nmbc::MatchingTable& table = table_of(scene_, boundary);
    const auto found = half_spaces_.find(&table);
    return found != half_spaces_.end()
               ? found->second
               : half_spaces_.emplace(&table, half_space_of(table, scene_.G)).first->second;
}

double ReflectionError::of_both(double left, double right) const {
    const auto way = double(outgoing_.from_left + outgoing_.from_right + scene_.nodes);
    const bool meet = fastest_speed(outgoing_) * outgoing_.remaining >= way / 2;
    return (meet ? left + right : std::max(left, right)) / outgoing_.largest;
}

double ReflectionError::of(const Boundary& boundary, double time_step) {
    const nmbcgen::HalfSpace& in_time = half_space(boundary);
    if (modes_ == nullptr) {
        modes_ = std::make_unique<nmbcgen::KnownModes>(in_time);
    }
    const auto end = stepped(in_time, time_step, boundary.ghosts);
    const auto error_of = [&](const std::vector<Arrival>& waves, nmbc::End side) {
        double later = 0;
        std::vector<AtDepths> sent_back_at;
        sent_back_at.reserve(waves.size());
        for (const Arrival& wave : waves) {
            pause_();
            const double omega = wave.band->omega;
            const auto sent =
                sent_back(end.is_damped() ? nmbcgen::reflection(end, omega)
                                          : nmbcgen::reflection(end, omega, modes_->at(omega)),
                          wave.band->xi, scene_.nodes);
            later += std::abs(wave.amplitude) * later_trips(sent.most, wave.more_trips);
            sent_back_at.push_back(sent.amplitudes);
        }
        double largest = 0;
        for (std::size_t depth = 0; depth < depths.size(); ++depth) {
            if (std::size_t(depths[depth]) >= scene_.nodes) {
                break;
            }
            std::vector<Arrival> returned = waves;
            for (std::size_t i = 0; i < waves.size(); ++i) {
                returned[i].amplitude *= std::conj(sent_back_at[i][depth]);
            }
            largest = std::max(largest, largest_sum(std::move(returned), span_of(outgoing_, side),
                                                    time_step, pause_));
        }
        return later + largest;
    };
    return of_both(error_of(left_, nmbc::End::left), error_of(right_, nmbc::End::right));
}

double ReflectionError::of_fixed_ends(double time_step) const {
    const auto error_of = [&](const std::vector<Arrival>& waves, nmbc::End side) {
        double later = 0;
        for (const Arrival& wave : waves) {
            later += std::abs(wave.amplitude) * wave.more_trips;
        }
        return later + largest_sum(waves, span_of(outgoing_, side), time_step, pause_);
    };
    return of_both(error_of(left_, nmbc::End::left), error_of(right_, nmbc::End::right));
}

}  // namespace nmbcrun
