// SPDX-License-Identifier: MIT
/// Fields of a run at many times: kept in a journal, and published as HDF5 with its energies.
#pragma once

#include <nmbc/chain.hpp>

#include "tools/nmbcrun/output/journal.hpp"

namespace nmbcrun {

/// Adds t, u at t and v at t - dt/2 of the interior nodes.
void append_snapshot(Journal& snapshots, const nmbc::Chain& chain);

/// Writes the HDF5 file that the journal of snapshots is for: `time` [snapshots], `x` [nodes], `u`
/// and `v` [snapshots x nodes], `energies` [rows x columns], what the journal of energies has under
/// energies_header. Throws FileError.
nmbcgen::NewFile write_snapshots(Journal& snapshots, Journal& energies,
                                 const nmbc::ChainParameters& p);

}  // namespace nmbcrun
