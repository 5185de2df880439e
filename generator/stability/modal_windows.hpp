// SPDX-License-Identifier: MIT
/// Where a matching boundary is stable between like ends, as a set of G.
#pragma once

#include <vector>

#include "generator/table/certificate.hpp"
#include "generator/table/table.hpp"

namespace nmbcgen {

struct ModalWindows {
    std::vector<StabilityWindow> modal;        ///< Grade::paired or better
    std::vector<StabilityWindow> contractive;  ///< Grade::contractive
    std::vector<double> critical;              ///< values of G, ascending; none of a damped lattice
};

/// The windows of G >= 0, ascending, of a table whose G is open.
///
/// Between neighbouring critical values (critical_values.hpp) stability_grade() is sampled 8 to 24
/// times, and beyond the last one at twice its value and so on up to 1000 times: a window that
/// lasts so far has no upper edge. Edges are bisected, and are the critical value where they lie
/// at one. A gap or a window with no critical value inside may be missed if it is narrower than
/// 1/8 of the gap between its neighbours. Poles and C(1) = 0 are left out exactly.
/// Of a damped lattice G is sampled from 0 to 3 in steps of 1/16, more densely near poles; the
/// upper edge 3 means only that nothing was sought above.
/// G = 0, the model without stabilisation, is a window by itself where it is stable and its
/// neighbours are not.
/// Throws std::invalid_argument for a table at a fixed G.
ModalWindows modal_windows(const Table& table);

}  // namespace nmbcgen
