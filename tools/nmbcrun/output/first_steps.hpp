// SPDX-License-Identifier: MIT
/// How long a run takes, told by its first steps.
#pragma once

#include <cstddef>

#include "tools/nmbcrun/output/processor_clock.hpp"

namespace nmbcrun {

struct FirstSteps {
    std::size_t steps = 0;  ///< that were taken
    double a_step = 0;      ///< processor time [s]
};

/// Takes steps until their time can be measured, one at least, so many at most.
template <class Step>
FirstSteps take_first_steps(std::size_t most, const Step& step) {
    constexpr double enough = 0.02;  // [s]
    const double start = seconds_of_this_process();
    FirstSteps first;
    double taken = 0;
    do {
        step();
        ++first.steps;
        taken = seconds_of_this_process() - start;
    } while (first.steps < most && taken < enough);
    first.a_step = taken / double(first.steps);
    return first;
}

}  // namespace nmbcrun
