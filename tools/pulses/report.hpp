// SPDX-License-Identifier: MIT
/// The tables of docs/pulses.md.
#pragma once

#include <string>
#include <vector>

namespace pulses {

struct Question {
    std::vector<int> horizons;        ///< [dX]
    std::vector<std::string> values;  ///< of G >= 0, as fraction() reads them
    std::vector<double> half_widths;  ///< [dX]
    double cfl = 1;                   ///< of the steps, where 0.95 of the certified one is not less
    bool matched = false;             ///< order 2 or more matched in time steps, and all in these
};

/// Markdown: for each half-width, what is left of the pulse at each horizon and G; then what the
/// damping of these tables costs.
std::string report(const Question& question);

}  // namespace pulses
