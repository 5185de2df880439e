// SPDX-License-Identifier: MIT
/// The energies of a plane. A part of plane.hpp.
#pragma once

#include <cstddef>
#include <nmbc/plane.hpp>
#include <nmbc/plane_potential.hpp>
#include <utility>
#include <variant>

namespace nmbc {

/// With m the mean of two displacements and d half of their difference, a quadratic form Q of both
/// is Q(m) - Q(d).
template <class Real>
PlaneEnergies BasicPlane<Real>::energies_of(const Window& window) const {
    const auto half = static_cast<Real>(parameters_.time_step / 2);
    Fields velocity = v_;
    close_ghosts(velocity);
    Fields mean = u_;
    close_ghosts(mean);
    for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t i = 0; i < mean[a].size(); ++i) {
            mean[a][i] -= half * velocity[a][i];
        }
    }
    const auto v = field(std::as_const(velocity));
    detail::PlanePotential potential;
    double lost = 0;
    PlaneEnergies sum;
    for (std::ptrdiff_t y = window.y.first; y < window.y.last; ++y) {
        double kinetic = 0;
        for (std::ptrdiff_t x = window.x.first; x < window.x.last; ++x) {
            const std::ptrdiff_t at = y * static_cast<std::ptrdiff_t>(grid().nx) + x;
            for (std::size_t a = 0; a < 2; ++a) {
                const auto own = static_cast<double>(v[a][at]);
                kinetic += mass_of(a, x, y) * own * own / 2;
            }
        }
        sum.kinetic += kinetic;
        const auto potential_of = [&](const detail::PlaneField<const Real>& u) {
            return std::visit(
                [&](const auto& force) {
                    return force.potential_of_row(y, window.x.first, window.x.last, u);
                },
                force_);
        };
        potential.add(potential_of(field(std::as_const(mean))));
        lost += potential_of(v).total();
    }
    const double E = parameters_.youngs_modulus;
    sum.kinetic *= parameters_.density * parameters_.spacing * parameters_.spacing;
    sum.strain = E * potential.strain;
    sum.stabilisation = E * potential.stabilisation;
    sum.staggered = sum.kinetic + E * (potential.total() -
                                       parameters_.time_step * parameters_.time_step / 4 * lost);
    return sum;
}

}  // namespace nmbc
