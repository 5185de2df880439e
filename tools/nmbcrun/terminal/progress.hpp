// SPDX-License-Identifier: MIT
/// A progress bar on stderr; as wide as the terminal lets it be, and nothing where
/// stderr is none.
#pragma once

#include <chrono>
#include <cstddef>

namespace nmbcrun {

class Progress {
  public:
    /// total: steps in all; quiet: show nothing; first: steps done before, in another process.
    Progress(std::size_t total, bool quiet, std::size_t first = 0);
    /// Clears the line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// To be called often; draws a few times a second, by the clock.
    void update(std::size_t done);

  private:
    using Clock = std::chrono::steady_clock;
    std::size_t total_;
    std::size_t first_;
    int columns_;  // 0: nothing is shown
    Clock::time_point start_ = Clock::now();
    Clock::time_point drawn_ = start_;
};

}  // namespace nmbcrun
