// SPDX-License-Identifier: MIT
/// A plane is put together: its forces, and what its sides put on its nodes: dashpots, friction,
/// conditions of ghosts. A part of plane.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <nmbc/plane.hpp>
#include <nmbc/plane_requirements.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace nmbc {

template <class Real>
BasicPlane<Real>::BasicPlane(const PlaneModel& model, const PlaneSides& sides,
                             const PlaneParameters& parameters)
    : model_(detail::model_between(sides, model)),
      sides_(sides),
      parameters_(detail::checked(parameters)),
      ghosts_(model.reach()),
      layers_{layers_of(sides.left), layers_of(sides.right), layers_of(sides.bottom),
              layers_of(sides.top)},
      nx_(parameters.nx + layers_[0] + layers_[1]),
      ny_(parameters.ny + layers_[2] + layers_[3]),
      force_(force_of(model_.law())),
      damping_(damping_of(model_.law())) {
    if (nx_ < least_nodes(0) || ny_ < least_nodes(1)) {
        throw std::invalid_argument(
            "beside a halo or a mirror, and of bonds between periodic sides, a body needs " +
            std::to_string(ghosts_) + " nodes");
    }
    for (std::size_t a = 0; a < 2; ++a) {
        u_[a].resize(grid().nx * grid().ny, 0);
        v_[a].resize(grid().nx * grid().ny, 0);
        damping_change_[a].resize(damping_ ? v_[a].size() : 0, 0);
    }
    add_dashpots();
    add_ghost_lines();
    add_friction();
}

template <class Real>
typename BasicPlane<Real>::Force BasicPlane<Real>::force_of(
    const std::variant<CorrespondenceModel, BondModel>& law) const {
    const auto pitch = static_cast<std::ptrdiff_t>(grid().nx);
    detail::PlaneAxis x(sides_.left, sides_.right, 0, nx_, model_.horizon());
    detail::PlaneAxis y(sides_.bottom, sides_.top, 1, ny_, model_.horizon());
    if (const auto* const correspondence = std::get_if<CorrespondenceModel>(&law)) {
        const auto closure = detail::closure_of(sides_, correspondence);
        return detail::PlaneForce<Real>(
            detail::PlaneNodes(*correspondence, std::move(x), std::move(y), pitch, closure.get()));
    }
    detail::closure_of(sides_, nullptr);
    return detail::BondForce<Real>(std::get<BondModel>(law), {std::move(x), std::move(y)}, pitch);
}

template <class Real>
std::size_t BasicPlane<Real>::layers_of(const PlaneSide& side) const {
    if (const auto* const sponge = std::get_if<SpongeSide>(&side)) {
        return sponge->friction.size();
    }
    const std::size_t own = detail::own_layers(side);
    return own == 0 ? 0 : own + model_.horizon();
}

template <class Real>
std::size_t BasicPlane<Real>::least_nodes(std::size_t axis) const {
    const PlaneSide& low = sides_.at({axis, End::left});
    const PlaneSide& high = sides_.at({axis, End::right});
    const bool has_bonds = std::holds_alternative<BondModel>(model_.law());
    const auto copies = [](const PlaneSide& side) {
        return std::holds_alternative<HaloSide>(side) || std::holds_alternative<MirrorSide>(side);
    };
    const bool is_copied =
        (std::holds_alternative<PeriodicSide>(low) && has_bonds) || copies(low) || copies(high);
    return is_copied ? ghosts_ : 1;
}

/// The sides across y first: the ghosts in a corner move by the condition of the side across x.
template <class Real>
void BasicPlane<Real>::add_ghost_lines() {
    const ChainParameters chain{.nodes = 0,
                                .spacing = parameters_.spacing,
                                .youngs_modulus = parameters_.youngs_modulus,
                                .density = parameters_.density,
                                .time_step = parameters_.time_step};
    const std::array<std::size_t, 2> nodes{nx_, ny_};
    for (const std::size_t number : {2U, 3U, 0U, 1U}) {
        const Side side = plane_sides[number];
        if (!detail::has_condition(sides_.at(side))) {
            continue;
        }
        moving_ghosts_[number] = ghosts_;
        const std::size_t along = 1 - side.axis;
        std::size_t first = ghosts_;
        std::size_t last = ghosts_ + nodes[along];
        if (along == 1) {
            first -= moving_ghosts_[2];
            last += moving_ghosts_[3];
        }
        const auto& lines =
            ghost_lines_.emplace_back(sides_.at(side), side, grid(), ghosts_, first, last, chain);
        if (nodes[side.axis] < lines.least_interior_nodes()) {
            throw std::invalid_argument("the body is too thin for the conditions of its sides: " +
                                        std::to_string(lines.least_interior_nodes()) +
                                        " nodes are needed");
        }
    }
}

