// SPDX-License-Identifier: MIT
/// What the interior of a scene makes of its sources, predicted.
#pragma once

#include <complex>
#include <vector>

#include "tools/nmbcrun/advise/outgoing.hpp"
#include "tools/nmbcrun/advise/pause.hpp"
#include "tools/nmbcrun/advise/wave_grid.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// What errors are relative to.
enum class Reference {
    lattice,   ///< the same lattice without ends, in continuous time
    continuum  ///< the wave equation (continuum.hpp)
};

/// max |u - u_ref| / max |u_ref| of the interior nodes at 40 times after the sources: u the waves
/// that the sources send out in time steps, as leapfrog moves them.
class InteriorError {
  public:
    /// outgoing: of the scene in steps so short that their waves are the reference's own, where
    /// that is the lattice. `endless` and `pause` live as long as this.
    InteriorError(const Scene& scene, EndlessScene& endless, const Outgoing& outgoing,
                  Reference reference, const Pause& pause);

    /// In steps of this cfl. Where it is more than `enough`, any time's error above that, the end's
    /// to begin with. Throws as Simulation does.
    double at(double cfl, double enough);

  private:
    struct Wave {
        double frequency;
        double speed;
        std::complex<double> forwards;
        std::complex<double> backwards;
    };

    double part_inside(double way) const;

    EndlessScene& endless_;
    const Pause& pause_;
    Mirrors mirrors_;
    double gone_after_;  // dX: a wave that has gone twice as far has left the interior
    double duration_;    // after which the reference is
    double largest_;
    WaveGrid grid_;
    std::vector<Wave> reference_;
};

}  // namespace nmbcrun
