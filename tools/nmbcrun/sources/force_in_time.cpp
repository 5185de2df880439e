// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/force_in_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/csv_columns.hpp"
#include "tools/nmbcrun/scene/hdf5_input.hpp"
#include "tools/nmbcrun/sources/two_digits.hpp"

namespace nmbcrun {
namespace {

/// Of the peak: the most that may be cut off at the beginning or the end of a run without a word.
constexpr double negligible_part = 0.05;

bool has_middle(History history) {
    return history == History::gaussian || history == History::ricker;
}

}  // namespace

ForceInTime::ForceInTime(ForceHistory history, const std::string& column)
    : force_(std::move(history)) {
    if (force_.history == History::file) {
        const std::vector<std::string> names{"time", column};
        auto columns = force_.format == FileFormat::hdf5 ? read_datasets(force_.file, names)
                                                         : read_columns(force_.file, names);
        times_ = std::move(columns[0]);
        forces_ = std::move(columns[1]);
        const auto later = std::ranges::adjacent_find(times_, std::ranges::greater_equal());
        if (later != times_.end()) {
            throw SceneError(
                fmt::format("{}: its times must ascend from row to row, not from {} to {}",
                            force_.file.string(), *later, *std::next(later)));
        }
        if (times_.size() < 2 ||
            std::ranges::all_of(forces_, [](double force) { return force == 0; })) {
            throw SceneError(fmt::format(
                "{}: it drives nothing: a force needs two rows at least, and one that is not 0",
                force_.file.string()));
        }
    }
    constexpr double widths = 6.5;  // exp(-42), times the 84 of a ricker
    switch (force_.history) {
        case History::gaussian:
        case History::ricker:
            first_ = force_.time - widths * force_.duration;
            last_ = force_.time + widths * force_.duration;
            break;
        case History::sine:
            first_ = force_.time;
            last_ = force_.time + force_.cycles / force_.frequency;
            break;
        case History::file:
            first_ = force_.time + times_.front();
            last_ = force_.time + times_.back();
            break;
    }
}

/// |f|, between two times of which the first is not after the second.
double ForceInTime::largest(double from, double to) const {
    std::vector<double> extrema{from, to};
    const auto add = [&](double time) { extrema.push_back(std::clamp(time, from, to)); };
    switch (force_.history) {
        case History::gaussian:
            add(force_.time);
            break;
        case History::ricker: {
            const double trough = std::sqrt(1.5) * force_.duration;
            add(force_.time - trough);
            add(force_.time);
            add(force_.time + trough);
            break;
        }
        case History::sine: {
            const double quarter = 1 / (4 * force_.frequency);
            const double halves = std::ceil((from - force_.time - quarter) / (2 * quarter));
            add(force_.time + quarter + 2 * quarter * std::max(0.0, halves));
            break;
        }
        case History::file:
            for (const double row : times_) {
                add(force_.time + row);
            }
            break;
    }
    double most = 0;
    for (const double time : extrema) {
        most = std::max(most, std::abs(at(time)));
    }
    return most;
}

double ForceInTime::steepest_between_rows() const {
    double steepest = 0;
    for (std::size_t row = 1; row < times_.size(); ++row) {
        const double change = force_.amplitude * (forces_[row] - forces_[row - 1]);
        steepest = std::max(steepest, std::abs(change / (times_[row] - times_[row - 1])));
    }
    return steepest;
}

double ForceInTime::end() const {
    return has_middle(force_.history) ? force_.time + enough_durations * force_.duration : last_;
}

void ForceInTime::require_resolved(const std::string& table, double time_step) const {
    const auto require = [&](double lasts, double steps, const std::string& what,
                             const std::string& allowed) {
        if (lasts < steps * time_step) {
            throw SceneError(fmt::format(
                "{}.{}, less than {}: steps meet it by chance only. Give {}, or time.step = {:.2g} "
                "or less",
                table, what,
                steps == 1 ? fmt::format("a time step of {:.3g}", time_step)
                           : fmt::format("{} time steps of {:.3g}", steps, time_step),
                allowed, two_digits(lasts / steps, true)));
        }
    };
    if (has_middle(force_.history)) {
        require(force_.duration, 1, fmt::format("duration is {:.6g}", force_.duration),
                fmt::format("{}.duration = {:.3g} or more", table, two_digits(time_step, false)));
    }
    if (force_.history == History::sine) {
        constexpr double of_period = 4;
        constexpr double of_all = 2;
        require(1 / force_.frequency, of_period,
                fmt::format("frequency is {:.6g}, with a period of {:.3g}", force_.frequency,
                            1 / force_.frequency),
                fmt::format("{}.frequency = {:.3g} or less", table,
                            two_digits(1 / (of_period * time_step), true)));
        require(force_.cycles / force_.frequency, of_all,
                fmt::format("cycles is {:.6g}, which lasts {:.3g}", force_.cycles,
                            force_.cycles / force_.frequency),
                fmt::format("{}.cycles = {:.3g} or more", table,
                            two_digits(of_all * time_step * force_.frequency, false)));
    }
}

std::vector<std::string> ForceInTime::warnings(const std::string& table, double time_step) const {
    constexpr double endless = std::numeric_limits<double>::infinity();
    std::vector<std::string> all{missed_rows(time_step), jump_at_start(table, endless)};
    std::erase(all, "");
    return all;
}

std::vector<std::string> ForceInTime::warnings(const std::string& table, double time_step,
                                               double end) const {
    std::vector<std::string> all{missed_rows(time_step), jump_at_start(table, end),
                                 rest_after(end, table)};
    std::erase(all, "");
    return all;
}

std::string ForceInTime::jump_at_start(const std::string& table, double end) const {
    const bool is_cut = first_ < 0 && last_ >= 0;
    const double start = std::max(0.0, first_);
    const double jump =
        force_.history == History::file && !is_cut ? force_.amplitude * forces_.front() : at(start);
    const double cut = is_cut ? largest(first_, 0) : 0;
    if (std::max(cut, std::abs(jump)) <= negligible_part * peak()) {
        return "";
    }
    const auto later = [&] {
        const double middle = two_digits(enough_durations * force_.duration, false);
        const double over = middle + enough_durations * force_.duration;
        return fmt::format("{}.time = {:.4g}", table, middle) +
               (over > end ? fmt::format(" with time.end = {:.4g}", two_digits(over, false)) : "");
    };
    return fmt::format("{} jumps to {:.2g} of its peak at t = {:.4g}{}: {} would do", table,
                       jump / peak(), start, is_cut ? ", and what is before is cut off" : "",
                       has_middle(force_.history)        ? later()
                       : force_.history == History::sine ? table + ".time = 0"
                                                         : "a first row of 0, at t = 0 or later,");
}

std::string ForceInTime::rest_after(double end, const std::string& table) const {
    const double rest = last_ > end ? largest(std::max(end, first_), last_) : 0;
    if (rest <= negligible_part * peak() || stays(end)) {
        return "";
    }
    return fmt::format(
        "{} has not ended at time.end = {:.4g}: up to {:.2g} of its peak comes later. time.end = "
        "{:.4g} or more has all of it",
        table, end, rest / peak(), two_digits(this->end(), false));
}

bool ForceInTime::stays(double time) const {
    if (force_.history != History::file) {
        return false;
    }
    const double now = at(time);
    for (std::size_t row = 0; row < times_.size(); ++row) {
        const double change = std::abs(force_.amplitude * forces_[row] - now);
        if (force_.time + times_[row] > time && change > negligible_part * peak()) {
            return false;
        }
    }
    return true;
}

std::string ForceInTime::missed_rows(double time_step) const {
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
