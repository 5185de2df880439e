// SPDX-License-Identifier: MIT
/// Stability of a chain with two ends of its own choice, like or unlike.
///
/// Neither end may have a growing boundary mode or a resonance by itself. Then an undamped chain is
/// stable at every length, short ones apart (modal.hpp), if and only if no round trip is amplified:
/// R_1 and R_2 the reflections at its ends, D and D' the phases that travelling waves pick up on
/// their way there and back,
///     sup over diagonal phase matrices D, D' of rho(R_1 D R_2 D') <= 1 for every omega.
/// Ends in time steps, as stepped() makes them, may stand opposite one in continuous time: they
/// differ in the frequency that their condition sees only.
///
/// In pieces of the band too narrow to sample (merging_waves.hpp), unlike ends are to be
/// contractive each by itself, which is more than it takes; opposite a
/// free end, paired.
///
/// In a damped lattice waves fade on the way, so the number of nodes counts, and all waves,
/// decaying ones too, are in the same supremum (reflection.hpp, damped_round_trip_supremum): a
/// chain where it is at most 1 is stable, however short. Where it is more, a chain of this length
/// may be stable all the same, since the phases of its own way need not be the worst ones.
#pragma once

#include <cstddef>

#include "generator/stability/lattice_end.hpp"
#include "generator/stability/modal.hpp"
#include "generator/stability/reflection.hpp"

namespace nmbcgen {

struct RoundTripVerdict {
    Failure failure = Failure::none;
    bool left = false;         ///< the left end has the growing mode or the resonance
    double amplification = 0;  ///< of amplitudes per round trip, sup rho; 0: a mode decides; up to
                               ///< 1 beside a failure: the wave is in a piece too narrow to sample
    double wave_number = 0;    ///< where it is reached, or of the resonance
    std::complex<double> growth = 0;  ///< s [c/dX] of the growing mode; of a stepped end, sigma
};

/// nodes: interior ones, on which the verdict on a damped chain depends; others need not say.
/// Throws std::invalid_argument where the ends are of different lattices and, of a damped one,
/// where there are no nodes, the time steps differ or the interior is not stable in such steps.
RoundTripVerdict round_trip_verdict(const LatticeEnd& left, const LatticeEnd& right,
                                    std::size_t nodes = 0);

/// The reflection of an end at frequency omega > 0. A free end sends every wave back as it came.
Reflection reflection(const LatticeEnd& end, double omega);

}  // namespace nmbcgen
