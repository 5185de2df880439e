// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/interior_error.hpp"

#include <algorithm>
#include <cmath>

#include "tools/nmbcrun/advise/continuum.hpp"

namespace nmbcrun {
namespace {

using Complex = std::complex<double>;

/// Two waves of a frequency, one for each direction, at one time after the other.
class Moving {
  public:
    Moving(double frequency, Complex forwards, Complex backwards, double time, double between)
        : forwards_(forwards * std::polar(1.0, -frequency * time)),
          backwards_(backwards * std::polar(1.0, -frequency * time)),
          back_(std::polar(1.0, frequency * between)) {}

    void turn_back() {
        forwards_ *= back_;
        backwards_ *= back_;
    }

    /// Of exp(i xi x): Re b exp(-i xi x) = Re conj(b) exp(i xi x).
    Complex amplitude() const { return forwards_ + std::conj(backwards_); }

  private:
    Complex forwards_;
    Complex backwards_;
    Complex back_;
};

}  // namespace

InteriorError::InteriorError(const Scene& scene, EndlessScene& endless, const Outgoing& outgoing,
                             Reference reference, const Pause& pause)
    : endless_(endless),
      pause_(pause),
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
    const ContinuumWaves waves = continuum_waves(scene, outgoing, pause);
    for (std::size_t band = 0; band < outgoing.bands.size(); ++band) {
        reference_.push_back(
            {outgoing.bands[band].xi, waves.forwards[band], waves.backwards[band]});
    }
}

double InteriorError::at(double cfl, double enough) {
    const Outgoing outgoing = endless_.outgoing(cfl);
    constexpr int times = 40;
    const double between = outgoing.remaining / times;
    // Waves at the end of the run, and what turns them back to the time before.
    std::vector<Moving> own;
    std::vector<Moving> right;
    own.reserve(reference_.size());
    right.reserve(reference_.size());
    for (std::size_t band = 0; band < reference_.size(); ++band) {
        const WaveBand& wave = outgoing.bands[band];
        const Wave& other = reference_[band];
        own.emplace_back(frequency_in_steps(wave.omega, outgoing.time_step), wave.forwards,
                         wave.backwards, outgoing.remaining, between);
        right.emplace_back(other.frequency, other.forwards, other.backwards,
                           outgoing.duration + outgoing.remaining - duration_, between);
    }
    double error = 0;
    std::vector<Complex> differences(reference_.size());
    for (int i = times; i > 0 && error <= enough; --i) {
        pause_();
        for (std::size_t band = 0; band < differences.size(); ++band) {
            differences[band] = own[band].amplitude() - right[band].amplitude();
            own[band].turn_back();
            right[band].turn_back();
        }
        const std::vector<double> field = grid_.field(differences);
        for (std::size_t node = 0; node < nodes_; ++node) {
            error = std::max(error, std::abs(field[node]) / largest_);
        }
    }
    return error;
}

}  // namespace nmbcrun
