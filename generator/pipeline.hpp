// SPDX-License-Identifier: GPL-2.0-or-later
/// The generator, stage by stage. Each stage is a function from data to data:
///
///   specification      family, horizon, order, stride, damping, time step,  table/table.hpp
///                      matching points, G or none
///     | make_model     a family's energy as squares, hence symbol, damping  families/family.hpp
///   model
///     | thaw           into the algebra system                              matching/freeze.hpp
///     | taylor         a_1 .. a_{2N+1} of the dispersion relation (47)      matching/taylor.hpp
///     | match          C(z), B(z) by diagonal Pade approximation (49)       matching/matching.hpp
///     |   or match_at_points, with other matching points than xi = 0        matching/points.hpp
///     | freeze         out of it, coefficient by coefficient                matching/freeze.hpp
///     | reduce         c_j, b_j as rational functions in normal form        exact/
///     | prove          residual of (49) and all else, exactly; at other     matching/proof.hpp
///                      matching points to 1e-30
///   table
///     | certify        windows of G in which it is stable, time steps stability/certify.hpp
///     | prove_certificate  at one G, which of that is more than sampled enclosures/prove.hpp
///   certified table
///     | emit_header, emit_json                                              emit/
///   text               written by main.cpp, nothing before all is proved
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// The condition asked for does not exist; what() is the mathematical reason, for people.
struct NoSuchBoundary : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Derives and proves one table.
/// Throws NoSuchBoundary, std::invalid_argument for an unknown family, damping that it cannot have,
/// or matching points without a G, beyond the order or out of order, and std::logic_error where the
/// proof fails (a defect of the generator).
Table derive(const Specification& specification);

/// Certifies the tables that have no certificate, on all cores. Takes seconds a table at horizons
/// and orders above 3, and minutes beyond order 5. progress: so many of so many are certified.
void certify_all(std::vector<Table>& tables,
                 const std::function<void(std::size_t, std::size_t)>& progress = {});

/// The tables kept in generated/, in the order of the registry.
std::vector<Specification> committed_set();

}  // namespace nmbcgen
