// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace nmbcrun {
namespace {

constexpr int longest_line = 70;

/// Columns of the terminal on stderr; 0 where it is none, or one that cannot clear a line.
int terminal_width() {
    const char* kind = std::getenv("TERM");
    winsize size{};
    const bool terminal = ::isatty(STDERR_FILENO) == 1 && kind != nullptr &&
                          std::string_view(kind) != "dumb" &&
                          ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0;
    return terminal ? size.ws_col : 0;
}

}  // namespace

Progress::Progress(std::size_t total, bool quiet, std::size_t first)
    : total_(total), first_(first), shown_(!quiet && terminal_width() >= longest_line) {}

Progress::~Progress() {
    if (shown_) {
        fmt::print(stderr, "\r\033[K");
    }
}

void Progress::update(std::size_t done) {
    using namespace std::chrono_literals;
    if (!shown_ || Clock::now() - drawn_ < 100ms) {
        return;
    }
    drawn_ = Clock::now();
    const double elapsed = std::chrono::duration<double>(drawn_ - start_).count();
    const double fraction = double(done) / double(std::max<std::size_t>(total_, 1));
    const auto done_here = double(done - first_);
    const auto left =
        done_here > 0 ? fmt::format("{:.0f} s left", elapsed * double(total_ - done) / done_here)
                      : std::string();
    constexpr int width = 40;
    const int filled = int(fraction * width);
    fmt::print(stderr, "\r[{}{}] {:3.0f} %, {} \033[K", std::string(std::size_t(filled), '#'),
               std::string(std::size_t(width - filled), '.'), 100 * fraction, left);
    std::fflush(stderr);
}

}  // namespace nmbcrun
