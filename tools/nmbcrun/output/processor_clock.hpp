// SPDX-License-Identifier: MIT
/// Time of the processor: what other programs take of the machine does not count.
#pragma once

#include <ctime>

namespace nmbcrun {

inline double processor_seconds(clockid_t clock) {
    std::timespec time{};
    clock_gettime(clock, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

inline double seconds_of_this_thread() {
    return processor_seconds(CLOCK_THREAD_CPUTIME_ID);
}

/// Of all its threads.
inline double seconds_of_this_process() {
    return processor_seconds(CLOCK_PROCESS_CPUTIME_ID);
}

}  // namespace nmbcrun
