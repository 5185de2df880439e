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

/// By way of a physical end, where there is one. [dX]
double way_between_ends(const Scene& scene) {
    return double(scene.nodes) * (1 + Mirrors(scene).count());
}

/// How long before the sources have ended their waves may have begun to come to an end: where the
/// nodes in front of it, `at_rest` of them, do not rest then, from the beginning on.
double before_sources_end(std::size_t at_rest, const Outgoing& outgoing) {
    return at_rest == 0 ? outgoing.duration : 0;
}

/// The waves on their way to an end that may get there in time. The weakest, which add up to less
/// than `negligible`, are left out. mirrored: those that go the other way first, to a physical end.
Arrivals arrivals(const Scene& scene, const Outgoing& outgoing, nmbc::End end, bool mirrored,
                  double negligible) {
    const auto nodes = double(scene.nodes);
    const bool left = end == nmbc::End::left;
    const bool to_left = left != mirrored;
    const double way =
        double(to_left ? outgoing.from_left : outgoing.from_right) + (mirrored ? nodes : 0);
    const double fastest = fastest_speed(outgoing);
    const double before =
        before_sources_end(to_left ? outgoing.from_left : outgoing.from_right, outgoing);
    const double time = before + outgoing.remaining;
    const double round = way_between_ends(scene);
    const double extent = nodes - double(outgoing.from_left + outgoing.from_right);
    const double more_trips = std::max(0.0, (fastest * time - way) / round);
    Arrivals arrivals{
        .waves = {},
        .first = fastest > 0 ? std::min(way / fastest - before, outgoing.followed) : 0,
        .last = outgoing.followed};
    std::vector<Arrival>& result = arrivals.waves;
    for (const WaveBand& band : outgoing.bands) {
        const bool forwards = to_left == band.is_backward;  // the phase goes right
        const Complex amplitude = forwards ? band.forwards : band.backwards;
        if (band.omega > 1e-6 && band.speed * time >= way) {
            const double x = (to_left ? 0 : nodes - 1) + (!mirrored ? 0 : to_left ? -nodes : nodes);
            const double at_a_time = std::ceil((extent + band.speed * outgoing.duration) / round);
            result.push_back({&band, amplitude * std::polar(1.0, (forwards ? x : -x) * band.xi),
                              int(std::min(more_trips, at_a_time))});
        }
    }
    const auto size = [](const Arrival& wave) { return std::abs(wave.amplitude); };
    std::ranges::sort(result, std::ranges::greater(), size);
    double left_out = 0;
    while (!result.empty() && left_out + size(result.back()) <= negligible) {
        left_out += size(result.back());
        result.pop_back();
    }
    return arrivals;
}

/// At an artificial end: what comes directly, and by way of a physical one opposite.
std::vector<Arrivals> all_arrivals(const Scene& scene, const Outgoing& outgoing, nmbc::End end,
                                   double negligible) {
    const bool left = end == nmbc::End::left;
    if (is_physical((left ? scene.left : scene.right).kind)) {
        return {};
    }
    std::vector<Arrivals> all{arrivals(scene, outgoing, end, false, negligible)};
    if (is_physical((left ? scene.right : scene.left).kind)) {
        all.push_back(arrivals(scene, outgoing, end, true, negligible));
    }
    return all;
}

/// Interior nodes, counted inwards from the end, at which what is sent back is looked at: waves
/// that add up to little at one may not at another.
constexpr std::array<int, 11> depths{0, 1, 2, 3, 5, 8, 13, 21, 34, 55, 89};
using AtDepths = std::array<Complex, depths.size()>;

/// What a wave is sent back as, over the wave's own amplitude at the outermost interior node.
struct SentBack {
    AtDepths amplitudes;  ///< of all of it
    double later = 0;     ///< largest of these, of what comes back again, added up over the trips
};

