// SPDX-License-Identifier: MIT
/// The values of a force in time.
#pragma once

#include <string>
#include <vector>

#include "tools/nmbcrun/scene/sources.hpp"

namespace nmbcrun {

class ForceInTime {
  public:
    /// column: of a file, beside `time`. Throws SceneError where its file does not make a history,
    /// FileError where that cannot be read.
    explicit ForceInTime(ForceHistory history, const std::string& column = "force");

    double at(double time) const;

    double last() const { return last_; }

    /// Whether the force acts, above 1e-16 of its amplitude, at this time or later.
    bool drives(double time) const { return time <= last_; }

    /// In words: what such time steps miss of a history from a file; empty where they do not.
    std::string warning(double time_step) const;

  private:
    double linear_between_rows(double time) const;

    ForceHistory force_;
    double last_ = 0;
    std::vector<double> times_{};  // of a file
    std::vector<double> forces_{};
};

/// Of what is given on a surface: the file's column is `value`.
inline ForceInTime value_in_time(const ForceHistory& history) {
    return ForceInTime(history, "value");
}

}  // namespace nmbcrun
