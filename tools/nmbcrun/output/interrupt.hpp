// SPDX-License-Identifier: MIT
/// Ctrl-C and SIGTERM end a run between two steps, so that nothing half-written stays behind.
#pragma once

namespace nmbcrun {

/// From now on SIGINT and SIGTERM are noted instead of ending the program; a second one ends it. A
/// file that grows beyond the limit of its size (ulimit -f) ends nothing: writing to it fails.
void note_interrupts();

/// Whether one has come.
bool interrupted();

}  // namespace nmbcrun