/// Nodes are counted inwards from the innermost ghost, and time goes as exp(+i omega t). A trip
/// takes all waves of one frequency to an equal end opposite, `way` nodes, and back from it
/// reflected: their phases and what has faded on the way included, so that of ends which pass on
/// no more energy than arrives, no trip does.
SentBack sent_back(const WavesSentBack& waves, double way, int later_trips) {
    using Vector = Eigen::VectorXcd;
    const auto k = Eigen::Map<const Vector>(waves.k.data(), waves.amplitudes.rows());
    const auto at_depths = [&](const Vector& sent) {
        AtDepths amplitudes{};
        for (std::size_t i = 0; i < depths.size(); ++i) {
            for (Eigen::Index o = 0; o < sent.size(); ++o) {
                amplitudes[i] += sent(o) * std::pow(k(o), depths[i] + 1);
            }
        }
        return amplitudes;
    };
    const Vector crossed = k.head(waves.amplitudes.cols()).unaryExpr([way](const Complex& one) {
        return std::pow(one, way + 1);
    });
    Vector sent = waves.amplitudes.col(waves.column) * k(waves.column);
    SentBack result{.amplitudes = at_depths(sent)};
    for (int trip = 0; trip < later_trips; ++trip) {
        sent = waves.amplitudes * (crossed.cwiseProduct(sent.head(crossed.size()))).eval();
        double largest = 0;
        for (const Complex& at_depth : at_depths(sent)) {
            largest = std::max(largest, std::abs(at_depth));
        }
        result.later += largest;
    }
    return result;
}

WavesSentBack waves_of(const nmbcgen::Reflection& reflection, double xi) {
    WavesSentBack waves{.k = {}, .amplitudes = reflection.amplitudes, .column = 0, .energy = 0};
    for (const nmbcgen::Mode& mode : reflection.outgoing) {
        waves.k.push_back(mode.k);
    }
    const auto distance = [&](Eigen::Index column) {
        const Complex k = waves.k[std::size_t(column)];
        return std::abs(std::polar(1.0, xi) - k) * std::abs(std::polar(1.0, -xi) - k);
    };
    for (Eigen::Index column = 0; column < waves.amplitudes.cols(); ++column) {
        waves.column = distance(column) < distance(waves.column) ? column : waves.column;
    }
    return waves;
}

/// max over these times of |Re sum amplitude exp(-i omega' t)|, omega' in time steps: of 4000 times
/// after the sources, ten in the shortest period, between two of which a crest rises by 5 %, and
/// as many before they have ended. Where that is too long for ten, its moduli: no crest is higher.
double largest_sum(Arrivals arrivals, double time_step, const Pause& pause) {
    std::vector<Arrival>& waves = arrivals.waves;
    double highest = 0;
    for (const Arrival& wave : waves) {
        highest = std::max(highest, frequency_in_steps(wave.band->omega, time_step));
    }
    if (highest == 0) {
        return 0;
    }
    constexpr double most_times = 4000;
    const double short_enough = 2 * std::numbers::pi / highest / 10;
    const double between = std::max(short_enough, -arrivals.first / most_times);
    const auto size = [&](Complex sum) {
        return between > short_enough ? std::abs(sum) : std::abs(sum.real());
    };
    std::vector<Complex> turns;
    turns.reserve(waves.size());
    for (Arrival& wave : waves) {
        const double omega = frequency_in_steps(wave.band->omega, time_step);
        turns.push_back(std::polar(1.0, -omega * between));
        wave.amplitude *= std::polar(1.0, -omega * arrivals.first);
    }
    double largest = 0;
    const double last =
        std::min(arrivals.last, std::max(arrivals.first, 0.0) + most_times * between);
    for (double time = arrivals.first; time <= last; time += between) {
        pause();
        Complex sum = 0;
        for (std::size_t i = 0; i < waves.size(); ++i) {
            sum += waves[i].amplitude;
            waves[i].amplitude *= turns[i];
        }
        largest = std::max(largest, size(sum));
    }
    return largest;
}

}  // namespace