/// gamma of a sponge on the layer that is so far from its side; 0 elsewhere.
template <class Real>
double BasicPlane<Real>::friction_of(std::size_t number, std::ptrdiff_t layer) const {
    const auto* const sponge = std::get_if<SpongeSide>(&sides_.at(plane_sides[number]));
    return sponge == nullptr || static_cast<std::size_t>(layer) >= sponge->friction.size()
               ? 0
               : sponge->friction[static_cast<std::size_t>(layer)];
}

/// Of the nodes that have no dashpots.
template <class Real>
void BasicPlane<Real>::add_friction() {
    if (std::ranges::none_of(plane_sides, [this](Side side) {
            return std::holds_alternative<SpongeSide>(sides_.at(side));
        })) {
        return;
    }
    const double step = parameters_.time_step * parameters_.rate();
    const auto gamma = [&](std::size_t number, std::size_t layer) {
        return step * friction_of(number, static_cast<std::ptrdiff_t>(layer));
    };
    for (std::size_t y = 0; y < ny_; ++y) {
        const std::array<double, 2> across_y{gamma(2, y), gamma(3, ny_ - 1 - y)};
        for (std::size_t x = 0; x < nx_; ++x) {
            const std::array<double, 2> across_x{gamma(0, x), gamma(1, nx_ - 1 - x)};
            const std::array<double, 2> gammas{across_x[0] + across_x[1],
                                               across_y[0] + across_y[1]};
            const auto of_passive = [](const detail::PlaneAxis& axis, std::size_t node) {
                return axis.is_passive(static_cast<std::ptrdiff_t>(node));
            };
            if ((gammas[0] > 0 || gammas[1] > 0) && !of_passive(axis_of(0), x) &&
                !of_passive(axis_of(1), y)) {
                friction_.add(
                    static_cast<std::ptrdiff_t>(y * grid().nx + x), gammas,
                    {across_x[1] > 0 ? 1U : 0U, across_y[1] > 0 ? 3U : 2U},
                    mass_of(0, static_cast<std::ptrdiff_t>(x), static_cast<std::ptrdiff_t>(y)));
            }
        }
    }
}

template <class Real>
void BasicPlane<Real>::add_dashpots() {
    for (std::size_t number = 0; number < plane_sides.size(); ++number) {
        add_line_dashpots(number);
    }
    for (const std::size_t across_x : {0U, 1U}) {
        for (const std::size_t across_y : {2U, 3U}) {
            add_corner_dashpots(across_x, across_y);
        }
    }
}

/// That closed sides give the nodes of a line across another side; 1: it is not near one.
template <class Real>
double BasicPlane<Real>::volume_of_line(std::size_t number, std::ptrdiff_t line) const {
    const std::ptrdiff_t outermost = node_of_layer(number, 0);
    const auto* const force = std::get_if<detail::PlaneForce<Real>>(&force_);
    if (force == nullptr) {
        return 1;
    }
    return plane_sides[number].axis == 0 ? force->volume(outermost, line)
                                         : force->volume(line, outermost);
}

