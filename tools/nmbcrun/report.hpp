// SPDX-License-Identifier: MIT
/// What a run says on stdout.
#pragma once

#include "tools/nmbcrun/output/checkpoint.hpp"
#include "tools/nmbcrun/output/sample.hpp"
#include "tools/nmbcrun/simulation/simulation.hpp"

namespace nmbcrun {

/// The scene, before the run.
void print_heading(const Simulation& simulation);

/// A table of the samples.
void print_samples(const Highlights& highlights, bool damped);

/// What is left of the energy at the end, where the rest went, and how well that adds up.
void print_balance(const Highlights& highlights, bool damped);

}  // namespace nmbcrun
