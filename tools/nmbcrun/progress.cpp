// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace nmbcrun {

Progress::Progress(std::size_t total, bool quiet)
    : total_(total), shown_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_) {
        fmt::print(stderr, "\r\033[K");
    }
}

void Progress::update(std::size_t done) {
    if (!shown_ || done < next_) {
        return;
    }
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    const double fraction = double(done) / double(std::max<std::size_t>(total_, 1));
    const double left = fraction > 0 ? elapsed * (1 - fraction) / fraction : 0;
    constexpr int width = 40;
    const int filled = int(fraction * width);
    fmt::print(stderr, "\r[{}{}] {:3.0f} %, {:.0f} s left \033[K",
               std::string(std::size_t(filled), '#'), std::string(std::size_t(width - filled), '.'),
               100 * fraction, left);
    std::fflush(stderr);
    // Aim for ten drawings a second by the speed so far, and for 100 in all at the start.
    const double per_second = elapsed > 0.1 ? double(done) / elapsed : double(total_);
    next_ =
        done + std::max<std::size_t>(1, std::min(total_ / 100 + 1, std::size_t(per_second / 10)));
}

}  // namespace nmbcrun
