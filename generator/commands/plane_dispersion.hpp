// SPDX-License-Identifier: GPL-2.0-or-later
/// nmbcgen dispersion of plane models: phase and group velocities against the direction.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/families/vector_family.hpp"

namespace nmbcgen {

/// Which curves: one for each g and angle.
struct PlaneCurves {
    VectorChoice model;
    std::vector<double> angles;  ///< of the wave vector against x [degrees]
    unsigned samples = 200;
    bool limit = false;  ///< the family's continuum limit, too
};

inline constexpr std::string_view plane_dispersion_columns =
    "model,wave,radius2,g,angle,xi,omega,phase_velocity,group_velocity,group_angle\n";

/// At one g. CSV, at each angle first of the model 'lattice', then, with limit, of 'limit'
/// (VectorFamily::limit), of both first of P, then of S: followed from long waves on, of which
/// those of P move along the wave vector. A row for each xi = X i/samples, i = 1 .. samples, X
/// where the wave vector leaves -pi < xi_x, xi_y < pi: xi [1/dX], omega [c/dX], the phase velocity
/// and the size [c] and direction [degrees against x] of the group velocity, c = sqrt(E/rho). Where
/// omega vanishes, the group velocity is nan.
std::string plane_dispersion_rows(std::string_view family, const PlaneCurves& curves,
                                  const Rational& g);

}  // namespace nmbcgen
