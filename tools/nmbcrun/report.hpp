// SPDX-License-Identifier: MIT
/// What a run says on stdout.
#pragma once

#include <span>
#include <string>

#include "tools/nmbcrun/output/sample.hpp"
#include "tools/nmbcrun/output/stoppable_run.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"

namespace nmbcrun {

/// The scene, before the run, in lines; not how long that is.
std::string heading_of(const Simulation& simulation);

/// A table of the samples.
void print_samples(std::span<const Sample> samples, double peak, bool damped);

/// What is left of the energy at the end, where the rest went, and how well that adds up.
void print_balance(const Sample& last, const Highlights& highlights, bool damped);

}  // namespace nmbcrun