/// Of the lines of nodes across a side that are not in a corner. Where a sponge along the line's
/// other axis covers them, its friction joins their dashpots; beside a closed side they are
/// weighted by its volumes.
template <class Real>
void BasicPlane<Real>::add_line_dashpots(std::size_t number) {
    const auto* const passive = std::get_if<PassiveSide>(&sides_.at(plane_sides[number]));
    if (passive == nullptr) {
        return;
    }
    const std::size_t axis = plane_sides[number].axis;
    const std::size_t along = 1 - axis;
    const auto pitch = static_cast<std::ptrdiff_t>(grid().nx);
    const auto count = static_cast<std::ptrdiff_t>(passive->strain.size());
    std::vector<std::ptrdiff_t> offsets;
    for (std::ptrdiff_t layer = 0; layer < count; ++layer) {
        offsets.push_back(node_of_layer(number, layer) * (axis == 0 ? 1 : pitch));
    }
    const auto last = static_cast<std::ptrdiff_t>(along == 0 ? nx_ : ny_) - 1;
    const detail::PlaneAxis& other = axis_of(along);
    std::map<std::array<double, 3>, std::vector<std::ptrdiff_t>> groups;  // by friction, volume
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
        if (!other.is_passive(i)) {
            groups[{friction_of(2 * along, i), friction_of(2 * along + 1, last - i),
                    volume_of_line(number, i)}]
                .push_back(i * (axis == 0 ? pitch : 1));
        }
    }
    for (const auto& [group, lines] : groups) {
        const auto times_volume = [V = group[2]](std::vector<double> numbers) {
            std::ranges::for_each(numbers, [V](double& one) { one *= V; });
            return numbers;
        };
        for (std::size_t a = 0; a < 2; ++a) {
            const std::size_t part = a == axis ? 0 : 1;
            const std::vector<double> mass = times_volume(passive->mass[part]);
            std::vector<typename detail::DashpotGroups<Real>::OfSide> sides{
                {number, times_volume(passive->dashpots[part])}};
            for (const std::size_t end : {0U, 1U}) {
                sides.push_back({2 * along + end, detail::friction_matrix(group[end], mass)});
            }
            dashpots_.emplace_back(a, offsets, lines, mass, sides,
                                   parameters_.time_step * parameters_.rate());
        }
    }
}

/// C of two sides that meet is the sum of both, each weighted along its side by V of the other one.
template <class Real>
void BasicPlane<Real>::add_corner_dashpots(std::size_t across_x, std::size_t across_y) {
    const auto* const of_x = std::get_if<PassiveSide>(&sides_.at(plane_sides[across_x]));
    const auto* const of_y = std::get_if<PassiveSide>(&sides_.at(plane_sides[across_y]));
    if (of_x == nullptr || of_y == nullptr) {
        return;
    }
    const std::size_t columns = of_x->strain.size();
    const std::size_t rows = of_y->strain.size();
    const std::size_t size = columns * rows;
    for (std::size_t a = 0; a < 2; ++a) {
        const std::vector<double>& C_x = of_x->dashpots[a == 0 ? 0 : 1];
        const std::vector<double>& C_y = of_y->dashpots[a == 1 ? 0 : 1];
        std::vector<std::ptrdiff_t> offsets;
        std::vector<double> mass;
        std::vector<double> all_x(size * size);
        std::vector<double> all_y(size * size);
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t column = i % columns;
            const std::size_t row = i / columns;
            const std::ptrdiff_t x = node_of_layer(across_x, static_cast<std::ptrdiff_t>(column));
            const std::ptrdiff_t y = node_of_layer(across_y, static_cast<std::ptrdiff_t>(row));
            offsets.push_back(y * static_cast<std::ptrdiff_t>(grid().nx) + x);
            mass.push_back(axis_of(0).mass(a, x) * axis_of(1).mass(a, y));
            for (std::size_t other = 0; other < columns; ++other) {
                all_x[i * size + row * columns + other] =
                    of_y->strain[row] * C_x[column * columns + other];
            }
            for (std::size_t other = 0; other < rows; ++other) {
                all_y[i * size + other * columns + column] =
                    of_x->strain[column] * C_y[row * rows + other];
            }
        }
        dashpots_.emplace_back(a, std::move(offsets), std::vector<std::ptrdiff_t>{0}, mass,
                               std::vector<typename detail::DashpotGroups<Real>::OfSide>{
                                   {across_x, std::move(all_x)}, {across_y, std::move(all_y)}},
                               parameters_.time_step * parameters_.rate());
    }
}

}  // namespace nmbc
