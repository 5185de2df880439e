// SPDX-License-Identifier: MIT
/// Ctrl-C, SIGTERM and SIGHUP: at once, or between two steps, so that nothing half-written stays.
#pragma once

namespace nmbcrun {

/// From now on each of these signals ends the program with `exit_code`, in words; one that is
/// ignored (nohup) stays ignored. What nobody reads, or goes beyond the limit of a file's size
/// (ulimit -f), ends nothing: writing to it fails.
void end_at_interrupts(int exit_code);

/// From now on they are noted; one that comes two seconds later or more ends the program. (Some
/// that stop a program send two signals at once.)
void note_interrupts();

/// Whether one was noted.
bool interrupted();

/// Throws Interrupted if so: for what may take a second or more before the first step of a run, or
/// after its last, and writes nothing.
void stop_if_interrupted();

}  // namespace nmbcrun
