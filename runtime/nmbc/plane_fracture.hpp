// SPDX-License-Identifier: MIT
/// Bonds of a plane are cut, let break and counted. A part of plane.hpp. They break in
/// bond_sweeps.hpp, when forces are found.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/bond_force.hpp>
#include <nmbc/coefficients.hpp>
#include <nmbc/plane.hpp>
#include <stdexcept>
#include <utility>
#include <variant>

namespace nmbc {

template <class Real>
template <class Keep>
void BasicPlane<Real>::break_above(double stretch, const Keep& keep) {
    bonds_of(force_);
    if (!is_positive(std::get<BondModel>(model_.law()))) {
        throw std::invalid_argument(
            "this lattice has bonds of weights below 0: where others break, its energy has no "
            "lower bound, and it explodes");
    }
    break_above(stretch, keep, allow_unstable);
}

template <class Real>
template <class Keep>
void BasicPlane<Real>::break_above(double stretch, const Keep& keep, AllowUnstable /*tag*/) {
    bonds_of(force_);
    if (!(stretch > 0 && std::isfinite(stretch))) {
        throw std::invalid_argument("the stretch at which bonds break must be above 0");
    }
    for (const Side place : plane_sides) {
        const auto* const mirror = std::get_if<MirrorSide>(&sides_.at(place));
        if (mirror != nullptr && mirror->is_odd) {
            throw std::invalid_argument(
                "beside an odd mirror no bonds break: the image of one that is pulled is pushed");
        }
    }
    const std::array<std::ptrdiff_t, 2> first = first_of_interior();
    bonds_of(force_).states().let_break(
        [&](std::ptrdiff_t x, std::ptrdiff_t y) { return keep(x - first[0], y - first[1]); });
    bonds_of(force_).break_above(stretch * parameters_.spacing);
}

template <class Real>
void BasicPlane<Real>::cut(const PlanePoint& from, const PlanePoint& to) {
    if (!std::isfinite(from[0] + from[1] + to[0] + to[1]) || from == to) {
        throw std::invalid_argument("a cut needs two points that differ, of finite numbers");
    }
    const std::array<std::ptrdiff_t, 2> first = first_of_interior();
    const auto of_body = [&](const PlanePoint& point) {
        return PlanePoint{point[0] + static_cast<double>(first[0]),
                          point[1] + static_cast<double>(first[1])};
    };
    bonds_of(force_).states().cut(of_body(from), of_body(to));
}

template <class Real>
double BasicPlane<Real>::damage(std::size_t x, std::size_t y) const {
    if (x >= parameters_.nx || y >= parameters_.ny) {
        throw std::invalid_argument("damage: the node must be one of the interior");
    }
    const std::array<std::ptrdiff_t, 2> first = first_of_interior();
    return bonds_of(force_).states().damage(static_cast<std::ptrdiff_t>(x) + first[0],
                                            static_cast<std::ptrdiff_t>(y) + first[1]);
}

/// The body's energy had w e- e/2 of a bond that breaks, e- and e its extensions before and now: e-
/// = e - dt de/dt, the velocities v of the step that led here. The kick has changed them when its
/// breaks are known, by what it can be asked for again.
template <class Real>
void BasicPlane<Real>::count_broken() {
    auto* const of_bonds = std::get_if<detail::BondForce<Real>>(&force_);
    if (of_bonds == nullptr) {
        return;
    }
    detail::BondForce<Real>& bonds = *of_bonds;
    const double scale = kick_scale(parameters_.time_step);
    const auto u = field(std::as_const(u_));
    const auto v = field(std::as_const(v_));
    const auto before_kick = [&](const std::array<std::ptrdiff_t, 2>& node) {
        const auto [x, y] = node;
        const std::ptrdiff_t at = y * static_cast<std::ptrdiff_t>(grid().nx) + x;
        std::array<double, 2> velocity{static_cast<double>(v[0][at]),
                                       static_cast<double>(v[1][at])};
        if (bonds.states().is_in_body(node)) {
            const std::array<double, 2> kick = bonds.acceleration(x, y, u);
            velocity[0] -= scale * kick[0];
            velocity[1] -= scale * kick[1];
        }
        return velocity;
    };
    bonds.take_broken([&](const auto& bond) {
        const detail::BondGroup& group = bonds.states().groups()[bond.group];
        const auto [i, j] = group.members[bond.member];
        const auto other = bonds.states().original(bond.x + i, bond.y + j);
        // Both ends in a body count it.
        const double share = bonds.states().is_material(other) ? 0.5 : 1;
        const std::array<double, 2> here = before_kick({bond.x, bond.y});
        std::array<double, 2> there = before_kick(other);
        for (const std::size_t a : {0U, 1U}) {
            there[a] *= axis_of(0).sign(a, bond.x + i) * axis_of(1).sign(a, bond.y + j);
        }
        const double e = bonds.extension(bond.x, bond.y, bond.group, bond.member, u);
        const double grown =
            parameters_.time_step * (i * (there[0] - here[0]) + j * (there[1] - here[1]));
        broken_ += share;
        released_ += share * bonds.weight(bond.x, bond.y, group, bond.member) / 2 * e * (e - grown);
    });
}

}  // namespace nmbc
