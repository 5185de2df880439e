// SPDX-License-Identifier: MIT
/// Errors of a boundary and of time steps, predicted from the waves a scene sends out.
#pragma once

#include <memory>

#include "tools/nmbcrun/advise/outgoing.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// max |u - u_ref| / max |u_ref| by what the ends send back once: the outgoing waves, each times
/// what the end makes of it, added up where the interior begins at times up to the end of the run.
/// The larger of the two ends. Second round trips and waves that meet from both ends are left out.
class ReflectionError {
  public:
    /// Both live as long as this.
    ReflectionError(const Scene& scene, const Outgoing& outgoing);
    ~ReflectionError();
    ReflectionError(const ReflectionError&) = delete;
    ReflectionError& operator=(const ReflectionError&) = delete;

    /// Of an nmbc at both ends, in steps of time_step [dX/c].
    double of(const Boundary& boundary, double time_step);

    /// Of fixed ends, which send everything back: nothing, where nothing gets there in time.
    double of_fixed_ends(double time_step) const;

  private:
    struct Modes;

    const Scene& scene_;
    const Outgoing& outgoing_;
    std::unique_ptr<Modes> modes_;
};

/// Likewise what leapfrog in such steps makes of waves in continuous time, |u - u_ref| of the
/// interior nodes at 40 times of the run, in half of the sources' own time, too. What the
/// sources themselves are off by is left out.
double time_error(const Outgoing& outgoing, std::size_t nodes, double time_step);

}  // namespace nmbcrun
