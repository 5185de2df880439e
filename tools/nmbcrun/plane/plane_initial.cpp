// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_initial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "tools/nmbcrun/plane/plane_initial_file.hpp"
#include "tools/nmbcrun/plane/plane_lattice.hpp"

namespace nmbcrun {
namespace {

/// Nodes from first to last - 1.
struct NodeRange {
    std::size_t first = 0;
    std::size_t last = 0;
};

}  // namespace

InitialShape::InitialShape(const PlaneScene& scene)
    : initial_(*scene.initial), spacing_(scene.spacing) {
    if (initial_.shape != PlaneShape::packet) {
        return;
    }
    const double radians = initial_.angle * std::numbers::pi / 180;
    xi_ = {initial_.wave_number * std::cos(radians), initial_.wave_number * std::sin(radians)};
    const nmbc::PlaneModel model = model_of(scene);
    const double rate = rate_of(scene);
    const auto omega_at = [&](double x, double y) {
        return rate * std::sqrt(nmbc::plane_wave(model, {x, y}, initial_.is_P).omega_squared);
    };
    omega_ = omega_at(xi_[0], xi_[1]);
    constexpr double aside = 1e-5;  // central differences: 1e-10 of the group velocity
    const double scale = scene.spacing / (2 * aside);
    group_velocity_ = {
        scale * (omega_at(xi_[0] + aside, xi_[1]) - omega_at(xi_[0] - aside, xi_[1])),
        scale * (omega_at(xi_[0], xi_[1] + aside) - omega_at(xi_[0], xi_[1] - aside))};
    direction_ = nmbc::plane_wave(model, xi_, initial_.is_P).direction;
}

StartOfNode InitialShape::at(const std::array<double, 2>& point) const {
    const double x = point[0] - initial_.centre[0];
    const double y = point[1] - initial_.centre[1];
    const double r = std::hypot(x, y) / initial_.width;
    StartOfNode start;
    if (initial_.shape == PlaneShape::packet) {
        const double phase = (xi_[0] * x + xi_[1] * y) / spacing_;
        const double height = initial_.amplitude * std::exp(-r * r);
        // The envelope moves with the group velocity: -c_g . grad of it is its rate of change.
        const double envelope = 2 * (x * group_velocity_[0] + y * group_velocity_[1]) /
                                (initial_.width * initial_.width);
        for (const std::size_t a : {0U, 1U}) {
            start.u[a] = height * direction_[a] * std::cos(phase);
            start.v[a] =
                height * direction_[a] * (omega_ * std::sin(phase) + envelope * std::cos(phase));
        }
        return start;
    }
    const double shape = initial_.shape == PlaneShape::gaussian ? std::exp(-r * r)
                         : r <= 1 ? (1 + std::cos(std::numbers::pi * r)) / 2
                                  : 0;
    (initial_.of_velocity ? start.v : start.u)[initial_.component] = initial_.amplitude * shape;
    return start;
}

/// The layers of passive sides begin as the field goes on.
bool set_initial_fields(const PlaneScene& scene, const std::array<std::size_t, 4>& extension,
                        nmbc::Plane& plane) {
    StartOfNodes nodes(scene.nodes, extension, plane);
    if (scene.initial->shape == PlaneShape::file) {
        return read_initial_fields(scene, nodes);
    }
    const InitialShape initial(scene);
    for (std::ptrdiff_t y = nodes.first(1); y < nodes.last(1); ++y) {
        for (std::ptrdiff_t x = nodes.first(0); x < nodes.last(0); ++x) {
            nodes.set(x, y,
                      initial.at({double(x + 1) * scene.spacing, double(y + 1) * scene.spacing}));
        }
    }
    return false;
}

std::array<double, 4> initial_at_sides(const PlaneScene& scene,
                                       const std::array<std::size_t, 4>& extension,
                                       const nmbc::Plane& plane) {
    const auto& [nx, ny] = scene.nodes;
    const auto largest = [&](std::span<const double> field, const NodeRange& x,
                             const NodeRange& y) {
        double most = 0;
        for (std::size_t row = y.first; row < y.last; ++row) {
            for (std::size_t column = x.first; column < x.last; ++column) {
                most = std::max(
                    most, std::abs(field[plane.entry(column + extension[0], row + extension[2])]));
            }
        }
        return most;
    };
    const NodeRange all_x{0, nx};
    const NodeRange all_y{0, ny};
    std::array<double, 4> shares{};
    for (const std::size_t a : {0U, 1U}) {
        for (const auto& field : {plane.displacement(a), plane.velocity(a)}) {
            const double most = largest(field, all_x, all_y);
            const std::array there{
                largest(field, {0, 1}, all_y), largest(field, {nx - 1, nx}, all_y),
                largest(field, all_x, {0, 1}), largest(field, all_x, {ny - 1, ny})};
            for (std::size_t side = 0; side < there.size() && most > 0; ++side) {
                shares[side] = std::max(shares[side], there[side] / most);
            }
        }
    }
    return shares;
}

}  // namespace nmbcrun
