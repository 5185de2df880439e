// SPDX-License-Identifier: MIT
/// Summation by parts at the sides of a plane of correspondence, corners included.
#pragma once

#include <nmbc/correspondence_model.hpp>
#include <nmbc/plane_closure.hpp>

namespace nmbcgen {

/// Larger families take many seconds.
inline constexpr unsigned largest_closed_radius_squared = 25;

/// V D_x = Q_x with Q_x + Q_x^T = -H on the nodes of a side across x and 0 elsewhere, Q_x 1 = 0,
/// Q_x x = V 1, Q_x y = 0, and likewise of y: linear displacements have their own gradient, and
/// under the tractions of its stress, H of a length on each node of a surface, an even strain
/// rests. Of the model its radius and influence count; changed are the entries between
/// nodes less than max(n, 2) from a side, and in corners less than one more; of all such Q, V and
/// H those which differ least, by the sum of squares, from the lattice's own Q, from V = H = 7/10
/// on surfaces and 1 further in, and in corners from products of these.
///
/// Sides alone leave one more condition of theirs open, without which there are no corners: they
/// are found together. Throws std::domain_error where a volume is not positive.
nmbc::PlaneClosure plane_summation_by_parts(const nmbc::CorrespondenceModel& model);

}  // namespace nmbcgen
