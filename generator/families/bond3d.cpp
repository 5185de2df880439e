// SPDX-License-Identifier: MIT
/// Bond-based peridynamics of a cubic lattice, linearised: a spring for every bond. With weights
/// omega(|R|)/|R|^3 it is the prototype microelastic brittle model (PMB), or GPMB, of Seleson 2011.
#include <fmt/format.h>

#include "generator/exact/rational.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {

VectorModel bond3d(const VectorChoice& choice) {
    constexpr std::size_t dimensions = 3;
    const std::vector<Offset> classes = bond_classes(choice.radius_squared, dimensions);
    require_weights(classes, choice.weights, false);
    VectorModel model{
        .description = fmt::format("3D bond-based peridynamics, cubic lattice, family radius {} "
                                   "(squared, in dX^2), weights",
                                   choice.radius_squared),
        .source = "Silling 2000: bond-based, linear in the stretch of a bond",
        .dimensions = dimensions,
        .energy = springs(neighbours(choice.radius_squared, dimensions), classes, choice.weights)};
    for (const Rational& weight : choice.weights) {
        model.description += " " + to_string(weight);
    }
    return model;
}

}  // namespace nmbcgen
