// SPDX-License-Identifier: MIT
/// How far a work of many parts is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"
#include "tools/nmbcrun/terminal/progress.hpp"

namespace nmbcrun {

/// Called now and then while something lasts, with the part of it that is done since it was called
/// before. It may throw.
using Advance = std::function<void(double)>;

/// All that is to be done, known at the start; lets the user stop in between.
class Work {
  public:
    /// total: in a unit of time that is the caller's.
    Work(double total, bool quiet) : total_(total), progress_(parts, quiet) {}

    /// Counts so many of it.
    Advance of(double work) {
        return [this, work](double part) { add(work * part); };
    }
    void add(double work) {
        const std::lock_guard lock(adding_);
        done_ += work;
        progress_.update(std::size_t(double(parts) * std::min(1.0, done_ / total_)));
        stop_if_interrupted();
    }

  private:
    static constexpr std::size_t parts = 100'000;
    double total_;
    double done_ = 0;
    std::mutex adding_;
    Progress progress_;
};

/// A part of a work that may be over before all that was foreseen of it is done, or take longer.
/// For one thread; it stays where it is, and so does the work.
class Portion {
  public:
    Portion(Work& work, double total) : work_(work), left_(total) {}

    /// Counts so many of it, as long as any are left.
    Advance of(double work) {
        return [this, work](double part) {
            const double done = std::min(left_, work * part);
            left_ -= done;
            work_.add(done);
        };
    }
    /// Counts what is left.
    void finish() { work_.add(std::exchange(left_, 0)); }

  private:
    Work& work_;
    double left_;
};

}  // namespace nmbcrun
