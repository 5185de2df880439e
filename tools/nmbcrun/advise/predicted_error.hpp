// SPDX-License-Identifier: MIT
/// What the ends of a scene send back, predicted from the waves that its sources send out.
#pragma once

#include <map>
#include <nmbc/node_line.hpp>
#include <unordered_map>
#include <vector>

#include "generator/stability/half_space.hpp"
#include "generator/stability/modes.hpp"
#include "tools/nmbcrun/advise/outgoing.hpp"
#include "tools/nmbcrun/advise/pause.hpp"
#include "tools/nmbcrun/ends/passive_design.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// A wave that has come to an end, as Re amplitude exp(-i omega t) at its outermost interior node.
struct Arrival {
    const WaveBand* band;
    std::complex<double> amplitude;
    /// To the other end and so on, that there is time for and that are under way at one time: of
    /// a packet no wider than the chain, one beside the trip before. Ends that pass on no more
    /// energy than arrives make the first of them the largest.
    int later_trips;
};

/// Waves that get to an end by one way, and when [dX/c after the sources] they are there.
struct Arrivals {
    std::vector<Arrival> waves;
    double first = 0;
    double last = 0;
};

/// max |u - u_ref| / max |u_ref| by what the ends send back: the outgoing waves, each times what
/// the end makes of it, added up in phase at some nodes near the end, at times from the first
/// arrival to the end of the run, before the sources have ended or after. The larger of the two
/// ends, or their sum where there is time for the two to meet; and a bound of what comes back
/// again, the sum over all waves of |amplitude| times what is left of each after some trips: as
/// many as are under way at one time, so that it stays what it is however long the run. A physical
/// end sends everything back: to the artificial one opposite, where it counts like what comes
/// directly, and what that makes an error of, which is twice as large there.
class ReflectionError {
  public:
    /// All three live as long as this. What adds up to less than `negligible` of max |u| is left
    /// out.
    ReflectionError(const Scene& scene, const Outgoing& outgoing, double negligible,
                    const Pause& pause);

    /// Of an nmbc or a passive end at the artificial ends, in steps of time_step [dX/c].
    double of(const Boundary& boundary, double time_step);

    /// Of fixed ends, which send everything back: nothing, where nothing gets there in time.
    double of_fixed_ends(double time_step) const;

  private:
    using End = std::function<WavesSentBack(const WaveBand&)>;

    End end(const Boundary& boundary, double time_step);
    const nmbcgen::HalfSpace& half_space(const Boundary& boundary);
    template <class ErrorOf>
    double of_all(ErrorOf error_of) const;

    const Scene& scene_;
    const Outgoing& outgoing_;
    const Pause& pause_;
    Mirrors mirrors_;
    std::vector<Arrivals>
        left_;  // none at a physical end; directly, and from a physical end opposite
    std::vector<Arrivals> right_;
    std::map<const nmbc::MatchingTable*, nmbcgen::HalfSpace> half_spaces_;
    /// Of an undamped lattice, by frequency: neither ends nor steps change them.
    std::unordered_map<double, std::vector<nmbcgen::Mode>> modes_;
};

}  // namespace nmbcrun
