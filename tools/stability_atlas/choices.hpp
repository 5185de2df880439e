// SPDX-License-Identifier: GPL-2.0-or-later
/// Which committed table to take at a horizon and a G.
#pragma once

#include <string>
#include <vector>

namespace stability_atlas {

/// A Markdown table: a row for each committed nopd1d table of these horizons, a column for each G;
/// the largest stable cfl where it is stable with its like at the other end, and in bold the
/// largest with any other end that adds no energy.
std::string choices(const std::vector<unsigned>& horizons, const std::vector<double>& values);

}  // namespace stability_atlas
