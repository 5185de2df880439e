// SPDX-License-Identifier: MIT
/// Elastic moduli of isotropic solids, E = 1.
#pragma once

#include "generator/table/vector_model.hpp"

namespace nmbcgen {

/// Of so many dimensions: the energy of a strain is bulk tr^2/2 + shear times the square of its
/// deviator.
struct Moduli {
    Rational bulk;
    Rational shear;
};

/// In plane stress or strain: bulk is k' of Nicely 2018 (10). Throws NoSuchModel (family.hpp) where
/// Poisson's ratio does not allow it; none is 0.
Moduli plane_moduli(const VectorChoice& choice);

/// In space. Likewise.
Moduli solid_moduli(const VectorChoice& choice);

}  // namespace nmbcgen
