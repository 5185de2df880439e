// SPDX-License-Identifier: MIT
/// Two-dimensional bond-based peridynamics, linearised: a spring for every bond.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/bond_lattice.hpp"
#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
std::vector<VectorSquare> springs(std::span<const Offset> family, std::span<const Offset> classes,
                                  std::span<const Rational> weights) {
    std::vector<VectorSquare> energy;
    for (const Offset& bond : family) {
        if (bond < Offset{}) {
            continue;  // each bond once
        }
        // weight (R . (u_J - u_I))^2/2: a spring of the constant weight |R|^2.
        const std::array<Rational, 3> along{bond[0], bond[1], bond[2]};
        const std::array<Rational, 3> against{-bond[0], -bond[1], -bond[2]};
        energy.push_back({EnergyPart::strain,
                          constant(weight_of(bond, classes, weights)),
                          {{Offset{}, against}, {bond, along}}});
    }
    return energy;
}

VectorModel bond2d(const VectorChoice& choice) {
    const std::vector<Offset> classes = bond_classes_in_plane(choice.radius_squared);
    require_weights(classes, choice.weights, true);
    if (std::ranges::any_of(choice.weights, [](const Rational& weight) { return weight < 0; })) {
        std::vector<double> weights;
        for (const Rational& weight : choice.weights) {
            weights.push_back(nearest_double(weight));
        }
        if (!(BondLattice(classes, weights).least_squared_speed() > 0)) {
            throw NoSuchModel(
                "with these weights the lattice has waves that grow: omega^2 is not above 0");
        }
    }
    VectorModel model{.description = fmt::format("2D bond-based peridynamics, family radius {} "
                                                 "(squared, in dX^2), weights",
                                                 choice.radius_squared),
                      .source = "Silling 2000: bond-based, linear in the stretch of a bond",
                      .dimensions = 2,
                      .energy = {}};
    for (const Rational& weight : choice.weights) {
        model.description += " " + to_string(weight);
    }
    model.energy = springs(neighbours_in_plane(choice.radius_squared), classes, choice.weights);
    return model;
}

std::vector<VectorSquare> bond2d_at_edge(const VectorChoice& choice, unsigned /*layer*/,
                                         const Rational& /*beta*/) {
    return bond2d(choice).energy;  // a bond is counted with the node that is nearer to the edge
}

}  // namespace nmbcgen
