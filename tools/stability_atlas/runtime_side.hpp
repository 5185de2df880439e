// SPDX-License-Identifier: GPL-2.0-or-later
/// What was derived just now, for the runtime, without a table compiled in.
#pragma once

#include <nmbc/coefficients.hpp>
#include <nmbc/lattice.hpp>

#include "generator/stability/half_space.hpp"
#include "generator/table/table.hpp"

namespace stability_atlas {

/// The lattice of a model at G.
nmbc::Lattice make_lattice(const nmbcgen::Model& model, const nmbcgen::Rational& G);

/// The condition of a half space, matched in steps of matched_time_step [dX/c] (0: in continuous
/// time). It bears no certificate.
nmbc::BoundaryCoefficients make_coefficients(const nmbcgen::HalfSpace& half_space,
                                             double matched_time_step);

}  // namespace stability_atlas
