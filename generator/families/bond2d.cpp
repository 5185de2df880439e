// SPDX-License-Identifier: MIT
/// Two-dimensional bond-based peridynamics, linearised: a spring for every bond.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
namespace {

/// The bond of its class with i >= j >= 0.
Offset class_of(const Offset& bond) {
    const int one = std::abs(bond[0]);
    const int other = std::abs(bond[1]);
    return {std::max(one, other), std::min(one, other), 0};
}

/// Whether every wave has omega^2 > 0: with weights below 0 on wave vectors in steps of pi/64.
bool is_stable(const std::vector<Offset>& classes, const std::vector<Rational>& weights) {
    if (std::ranges::all_of(weights, [](const Rational& weight) { return weight > 0; })) {
        return true;
    }
    constexpr int steps = 64;
    for (int x = 0; x <= steps; ++x) {
        for (int y = x == 0 ? 1 : 0; y <= x; ++y) {
            double xx = 0;
            double xy = 0;
            double yy = 0;
            for (std::size_t a = 0; a < classes.size(); ++a) {
                const double weight = nearest_double(weights[a]);
                for (const auto& [i, j] : {std::array{classes[a][0], classes[a][1]},
                                           std::array{classes[a][1], classes[a][0]}}) {
                    // Half of the bonds of the class; those with i, j and with i, -j are two.
                    for (const int sign : {1, -1}) {
                        const double phase = std::numbers::pi / steps * (i * x + sign * j * y);
                        const double stiffness = weight * (1 - std::cos(phase));
                        xx += stiffness * i * i;
                        xy += stiffness * sign * i * j;
                        yy += stiffness * j * j;
                    }
                }
            }
            if (!(xx + yy > 0 && xx * yy > xy * xy)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

VectorModel bond2d(const VectorChoice& choice) {
    const std::vector<Offset> classes = bond_classes_in_plane(choice.radius_squared);
    if (choice.weights.size() != classes.size() ||
        std::ranges::count(choice.weights, Rational(0)) > 0) {
        std::string list;
        for (const Offset& bond : classes) {
            list += fmt::format("{}({}, {})", list.empty() ? "" : ", ", bond[0], bond[1]);
        }
        throw NoSuchModel(fmt::format("{} weights are needed, none of them 0: of the bonds {}",
                                      classes.size(), list));
    }
    if (!is_stable(classes, choice.weights)) {
        throw NoSuchModel("with these weights the lattice has waves that grow");
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
    for (const Offset& bond : neighbours_in_plane(choice.radius_squared)) {
        if (bond < Offset{}) {
            continue;  // each bond once
        }
        // weight (R . (u_J - u_I))^2/2: a spring of the constant weight |R|^2.
        const auto which = std::ranges::find(classes, class_of(bond)) - classes.begin();
        const Rational& weight = choice.weights[std::size_t(which)];
        const std::array<Rational, 3> along{bond[0], bond[1], 0};
        const std::array<Rational, 3> against{-bond[0], -bond[1], 0};
        model.energy.push_back(
            {EnergyPart::strain, constant(weight), {{Offset{}, against}, {bond, along}}});
    }
    return model;
}

std::vector<VectorSquare> bond2d_at_edge(const VectorChoice& choice, unsigned /*layer*/,
                                         const Rational& /*beta*/) {
    return bond2d(choice).energy;  // a bond is counted with the node that is nearer to the edge
}

}  // namespace nmbcgen
