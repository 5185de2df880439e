// SPDX-License-Identifier: MIT
/// The lattice of a plane scene.
#pragma once

#include <nmbc/plane_model.hpp>
#include <optional>

#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// The scene's lattice, without what belongs to its sides.
nmbc::PlaneModel model_of(const PlaneScene& scene);

/// That of another scene than one of bonds.
nmbc::CorrespondenceModel nopd2d_of(const PlaneScene& scene);

/// The G at which long waves of a scene's lattice, whatever its own G, have their speed to fourth
/// order in xi, P or S, at every angle; below 0 where they are too fast without stabilisation.
double G_of_least_dispersion(PlaneScene scene, bool is_P);

/// That of a scene of bonds: is_bond_based().
nmbc::BondModel bonds_of(const PlaneScene& scene);

/// At which the scene's bonds break; nothing where none does. Of a fracture energy: that of a crack
/// along an axis whose bonds break.
std::optional<double> critical_stretch(const PlaneScene& scene);

/// sqrt(E/rho)/dX [1/time].
double rate_of(const PlaneScene& scene);

}  // namespace nmbcrun
