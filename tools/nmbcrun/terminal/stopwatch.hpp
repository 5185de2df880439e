// SPDX-License-Identifier: MIT
/// Time by the clock, as the user waits for it.
#pragma once

#include <chrono>

namespace nmbcrun {

/// Begins when it is made.
class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace nmbcrun
