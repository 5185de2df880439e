// SPDX-License-Identifier: GPL-2.0-or-later
#include "tools/stability_atlas/runtime_side.hpp"

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"

namespace stability_atlas {

using nmbcgen::nearest_double;
using nmbcgen::Rational;

nmbc::Lattice make_lattice(const nmbcgen::Model& model, const Rational& G) {
    nmbc::Lattice lattice;
    for (const nmbcgen::Polynomial& entry : model.symbol) {
        lattice.symbol.push_back(nearest_double(nmbcgen::evaluate(entry, G)));
    }
    for (const Rational& entry : model.damping) {
        lattice.damping.push_back(nearest_double(entry));
    }
    for (const nmbcgen::ExactSquare& square : model.energy) {
        const double weight = nearest_double(nmbcgen::evaluate(square.weight, G));
        if (weight == 0) {
            continue;
        }
        const bool strain = square.part == nmbcgen::EnergyPart::strain;
        lattice.energy.push_back(
            {strain ? nmbc::EnergyPart::strain : nmbc::EnergyPart::stabilisation, weight, {}});
        for (const Rational& entry : square.stencil) {
            lattice.energy.back().stencil.push_back(nearest_double(entry));
        }
    }
    return lattice;
}

nmbc::BoundaryCoefficients make_coefficients(const nmbcgen::HalfSpace& half_space,
                                             double matched_time_step) {
    nmbc::BoundaryCoefficients coefficients;
    coefficients.c = half_space.c;
    coefficients.b = half_space.b;
    coefficients.stride = half_space.stride;
    coefficients.matched_time_step = matched_time_step;
    return coefficients;
}

}  // namespace stability_atlas
