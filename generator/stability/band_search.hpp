// SPDX-License-Identifier: MIT
/// The largest value of a function of frequency over a band whose narrow parts matter.
#pragma once

#include <functional>
#include <limits>
#include <vector>

namespace nmbcgen {

struct Peak {
    double value = 0;
    double omega = 0;
};

/// How fast the function may change at the ends of a piece.
enum class Sampling {
    sharp,  ///< like the square root of the distance
    smooth  ///< as damping leaves it
};

inline constexpr double narrowest_piece = 1e-9;

/// The largest value found in the pieces between neighbouring frequencies (ascending): samples,
/// dense at both ends of a piece, where waves meet and a square root of the distance counts, then
/// golden-section search around each sample that is higher than its neighbours. Pieces narrower
/// than `narrowest_piece` of the highest frequency are skipped: waves so near an extremum of the
/// band creep at 1e-6 of the wave speed, and their wave numbers cannot be told apart from
/// roundings. The search ends at the first value above `enough`; a summit below a finite `enough`
/// is not followed to its top.
Peak largest_over_band(const std::vector<double>& frequencies,
                       const std::function<double(double)>& function,
                       double enough = std::numeric_limits<double>::infinity(),
                       Sampling sampling = Sampling::sharp);

}  // namespace nmbcgen
