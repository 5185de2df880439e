// SPDX-License-Identifier: MIT
/// Models of a lattice whose nodes move in two or three directions. Units: dX = 1, and a node's
/// volume, the density and Young's modulus are 1 (bond models: the modulus that their weights
/// make).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/table/table.hpp"

namespace nmbcgen {

/// From a node to another one, in dX; the third is 0 in the plane.
using Offset = std::array<int, 3>;

/// What the displacement of one node adds to a square, direction by direction.
struct VectorTerm {
    Offset offset{};
    std::array<Rational, 3> factors{};
};

/// One square of the potential energy of a node I,
///     (1/2) weight(g) (sum over terms of factors . u_{I + offset})^2.
struct VectorSquare {
    EnergyPart part;
    Polynomial weight;  ///< in g = G/pi: stabilisation is proportional to it
    std::vector<VectorTerm> terms;
};

/// Which model of a family.
struct VectorChoice {
    unsigned radius_squared = 1;        ///< of a node's neighbours, delta^2 [dX^2]
    std::optional<Rational> poisson{};  ///< nu, of families that have one; none: 0
    bool plane_strain = false;          ///< or plane stress
    std::vector<Rational> weights{};    ///< of the bond classes, of families that have them
};

/// A lattice model as its energy: forces, dynamical matrix and projections follow from it.
struct VectorModel {
    std::string description;
    std::string source;  ///< the equations the model is taken from
    std::size_t dimensions = 2;
    std::vector<VectorSquare> energy;
};

}  // namespace nmbcgen
