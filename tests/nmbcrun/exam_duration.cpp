// SPDX-License-Identifier: GPL-2.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/step_warnings.hpp"
#include "tools/nmbcrun/terminal/duration.hpp"

namespace {

TEST_CASE("durations are written as one says them") {
    for (const auto& [seconds, words] : {std::pair(0.0123, "0.012 s"),
                                         {0.38, "0.38 s"},
                                         {9.94, "9.9 s"},
                                         {9.96, "10 s"},
                                         {110.4, "110 s"},
                                         {130.0, "2 min"},
                                         {7100.0, "118 min"},
                                         {9000.0, "2.5 h"},
                                         {172700.0, "48.0 h"},
                                         {1e6, "12 days"},
                                         {1.2e8, "3.8 years"},
                                         {1e20, "3.2e+12 years"}}) {
        CHECK(nmbcrun::duration(seconds) == words);
    }
}

TEST_CASE("a run of many steps, or of very short ones, is told before it begins") {
    using nmbcrun::require_bearable_length;
    using nmbcrun::warnings_of_steps;
    const auto plan = [](double time_step, std::size_t steps, double cfl) {
        return nmbcrun::StepPlan{.time_step = time_step, .steps = steps, .cfl = cfl};
    };
    const auto left = [](std::size_t steps, std::size_t nodes) {
        return nmbcrun::StepsLeft{steps, nodes, nmbcrun::plane_pace};
    };
    // An hour at 1e8 node-steps a second is 3.6e11 of them.
    CHECK(warnings_of_steps(plan(0.2, 1'000'000'000, 0.9), 0.5, left(1'000'000'000, 360)).empty());
    const std::vector<std::string> many{
        "1e+09 steps of 720 nodes take about 2.0 h at 1e+08 node-steps a second: until time.end "
        "waves go 4e+08 dX"};
    CHECK(warnings_of_steps(plan(0.2, 1'000'000'000, 0.9), 0.5, left(1'000'000'000, 720)) == many);
    // A warning refuses nothing.
    CHECK(warnings_of_steps(plan(0.2, 1'000'000'000, 0.9), 0.5, left(1'000'000'000, 720'000'000))
              .size() == 1);
    CHECK_NOTHROW(
        require_bearable_length(plan(0.2, 1'000'000'000, 0.9), 0.5, left(1'000'000'000, 720)));
    CHECK_THROWS_WITH_AS(
        require_bearable_length(plan(0.2, 1'000'000'000, 0.9), 0.5,
                                left(1'000'000'000, 720'000'000)),
        "1e+09 steps of 720000000 nodes take about 2.3e+02 years at 1e+08 node-steps a second: "
        "until "
        "time.end waves go 4e+08 dX. At most 100 years are allowed",
        nmbcrun::SceneError);
    // What is left of them after a checkpoint.
    CHECK(warnings_of_steps(plan(0.2, 1'000'000'000, 0.9), 0.5, left(1'000'000, 720)).empty());
    // Steps of 0.0045 dX/c at nine tenths of the limit.
    const std::vector<std::string> stiff{
        "the lattice is so stiff (a large model.G, or model.nu near its limit) that time steps "
        "above 0.005 dX/c are unstable: the run has 1.23e+05 of them"};
    CHECK(warnings_of_steps(plan(0.00225, 123'000, 0.9), 0.5, left(123'000, 9)) == stiff);
    const std::vector<std::string> small{
        "time steps of 0.0001, as the scene asks for, are 0.0009 of what the lattice allows: the "
        "run has 1.23e+05 of them"};
    CHECK(warnings_of_steps(plan(1e-4, 123'000, 9e-4), 0.5, left(123'000, 9)) == small);
}

TEST_CASE("files that are large, or do not fit, are told before a run begins") {
    using nmbcrun::require_space;
    using nmbcrun::warning_of_files;
    constexpr double giga = 1e9;
    CHECK(warning_of_files({.rows = 1e6, .snapshots = 100, .bytes_of_snapshot = 1e6}, 80 * giga)
              .empty());
    CHECK(warning_of_files({.rows = 1e6, .snapshots = 100, .bytes_of_snapshot = 1e6}, 0.3 * giga) ==
          "the run writes about 0.5 GB, 1e+06 rows of energies most of it, and 0.3 GB are free: a "
          "larger output.every writes less");
    const nmbcrun::Output large{.rows = 1e4, .snapshots = 1e5, .bytes_of_snapshot = 3.2e7};
    CHECK(!warning_of_files(large, 80 * giga).empty());
    CHECK_NOTHROW(require_space(large, 4000 * giga));
    CHECK_THROWS_WITH_AS(
        require_space(large, 80 * giga),
        "the run writes about 3.2e+03 GB, 1e+05 snapshots most of it, and 80 GB are free: a "
        "larger output.snapshots writes less",
        nmbcrun::FileError);
    CHECK_THROWS_WITH_AS(
        require_space({.rows = 10, .bytes_at_end = 5 * giga}, giga),
        "the run writes about 5 GB, the field at the end most of it, and 1 GB are free: a run "
        "without output.field writes less",
        nmbcrun::FileError);
    // Sizes of rows are estimates.
    CHECK_THROWS_AS(require_space({.rows = 1e6}, 0.09 * giga), nmbcrun::FileError);
}

}  // namespace
