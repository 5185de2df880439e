// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/interior_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tools/nmbcrun/advise/continuum.hpp"

namespace nmbcrun {
namespace {

using Complex = std::complex<double>;

/// Of exp(i xi x), a time after the sources: Re b exp(-i xi x) = Re conj(b) exp(i xi x).
Complex amplitude_after(double time, double frequency, Complex forwards, Complex backwards) {
    const Complex turn = std::polar(1.0, -frequency * time);
    return forwards * turn + std::conj(backwards * turn);
}

/// 40 times, the last one first: of all of the run, and half of them while most waves are inside.
std::vector<double> times_of(const Outgoing& outgoing) {
    constexpr int count = 20;
    std::vector<double> times;
    for (int i = 1; i <= count; ++i) {
        const double share = double(i) / count;
        times.push_back(outgoing.remaining * share);
        times.push_back(outgoing.followed < outgoing.remaining
                            ? outgoing.followed * share
                            : outgoing.remaining * (share - 0.5 / count));
    }
    std::ranges::sort(times, std::ranges::greater());
    return times;
}

}  // namespace

InteriorError::InteriorError(const Scene& scene, EndlessScene& endless, const Outgoing& outgoing,
                             Reference reference, const Pause& pause)
    : endless_(endless),
      pause_(pause),
      mirrors_(scene),
      gone_after_(mirrors_.count() == 2
                      ? std::numeric_limits<double>::infinity()
                      : double(scene.nodes) * (1 + mirrors_.count()) + outgoing.duration),
      duration_(outgoing.duration),
      largest_(outgoing.largest),
      grid_(outgoing.nodes) {
    reference_.reserve(outgoing.bands.size());
    if (reference == Reference::lattice) {
        for (const WaveBand& band : outgoing.bands) {
            reference_.push_back({band.omega, band.speed, band.forwards, band.backwards});
        }
        return;
    }
    const ContinuumWaves waves = continuum_waves(scene, outgoing, pause);
    for (std::size_t band = 0; band < outgoing.bands.size(); ++band) {
        reference_.push_back(
            {outgoing.bands[band].xi, 1, waves.forwards[band], waves.backwards[band]});
    }
}

/// Of a wave that has gone so far [dX]: 0 before its sum with the others would repeat.
double InteriorError::part_inside(double way) const {
    const double beyond = std::clamp(way / gone_after_ - 1, 0.0, 1.0);
    return std::pow(std::cos(beyond * std::numbers::pi / 2), 2);
}

double InteriorError::at(double cfl, double enough) {
    const Outgoing outgoing = endless_.outgoing(cfl);
    double error = 0;
    std::vector<Complex> differences(reference_.size());
    for (const double time : times_of(outgoing)) {
        pause_();
        const double of_reference = outgoing.duration + time - duration_;
        for (std::size_t band = 0; band < differences.size(); ++band) {
            const WaveBand& own = outgoing.bands[band];
            const Wave& right = reference_[band];
            differences[band] =
                part_inside(own.speed * time) *
                    amplitude_after(time, frequency_in_steps(own.omega, outgoing.time_step),
                                    own.forwards, own.backwards) -
                part_inside(right.speed * time) *
                    amplitude_after(of_reference, right.frequency, right.forwards, right.backwards);
        }
        for (const double difference : mirrors_.folded(grid_.field(differences))) {
            error = std::max(error, std::abs(difference) / largest_);
        }
        if (error > enough) {
            break;
        }
    }
    return error;
}

}  // namespace nmbcrun
