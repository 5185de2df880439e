// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen recommend: which boundary to use at a horizon and a G.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "generator/table/table.hpp"
#include "generator/table/wave_number_range.hpp"

namespace nmbcgen {

struct Question {
    std::string family = "nopd1d";
    unsigned horizon = 1;
    std::vector<Rational> weights{};  ///< as in Specification
    Rational G = 0;
    std::optional<unsigned> order;  ///< exactly this one; none: 1 to 4
    /// Of the mean reflected energy; none: 1e-6, or the next power of ten that an undamped
    /// condition keeps; from 1e-2 on a damped one will do.
    std::optional<double> tolerance;
    WaveNumberRange band{0.05, 0.3};  ///< the reflected energy is averaged over
    std::optional<double> cfl;  ///< of the steps; none: the largest that are within the tolerance
};

/// What `progress` hears of, from any thread: so much of so much is examined.
using Progress = std::function<void(std::size_t done, std::size_t all)>;

/// The recommended one and the others, as a text for people. Examined are orders 1 to 6 (or the one
/// asked for) with strides 1 to n + 2, those above order 1 also matched in time steps. Of those
/// within the tolerance less damping comes first, since it changes the model, then larger steps,
/// then less reflection. Throws NoSuchBoundary, with the same table, where none is within it.
std::string recommendation(const Question& question, const Progress& progress);

}  // namespace nmbcgen
