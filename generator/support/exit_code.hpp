// SPDX-License-Identifier: MIT
/// What every program of the project ends with.
#pragma once

namespace nmbcgen {

enum ExitCode {
    done = 0,
    does_not_hold = 1,     ///< a comparison: tables are stale, an error is above its tolerance
    bad_input = 2,         ///< arguments or files
    no_such_boundary = 3,  ///< condition
    unstable = 4,          ///< or not certified, or a run is not finite
    file_failed = 5,       ///< one could not be read or written
    stopped = 130          ///< by the user, as shells count Ctrl-C
};

}  // namespace nmbcgen
