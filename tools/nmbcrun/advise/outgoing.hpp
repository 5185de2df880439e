// SPDX-License-Identifier: MIT
/// The waves that a scene's sources send to its ends.
#pragma once

#include <complex>
#include <cstddef>
#include <nmbc/chain.hpp>
#include <optional>
#include <vector>

#include "tools/nmbcrun/advise/mirrors.hpp"
#include "tools/nmbcrun/advise/pause.hpp"
#include "tools/nmbcrun/advise/wave_grid.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Waves about one wave number xi, on their way in both directions. Units dX = c = 1; amplitudes
/// are those of Re a exp(i(kappa x - omega t)), |kappa| = xi, x counted from the outermost interior
/// node at the left.
struct WaveBand {
    double xi;                       ///< in (0, pi)
    double omega;                    ///< of the lattice in continuous time
    double speed;                    ///< |group velocity|
    std::complex<double> forwards;   ///< a of kappa = xi
    std::complex<double> backwards;  ///< a of kappa = -xi
    bool is_backward;                ///< energy goes against the phase
};

/// For so long after the sources [dX/c] waves are followed on their way to the ends, and out.
/// Slower ones than a tenth of c may take longer.
double time_to_follow(const Scene& scene);

/// What is under way when the sources have ended, as if there were no ends.
struct Outgoing {
    std::vector<WaveBand> bands;  ///< of all wave numbers of a WaveGrid of `nodes`
    std::size_t nodes = 0;        ///< of interior and layers, the same in any time step
    double largest = 0;           ///< |u| of the interior, what errors are relative to
    double duration = 0;          ///< of the sources [dX/c]
    double remaining = 0;         ///< of the run after them
    double followed = 0;          ///< of that, the time in which the sum of waves does not repeat
    double time_step = 0;         ///< in which the waves have come there [dX/c]
    /// Interior nodes between the outermost one that moves then and each end.
    std::size_t from_left = 0;
    std::size_t from_right = 0;
};

/// A scene without ends, and without a preload, which does not move. What comes in is there as the
/// waves it is made of (docs/reference/scene.md).
class EndlessScene {
  public:
    /// The scene's own step and cfl do not count. `pause` lives as long as this. Throws as
    /// Simulation does.
    EndlessScene(const Scene& scene, const Pause& pause);

    /// Steps it in steps of this cfl until its sources have ended, and the middle of what comes in
    /// has arrived. `largest` is that of these steps
    /// alone. Throws as Simulation does.
    Outgoing outgoing(double cfl);

  private:
    void add_waves(const nmbc::Chain& chain, Outgoing& outgoing);
    void add_incoming(Outgoing& outgoing);

    Scene scene_;  // between layers that nothing returns from
    const Pause& pause_;
    std::optional<Incoming> incoming_;
    double unit_;  // dX/c
    double followed_;
    double omega_max_;
    WaveGrid grid_;
    std::vector<WaveBand> at_rest_;
};

/// max |u| of the interior nodes at some times after the sources.
double largest_after(const Outgoing& outgoing, const Mirrors& mirrors);

/// theta/dt: what leapfrog makes of omega, sin(theta/2) = omega dt/2.
double frequency_in_steps(double omega, double time_step);

/// The speed of the fastest of the waves that matter.
double fastest_speed(const Outgoing& outgoing);

}  // namespace nmbcrun
