// SPDX-License-Identifier: MIT
/// A line on stderr that says that a search goes on; nothing where stderr is no terminal.
#pragma once

#include <chrono>

namespace nmbcrun {

class Watch {
  public:
    explicit Watch(bool quiet);
    /// Clears the line.
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    /// To be called every few milliseconds; draws once a second.
    void look();

    double seconds() const;  ///< since it was made

  private:
    using Clock = std::chrono::steady_clock;
    bool shown_;
    Clock::time_point start_ = Clock::now();
    double next_ = 1;
};

}  // namespace nmbcrun
