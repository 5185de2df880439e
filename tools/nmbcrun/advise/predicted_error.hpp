// SPDX-License-Identifier: MIT
/// Errors of a boundary and of time steps, predicted from the waves a scene sends out.
#pragma once

#include <memory>

#include "tools/nmbcrun/advise/outgoing.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// max |u - u_ref| / max |u_ref| by what the ends send back once: for every wave number what its
/// waves add to |u| at most, times the amplitudes of all waves that the end makes of them, summed
/// over both ends. So it is too large where waves of different wave number do not meet in phase,
/// and knows nothing of second round trips. Only waves that get to an end in time count.
class ReflectionError {
  public:
    ReflectionError(const Scene& scene, const Outgoing& outgoing);
    ~ReflectionError();
    ReflectionError(const ReflectionError&) = delete;
    ReflectionError& operator=(const ReflectionError&) = delete;

    /// Of an nmbc at both ends, in steps of time_step [dX/c].
    double of(const Boundary& boundary, double time_step);

    /// Of anything that sends back every wave once as large as it came: what there is to lose.
    double of_everything() const;

  private:
    struct Modes;

    const Scene& scene_;
    const Outgoing& outgoing_;
    std::unique_ptr<Modes> modes_;
};

/// Likewise what leapfrog in such steps makes of waves in continuous time: each is late by
/// |omega' - omega| t, t the time it spends between the ends.
double time_error(const Outgoing& outgoing, std::size_t nodes, double time_step);

}  // namespace nmbcrun
