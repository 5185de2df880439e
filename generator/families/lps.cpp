// SPDX-License-Identifier: MIT
/// The linear peridynamic solid (LPS) on square and cubic lattices, linearised: Seleson 2011,
/// Silling et al. 2007, in d = 2 or 3 dimensions, V = 1. With the extension e = R . (u_J - u_I)/|R|
/// of a bond R, its influence omega and m = sum omega |R|^2, a node has the energy
///     K theta^2/2 + (alpha/2) sum omega (e - theta |R|/d)^2,
///     theta = (d/m) sum omega |R| e,   alpha = d (d + 2) mu/m.
/// (In one dimension it is nopd1d: tests/families/exam_lps.cpp.)
#include <fmt/format.h>

#include <utility>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/families/moduli.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
namespace {

struct Solid {
    std::size_t dimensions;
    Moduli moduli;
    std::vector<Offset> classes;
    std::vector<Rational> influence;  ///< of each class
    std::vector<Offset> family;       ///< of a node in the body
};

Solid solid(const VectorChoice& choice, std::size_t dimensions, const Moduli& moduli) {
    Solid solid{.dimensions = dimensions,
                .moduli = moduli,
                .classes = bond_classes(choice.radius_squared, dimensions),
                .influence = choice.weights,
                .family = neighbours(choice.radius_squared, dimensions)};
    if (solid.influence.empty()) {
        solid.influence.assign(solid.classes.size(), Rational(1));
    }
    require_weights(solid.classes, solid.influence, false);
    return solid;
}

std::array<Rational, 3> times(const Offset& bond, const Rational& factor) {
    return {bond[0] * factor, bond[1] * factor, bond[2] * factor};
}

/// The square of sum over the family of factor . (u_J - u_I).
VectorSquare of_differences(const Rational& weight, std::vector<VectorTerm> terms) {
    VectorTerm own;
    for (const VectorTerm& term : terms) {
        for (std::size_t a = 0; a < own.factors.size(); ++a) {
            own.factors[a] -= term.factors[a];
        }
    }
    terms.push_back(own);
    return {EnergyPart::strain, constant(weight), std::move(terms)};
}

std::vector<VectorSquare> node_energy(const Solid& solid) {
    const auto& family = solid.family;
    const auto d = Rational(solid.dimensions);
    Rational volume = 0;  // m
    for (const Offset& bond : family) {
        volume += weight_of(bond, solid.classes, solid.influence) * length_squared(bond);
    }
    const Rational alpha = d * (d + 2) * solid.moduli.shear / volume;
    /// theta, times a factor
    const auto dilatation = [&](const Rational& factor) {
        std::vector<VectorTerm> terms;
        for (const Offset& bond : family) {
            const Rational& omega = weight_of(bond, solid.classes, solid.influence);
            terms.push_back({bond, times(bond, factor * d / volume * omega)});
        }
        return terms;
    };
    std::vector<VectorSquare> energy{of_differences(solid.moduli.bulk, dilatation(1))};
    for (std::size_t own = 0; own < family.size(); ++own) {
        // |R| (e - theta |R|/d)
        const Offset& bond = family[own];
        const Rational square = length_squared(bond);
        std::vector<VectorTerm> terms = dilatation(-square / d);
        for (std::size_t a = 0; a < bond.size(); ++a) {
            terms[own].factors[a] += bond[a];
        }
        energy.push_back(of_differences(
            alpha * weight_of(bond, solid.classes, solid.influence) / square, std::move(terms)));
    }
    return energy;
}

VectorModel described(const Solid& solid, const VectorChoice& choice, const std::string& state) {
    std::string influence;
    for (const Rational& omega : choice.weights) {
        influence += " " + to_string(omega);
    }
    return {.description = fmt::format(
                "{}D linear peridynamic solid, {}nu = {}, {} influence{}, family radius {} "
                "(squared, in dX^2)",
                solid.dimensions, state, to_string(choice.poisson.value_or(0)),
                influence.empty() ? "constant" : "with the", influence, choice.radius_squared),
            .source = "Silling et al. 2007: linear peridynamic solid, linearised",
            .dimensions = solid.dimensions,
            .energy = node_energy(solid)};
}

}  // namespace

VectorModel lps2d(const VectorChoice& choice) {
    return described(solid(choice, 2, plane_moduli(choice)), choice,
                     choice.plane_strain ? "plane strain, " : "plane stress, ");
}

VectorModel lps3d(const VectorChoice& choice) {
    return described(solid(choice, 3, solid_moduli(choice)), choice, "");
}

}  // namespace nmbcgen
