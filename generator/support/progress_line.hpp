// SPDX-License-Identifier: MIT
/// Progress of a long command.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace nmbcgen {

/// One line on a terminal's standard error, from two seconds on, written anew twice a second by the
/// clock and gone at the end: what is done, how much of it, and for how long by now. Nothing where
/// standard error is no terminal.
class ProgressLine {
  public:
    /// what: the program and what it does, "nmbcgen: examining"
    explicit ProgressLine(std::string what);
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine();

    /// From any thread.
    void operator()(std::size_t done, std::size_t all);

  private:
    void write_until_stopped();

    std::string what_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::mutex mutex_{};
    std::condition_variable changed_{};
    std::size_t done_ = 0;
    std::size_t all_ = 0;
    bool stopped_ = false;
    std::thread writer_{};  // the last member: it uses the others
};

}  // namespace nmbcgen
