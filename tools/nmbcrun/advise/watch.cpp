// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "tools/nmbcrun/output/duration.hpp"

namespace nmbcrun {

Watch::Watch(bool quiet) : shown_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

Watch::~Watch() {
    if (shown_ && next_ > 1) {
        fmt::print(stderr, "\r\033[K");
    }
}

double Watch::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Watch::look() {
    if (!shown_ || seconds() < next_) {
        return;
    }
    fmt::print(stderr, "\rlooking for set-ups, {} \033[K", duration(std::floor(seconds())));
    std::fflush(stderr);
    next_ = seconds() + 1;
}

}  // namespace nmbcrun
