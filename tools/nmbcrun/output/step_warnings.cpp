// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/output/step_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/terminal/duration.hpp"

namespace nmbcrun {
namespace {

double seconds_of(const StepsLeft& left) {
    return double(left.steps) * double(left.nodes) / left.pace;
}

std::string steps_in_words(const StepPlan& plan, double unit_of_time, const StepsLeft& left) {
    return fmt::format(
        "{:.3g} steps of {} nodes take about {} at {:g} node-steps a second: until time.end "
        "waves go {:.2g} dX",
        double(left.steps), left.nodes, duration(seconds_of(left)), left.pace,
        double(plan.steps) * plan.time_step / unit_of_time);
}

/// In bytes, about.
struct Sizes {
    double of_rows = 0;
    double of_fields = 0;
};

Sizes sizes_of(const Output& output) {
    constexpr double bytes_of_row = 200;
    constexpr double bytes_of_probe = 20;
    return {// a growing file and, at the end, its copy
            2 * output.rows * (bytes_of_row + output.probes * bytes_of_probe),
            output.snapshots * output.bytes_of_snapshot + output.bytes_at_end};
}

std::string files_in_words(const Output& output, double free) {
    constexpr double giga = 1e9;
    const auto [of_rows, of_fields] = sizes_of(output);
    const auto [most, less] =
        of_rows > of_fields ? std::pair(fmt::format("{:.3g} rows of energies", output.rows),
                                        "a larger output.every")
        : output.snapshots > 0
            ? std::pair(fmt::format("{:.3g} snapshots", output.snapshots),
                        "a larger output.snapshots")
            : std::pair(std::string("the field at the end"), "a run without output.field");
    return fmt::format(
        "the run writes about {:.2g} GB, {} most of it{}: {} writes less",
        (of_rows + of_fields) / giga, most,
        std::isfinite(free) ? fmt::format(", and {:.2g} GB are free", free / giga) : "", less);
}

}  // namespace

std::string length_of_run(const StepsLeft& left) {
    constexpr std::size_t many = 1'000'000;
    constexpr double minute = 60;
    const double seconds = seconds_of(left);
    return left.steps < many && seconds < minute
               ? ""
               : fmt::format(", about {} at {:g} node-steps a second", duration(seconds),
                             left.pace);
}

std::vector<std::string> warnings_of_steps(const StepPlan& plan, double unit_of_time,
                                           const StepsLeft& left) {
    std::vector<std::string> warnings;
    constexpr double short_cfl = 1e-3;
    if (plan.cfl < short_cfl) {
        warnings.push_back(fmt::format(
            "time steps of {:.3g}, {}, are {:.1g} of what the lattice allows: the run has {:.3g} "
            "of them",
            plan.time_step, plan.limit.empty() ? "as the scene asks for" : plan.limit, plan.cfl,
            double(plan.steps)));
    }
    constexpr double stiff = 0.02;  // 2/omega_max, which is 0.3 to 1 of usual lattices
    const double longest = plan.time_step / plan.cfl / unit_of_time;
    if (longest < stiff) {
        warnings.push_back(fmt::format(
            "the lattice is so stiff (a large model.G, or model.nu near its limit) that time steps "
            "above {:.2g} dX/c are unstable: the run has {:.3g} of them",
            longest, double(plan.steps)));
    }
    constexpr double hour = 3600;
    if (seconds_of(left) > hour) {
        warnings.push_back(steps_in_words(plan, unit_of_time, left));
    }
    return warnings;
}

void require_bearable_length(const StepPlan& plan, double unit_of_time, const StepsLeft& left) {
    constexpr double year = 365.25 * 24 * 3600;
    if (seconds_of(left) > 100 * year) {
        throw SceneError(steps_in_words(plan, unit_of_time, left) +
                         ". At most 100 years are allowed");
    }
}

std::string warning_of_files(const Output& output, double free) {
    constexpr double many = 2e9;
    const auto [of_rows, of_fields] = sizes_of(output);
    return of_rows + of_fields <= std::min(many, free) ? "" : files_in_words(output, free);
}

void require_space(const Output& output, double free) {
    constexpr double surplus = 4;  // rows may be half as long, and the copy is short-lived
    const auto [of_rows, of_fields] = sizes_of(output);
    if (of_rows / surplus + of_fields > free) {
        throw FileError(files_in_words(output, free));
    }
}

}  // namespace nmbcrun
