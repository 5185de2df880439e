// SPDX-License-Identifier: MIT
#include "generator/support/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <utility>

namespace nmbcgen {

ProgressLine::ProgressLine(std::string what) : what_(std::move(what)) {
    if (isatty(STDERR_FILENO) != 0) {
        writer_ = std::thread([this] { write_until_stopped(); });
    }
}

ProgressLine::~ProgressLine() {
    if (writer_.joinable()) {
        {
            const std::lock_guard lock(mutex_);
            stopped_ = true;
        }
        changed_.notify_one();
        writer_.join();
    }
}

void ProgressLine::operator()(std::size_t done, std::size_t all) {
    const std::lock_guard lock(mutex_);
    done_ = done;
    all_ = all;
}

void ProgressLine::write_until_stopped() {
    using std::chrono::milliseconds;
    std::unique_lock lock(mutex_);
    bool written = false;
    milliseconds pause(2000);
    while (!changed_.wait_for(lock, pause, [this] { return stopped_; })) {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(
            std::chrono::steady_clock::now() - start_);
        std::cerr << "\r\033[K" << what_ << (all_ > 0 ? fmt::format(", {} of {}", done_, all_) : "")
                  << fmt::format(", {} s", seconds.count()) << std::flush;
        written = true;
        pause = milliseconds(500);
    }
    if (written) {
        std::cerr << "\r\033[K" << std::flush;
    }
}

}  // namespace nmbcgen
