// SPDX-License-Identifier: MIT
/// The order of a time step, whatever the lattice: kick, close the sides, drift.
#pragma once

#include <cstddef>

namespace nmbc::detail {

/// Steps of leapfrog. In each of them the lattice's forces bring v to t + dt/2 (kick), hooks and
/// boundaries have their turn (close_sides), and u goes on to t + dt (drift).
///
/// In memory, one step's drift and the next one's kick are one sweep (drift_and_kick): many steps
/// at once are faster than one by one, and the same bit for bit.
template <class Body, class... Hooks>
void advance(Body& body, std::size_t steps, Hooks&... hooks) {
    if (steps == 0) {
        return;
    }
    body.kick();
    for (std::size_t step = 1; step < steps; ++step) {
        body.close_sides(hooks...);
        body.drift_and_kick();
    }
    body.close_sides(hooks...);
    body.drift();
}

}  // namespace nmbc::detail
