// SPDX-License-Identifier: GPL-2.0-or-later
/// What the order of a condition is worth: the energy that orders 1 to N leave of a pulse.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/table/table.hpp"

namespace stability_atlas {

struct OrdersQuestion {
    unsigned horizon = 1;
    nmbcgen::Rational G = 0;
    unsigned highest = 8;                       ///< order
    nmbcgen::Rational time_step{};              ///< of leapfrog [dX/c]; 0: n/2
    std::optional<unsigned> stride;             ///< none: the least that is certified
    std::optional<nmbcgen::Rational> damping;   ///< tau [c/dX]; none: the least that is certified
    std::vector<double> half_widths{3, 6, 12};  ///< [dX]
};

/// A Markdown table: a row for each order, for each half-width the part of the pulse's energy that
/// is left in a run, and as the modal analysis predicts it.
/// Throws nmbcgen::NoSuchBoundary where leapfrog itself is unstable in such steps.
std::string orders(OrdersQuestion question);

}  // namespace stability_atlas
