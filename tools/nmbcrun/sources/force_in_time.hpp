// SPDX-License-Identifier: MIT
/// The values of a force in time.
#pragma once

#include <string>
#include <vector>

#include "tools/nmbcrun/scene/sources.hpp"

namespace nmbcrun {

/// A gaussian or ricker is below 4e-6 of its peak so many durations away from its middle.
inline constexpr double enough_durations = 4;

class ForceInTime {
  public:
    /// column: of a file, or dataset, beside `time`. Throws SceneError where its file does not make
    /// a history, FileError where that cannot be read.
    explicit ForceInTime(ForceHistory history, const std::string& column = "force");

    double at(double time) const;

    /// Before and after these times it is below 1e-16 of its amplitude, or 0.
    double first() const { return first_; }
    double last() const { return last_; }

    /// The largest |f|.
    double peak() const { return largest(first_, last_); }
    /// Of a file: the largest |df/dt| between two of its rows; 0 of one row.
    double steepest_between_rows() const;

    /// From then on it has ended, but for 4e-6 of its amplitude.
    double end() const;

    /// Throws SceneError where steps of this length [time] are too long for what the history says
    /// of itself: a pulse's duration, 1/4 of a sine's period, 1/2 of its cycles; nothing of files.
    /// table: of the scene, that it is in.
    void require_resolved(const std::string& table, double time_step) const;

    /// Whether the force acts, above 1e-16 of its amplitude, at this time or later.
    bool drives(double time) const { return time <= last_; }

    /// In words, what a run of such steps to `end` misses of it: rows of a file, or what is before
    /// or after the run. table: of the scene, that it is in.
    std::vector<std::string> warnings(const std::string& table, double time_step, double end) const;

    /// The same, but for what is after the run: loads may stay on.
    std::vector<std::string> warnings(const std::string& table, double time_step) const;

  private:
    double linear_between_rows(double time) const;
    double largest(double from, double to) const;
    std::string missed_rows(double time_step) const;
    /// end: of the run, beyond which nothing is proposed unless that is, too.
    std::string jump_at_start(const std::string& table, double end) const;
    std::string rest_after(double end, const std::string& table) const;
    /// Whether a file has it as it is now up to its last row: of a load that lasts a run misses
    /// nothing.
    bool stays(double time) const;

    ForceHistory force_;
    double first_ = 0;
    double last_ = 0;
    std::vector<double> times_{};  // of a file
    std::vector<double> forces_{};
};

/// Of what is given on a surface: the file's column is `value`.
inline ForceInTime value_in_time(const ForceHistory& history) {
    return ForceInTime(history, "value");
}

}  // namespace nmbcrun