ReflectionError::ReflectionError(const Scene& scene, const Outgoing& outgoing, double negligible,
                                 const Pause& pause)
    : scene_(scene),
      outgoing_(outgoing),
      pause_(pause),
      mirrors_(scene),
      left_(all_arrivals(scene, outgoing, nmbc::End::left, negligible * outgoing.largest)),
      right_(all_arrivals(scene, outgoing, nmbc::End::right, negligible * outgoing.largest)) {}

const nmbcgen::HalfSpace& ReflectionError::half_space(const Boundary& boundary) {
    const nmbc::MatchingTable& table = table_of(scene_, boundary);
    const auto found = half_spaces_.find(&table);
    return found != half_spaces_.end()
               ? found->second
               : half_spaces_.emplace(&table, half_space_of(table, scene_.G)).first->second;
}

/// error_of(arrivals): |u - u_ref| of what one end makes of them.
template <class ErrorOf>
double ReflectionError::of_all(ErrorOf error_of) const {
    const auto sum = [&](const std::vector<Arrivals>& all) {
        double error = 0;
        for (const Arrivals& each : all) {
            error += error_of(each);
        }
        return error;
    };
    const double left = sum(left_);
    const double right = sum(right_);
    const auto way = double(outgoing_.from_left + outgoing_.from_right + scene_.nodes);
    const double time =
        outgoing_.remaining +
        before_sources_end(std::min(outgoing_.from_left, outgoing_.from_right), outgoing_);
    const bool meet = fastest_speed(outgoing_) * time >= way / 2;
    const double at_mirror = mirrors_.count() == 1 && meet ? 2 : 1;
    return at_mirror * (meet ? left + right : std::max(left, right)) / outgoing_.largest;
}

ReflectionError::End ReflectionError::end(const Boundary& boundary, double time_step) {
    if (boundary.kind == BoundaryKind::passive) {
        return [waves = sent_back_by_passive_end(lattice_of(scene_), time_step)](
                   const WaveBand& band) { return waves(band.xi); };
    }
    return [this, end = stepped(half_space(boundary), time_step)](const WaveBand& band) {
        if (end.is_damped()) {
            return waves_of(nmbcgen::reflection(end, band.omega), band.xi);
        }
        const auto [entry, is_new] = modes_.try_emplace(band.omega);
        if (is_new) {
            entry->second = nmbcgen::outgoing_modes(end, band.omega);
        }
        return waves_of(nmbcgen::reflection(end, band.omega, entry->second), band.xi);
    };
}

double ReflectionError::of(const Boundary& boundary, double time_step) {
    const End end = this->end(boundary, time_step);
    return of_all([&](const Arrivals& arrivals) {
        const std::vector<Arrival>& waves = arrivals.waves;
        double later = 0;
        std::vector<AtDepths> sent_back_at;
        sent_back_at.reserve(waves.size());
        for (const Arrival& wave : waves) {
            pause_();
            const SentBack sent =
                sent_back(end(*wave.band), way_between_ends(scene_), wave.later_trips);
            later += std::abs(wave.amplitude) * sent.later;
            sent_back_at.push_back(sent.amplitudes);
        }
        double largest = 0;
        for (std::size_t depth = 0; depth < depths.size(); ++depth) {
            if (std::size_t(depths[depth]) >= scene_.nodes) {
                break;
            }
            Arrivals returned = arrivals;
            for (std::size_t i = 0; i < waves.size(); ++i) {
                returned.waves[i].amplitude *= std::conj(sent_back_at[i][depth]);
            }
            largest = std::max(largest, largest_sum(std::move(returned), time_step, pause_));
        }
        return later + largest;
    });
}

double ReflectionError::of_fixed_ends(double time_step) const {
    return of_all([&](const Arrivals& arrivals) {
        double later = 0;
        for (const Arrival& wave : arrivals.waves) {
            later += std::abs(wave.amplitude) * wave.later_trips;
        }
        return later + largest_sum(arrivals, time_step, pause_);
    });
}

}  // namespace nmbcrun
