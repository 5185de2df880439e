// SPDX-License-Identifier: GPL-2.0-or-later
/// The linear equations of matching points, of which some are exact.
#pragma once

#include <vector>

#include "generator/exact/echelon.hpp"
#include "generator/exact/real.hpp"
#include "generator/table/exact.hpp"

namespace nmbcgen {

/// The unknowns to all digits, and rounded so that the exact rows hold exactly.
struct Solution {
    std::vector<Real> full;
    std::vector<Rational> rounded;
};

/// Unknowns that the exact rows leave free are rounded to so many digits behind the point; the
/// others follow from them. As many rows as unknowns in all. Empty where they are singular.
Solution solve(Rows<Rational> exact, const Rows<Real>& others, unsigned digits);

}  // namespace nmbcgen
