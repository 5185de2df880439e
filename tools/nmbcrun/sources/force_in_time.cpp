// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/force_in_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/csv_columns.hpp"

namespace nmbcrun {

ForceInTime::ForceInTime(ForceHistory history, const std::string& column)
    : force_(std::move(history)) {
    if (force_.history == History::file) {
        auto columns = read_columns(force_.file, {"time", column});
        times_ = std::move(columns[0]);
        forces_ = std::move(columns[1]);
        if (std::ranges::adjacent_find(times_, std::ranges::greater_equal()) != times_.end()) {
            throw SceneError(force_.file.string() + ": its times must ascend from row to row");
        }
    }
    constexpr double widths = 6.5;  // exp(-42), times the 84 of a ricker
    switch (force_.history) {
        case History::gaussian:
        case History::ricker:
            last_ = force_.time + widths * force_.duration;
            break;
        case History::sine:
            last_ = force_.time + force_.cycles / force_.frequency;
            break;
        case History::file:
            last_ = force_.time + times_.back();
            break;
    }
}

std::string ForceInTime::warning(double time_step) const {
    double shortest = time_step;
    for (std::size_t row = 1; row < times_.size(); ++row) {
        shortest = std::min(shortest, times_[row] - times_[row - 1]);
    }
    constexpr double as_long = 1 - 1e-5;  // to the digits that are printed
    if (shortest >= time_step * as_long) {
        return "";
    }
    return fmt::format(
        "{} has rows {:.6g} apart, less than a time step of {:.6g}, so that what is between two "
        "steps is missed: give time.step = {:.6g} or less",
        force_.file.string(), shortest, time_step, shortest);
}

double ForceInTime::linear_between_rows(double time) const {
    if (time < times_.front() || time > times_.back()) {
        return 0;
    }
    const auto after = std::ranges::upper_bound(times_, time);
    if (after == times_.end()) {
        return forces_.back();
    }
    const auto row = std::size_t(after - times_.begin());
    const double share = (time - times_[row - 1]) / (times_[row] - times_[row - 1]);
    return forces_[row - 1] + share * (forces_[row] - forces_[row - 1]);
}

double ForceInTime::at(double time) const {
    const double since = time - force_.time;
    const auto square = [&] { return std::pow(since / force_.duration, 2); };
    switch (force_.history) {
        case History::gaussian:
            return force_.amplitude * std::exp(-square());
        case History::ricker:
            return force_.amplitude * (1 - 2 * square()) * std::exp(-square());
        case History::sine:
            return since < 0 || time > last_
                       ? 0
                       : force_.amplitude *
                             std::sin(2 * std::numbers::pi * force_.frequency * since);
        case History::file:
            break;
    }
    return force_.amplitude * linear_between_rows(since);
}

}  // namespace nmbcrun
