// SPDX-License-Identifier: MIT
/// Which committed tables are compared.
#pragma once

#include <nmbc/table.hpp>

namespace pulses {

/// tau of a table [c/dX].
double damping_of(const nmbc::MatchingTable& table);

/// The time step it is matched in [dX/c]; 0: none.
double step_of(const nmbc::MatchingTable& table);

/// cfl = dt omega_max / 2 of steps [dX/c] in the table's lattice.
double cfl_of(const nmbc::MatchingTable& table, double G, double time_step);

/// NMBC1 with stride 1, undamped; nullptr where none is committed or it is not certified at G.
const nmbc::MatchingTable* first_order(int horizon, double G);

/// Of the committed tables of order 2 or more that are certified at G with cfl 1/4 or more, the one
/// of least tau and, of those, of the largest cfl; nullptr where there is none. matched: of those
/// that are matched in a time step, and certified in it; else of the others.
const nmbc::MatchingTable* higher_order(int horizon, double G, bool matched);

}  // namespace pulses
