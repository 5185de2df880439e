// SPDX-License-Identifier: MIT
/// The energies of a plane. A part of plane.hpp.
#pragma once

#include <cstddef>
#include <nmbc/plane.hpp>
#include <nmbc/plane_force.hpp>
#include <nmbc/plane_potential.hpp>
#include <stdexcept>
#include <variant>
#include <vector>

namespace nmbc {

/// Energies [per thickness] at t - dt/2, where the velocity is known; the displacement there is the
/// mean of its two neighbours in time.
struct PlaneEnergies {
    double kinetic = 0;
    double strain = 0;         ///< of the stress sigma that belongs to the strain: sigma:e/2
    double stabilisation = 0;  ///< (s/2) sum |z|^2
    /// Kinetic energy plus the potential one, that of the null Lagrangian included, with u^k and
    /// u^{k+1} in its two places: of the whole body, a step lowers it by what leaves through
    /// passive sides and sponges and by what broken bonds had, and by nothing else unless ghosts
    /// move. `total` differs by O(dt^2).
    double staggered = 0;

    double total() const { return kinetic + strain + stabilisation; }
};

template <class Real>
typename BasicPlane<Real>::Window BasicPlane<Real>::window_of(
    const detail::PlaneAxis::Range& x, const detail::PlaneAxis::Range& y) const {
    const auto range = [](const detail::PlaneAxis::Range& nodes, std::size_t layers,
                          std::size_t all) {
        const auto before = static_cast<std::ptrdiff_t>(layers);
        if (nodes.first >= nodes.last || nodes.first < -before ||
            nodes.last + before > static_cast<std::ptrdiff_t>(all)) {
            throw std::invalid_argument(
                "energies: the nodes must be a range within the plane and its layers");
        }
        return detail::PlaneAxis::Range{nodes.first + before, nodes.last + before};
    };
    return {range(x, layers_[0], nx_), range(y, layers_[2], ny_)};
}

template <class Real>
double BasicPlane<Real>::volume(std::ptrdiff_t x, std::ptrdiff_t y) const {
    const auto* const force = std::get_if<detail::PlaneForce<Real>>(&force_);
    const auto shift = [this](std::size_t side) {
        return static_cast<std::ptrdiff_t>(layers_[side]);
    };
    return force == nullptr ? 1 : force->volume(x + shift(0), y + shift(2));
}

template <class Real>
typename BasicPlane<Real>::HalfStep BasicPlane<Real>::at_half_step() const {
    const auto half = static_cast<Real>(parameters_.time_step / 2);
    HalfStep now{u_, v_};
    close_ghosts(now.velocity);
    close_ghosts(now.mean);
    for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t i = 0; i < now.mean[a].size(); ++i) {
            now.mean[a][i] -= half * now.velocity[a][i];
        }
    }
    return now;
}

template <class Real>
double BasicPlane<Real>::kinetic_energy(std::ptrdiff_t x, std::ptrdiff_t y,
                                        const Fields& velocity) const {
    const std::ptrdiff_t at = y * static_cast<std::ptrdiff_t>(grid().nx) + x;
    double sum = 0;
    for (std::size_t a = 0; a < 2; ++a) {
        const auto own = static_cast<double>(field(velocity)[a][at]);
        sum += mass_of(a, x, y) * own * own / 2;
    }
    return parameters_.density * parameters_.spacing * parameters_.spacing * sum;
}

template <class Real>
detail::PlanePotential BasicPlane<Real>::potential_of_row(std::ptrdiff_t y,
                                                          const detail::PlaneAxis::Range& nodes,
                                                          const Fields& u) const {
    return std::visit(
        [&](const auto& force) {
            return force.potential_of_row(y, nodes.first, nodes.last, field(u));
        },
        force_);
}

/// With m the mean of two displacements and d half of their difference, a quadratic form Q of both
/// is Q(m) - Q(d).
template <class Real>
PlaneEnergies BasicPlane<Real>::energies_of(const Window& window) const {
    const HalfStep now = at_half_step();
    detail::PlanePotential potential;
    double lost = 0;
    PlaneEnergies sum;
    for (std::ptrdiff_t y = window.y.first; y < window.y.last; ++y) {
        double kinetic = 0;
        for (std::ptrdiff_t x = window.x.first; x < window.x.last; ++x) {
            kinetic += kinetic_energy(x, y, now.velocity);
        }
        sum.kinetic += kinetic;
        potential.add(potential_of_row(y, window.x, now.mean));
        lost += potential_of_row(y, window.x, now.velocity).total();
    }
    const double E = parameters_.youngs_modulus;
    sum.strain = E * potential.strain;
    sum.stabilisation = E * potential.stabilisation;
    sum.staggered = sum.kinetic + E * (potential.total() -
                                       parameters_.time_step * parameters_.time_step / 4 * lost);
    return sum;
}

template <class Real>
std::vector<double> BasicPlane<Real>::energies_of_nodes(const Window& window) const {
    const HalfStep now = at_half_step();
    std::vector<double> energies;
    for (std::ptrdiff_t y = window.y.first; y < window.y.last; ++y) {
        for (std::ptrdiff_t x = window.x.first; x < window.x.last; ++x) {
            const detail::PlanePotential own = potential_of_row(y, {x, x + 1}, now.mean);
            energies.push_back(kinetic_energy(x, y, now.velocity) +
                               parameters_.youngs_modulus * (own.strain + own.stabilisation));
        }
    }
    return energies;
}

template <class Real>
PlaneEnergies BasicPlane<Real>::energies() const {
    return energies_of({axis_of(0).with_own_energy(), axis_of(1).with_own_energy()});
}

template <class Real>
PlaneEnergies BasicPlane<Real>::energies(std::ptrdiff_t first_x, std::ptrdiff_t last_x,
                                         std::ptrdiff_t first_y, std::ptrdiff_t last_y) const {
    return energies_of(window_of({first_x, last_x}, {first_y, last_y}));
}

template <class Real>
std::vector<double> BasicPlane<Real>::energies_of_nodes(std::ptrdiff_t first_x,
                                                        std::ptrdiff_t last_x,
                                                        std::ptrdiff_t first_y,
                                                        std::ptrdiff_t last_y) const {
    return energies_of_nodes(window_of({first_x, last_x}, {first_y, last_y}));
}

template <class Real>
PlaneEnergies BasicPlane<Real>::interior_energies() const {
    return energies(0, static_cast<std::ptrdiff_t>(parameters_.nx), 0,
                    static_cast<std::ptrdiff_t>(parameters_.ny));
}

}  // namespace nmbc
