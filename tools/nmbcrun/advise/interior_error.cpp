// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/interior_error.hpp"

#include <algorithm>
#include <cmath>

#include "tools/nmbcrun/advise/continuum.hpp"

namespace nmbcrun {
namespace {

using Complex = std::complex<double>;

}  // namespace

InteriorError::InteriorError(const Scene& scene, const EndlessScene& endless,
                             const Outgoing& outgoing, Reference reference)
    : endless_(endless),
      nodes_(scene.nodes),
      duration_(outgoing.duration),
      largest_(outgoing.largest),
      grid_(outgoing.nodes) {
    reference_.reserve(outgoing.bands.size());
    if (reference == Reference::lattice) {
        for (const WaveBand& band : outgoing.bands) {
            reference_.push_back({band.omega, band.forwards, band.backwards});
        }
        return;
    }
    const ContinuumWaves waves = continuum_waves(scene, outgoing);
    for (std::size_t band = 0; band < outgoing.bands.size(); ++band) {
        reference_.push_back(
            {outgoing.bands[band].xi, waves.forwards[band], waves.backwards[band]});
    }
}

double InteriorError::at(double cfl, double enough) {
    const Outgoing outgoing = endless_.outgoing(cfl);
    std::vector<double> frequencies;
    frequencies.reserve(reference_.size());
    for (const WaveBand& band : outgoing.bands) {
        frequencies.push_back(frequency_in_steps(band.omega, outgoing.time_step));
    }
    constexpr int times = 40;
    double error = 0;
    for (int i = times; i > 0 && error <= enough; --i) {
        const double time = outgoing.remaining * i / times;
        std::vector<Complex> differences;
        differences.reserve(reference_.size());
        for (std::size_t band = 0; band < reference_.size(); ++band) {
            const WaveBand& own = outgoing.bands[band];
            const Wave& right = reference_[band];
            const Complex turn = std::polar(1.0, -frequencies[band] * time);
            const Complex right_turn =
                std::polar(1.0, -right.frequency * (outgoing.duration - duration_ + time));
            // Re b exp(-i xi x) = Re conj(b) exp(i xi x)
            differences.push_back(own.forwards * turn - right.forwards * right_turn +
                                  std::conj(own.backwards * turn - right.backwards * right_turn));
        }
        const std::vector<double> field = grid_.field(differences);
        for (std::size_t node = 0; node < nodes_; ++node) {
            error = std::max(error, std::abs(field[node]) / largest_);
        }
    }
    return error;
}

}  // namespace nmbcrun
