// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen optimise: the matching points and the stride with which a condition of a given order
/// reflects least over a band.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/commands/recommend.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

struct Aim {
    /// Family, horizon, order, G, damping and time step; not its stride, nor its points.
    Specification what;
    std::optional<unsigned> stride;  ///< this one only; none: 1 to max(2n, 4)
    WaveNumberRange band{};          ///< no narrower than narrowest_band
};

/// The best condition found with one stride and one number of points, or the standard one.
struct Contender {
    Specification what;
    bool exists = false;
    double mean = 0;         ///< reflected energy over the band, by band_reflection.hpp, of the
    double largest = 0;      ///< exact table, in continuous time or in the aim's steps
    StepRange certified{};   ///< largest is 0: not certified
    ModalVerdict verdict{};  ///< why not
};

/// By stride, then by number of points, from none, the standard condition, to the order.
/// NMBC1 is the same in time steps and made without them.
/// Throws NoSuchBoundary where no stride has a standard condition.
std::vector<Contender> contenders(const Aim& aim, const Progress& progress);

/// The certified one that reflects least, the one with the fewest points of equal ones; none where
/// nothing is certified.
const Contender* best_of(const std::vector<Contender>& all);

/// All of them and the best, as a text for people that ends with the command that makes it.
/// Throws NotStable (require_stable.hpp), with the same table, where nothing is certified.
std::string optimisation(const Aim& aim, const Progress& progress);

}  // namespace nmbcgen
