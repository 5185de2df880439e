// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/terminal/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "tools/nmbcrun/terminal/duration.hpp"

namespace nmbcrun {
namespace {

constexpr int widest_bar = 40;
constexpr int beside_bar = 30;  // "[", "] 100 %, 110 s left ", and a margin

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
    : total_(total), first_(first), columns_(quiet ? 0 : terminal_width()) {}

Progress::~Progress() {
    if (columns_ > 0) {
        fmt::print(stderr, "\r\033[K");
    }
}

void Progress::update(std::size_t done) {
    using namespace std::chrono_literals;
    if (columns_ == 0 || Clock::now() - drawn_ < 100ms) {
        return;
    }
    drawn_ = Clock::now();
    const double elapsed = std::chrono::duration<double>(drawn_ - start_).count();
    const double fraction = double(done) / double(std::max<std::size_t>(total_, 1));
    const auto done_here = double(done - first_);
    const auto left =
        done_here > 0
            ? fmt::format("{} left", duration(elapsed * double(total_ - done) / done_here))
            : std::string();
    const int width = std::clamp(columns_ - beside_bar, 0, widest_bar);
    const int filled = int(fraction * width);
    const std::string bar =
        width == 0 ? std::string()
                   : fmt::format("[{:.<{}}] ", std::string(std::size_t(filled), '#'), width);
    const std::string line = fmt::format("{}{:3.0f} %, {}", bar, 100 * fraction, left);
    fmt::print(stderr, "\r{:.{}} \033[K", line, std::max(columns_ - 2, 1));
    std::fflush(stderr);
}

}  // namespace nmbcrun
