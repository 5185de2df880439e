// SPDX-License-Identifier: MIT
/// The convex kernel approximation at the sides of a plane (Wu 2015), corners included.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/convex_kernel.hpp>
#include <nmbc/correspondence_model.hpp>
#include <nmbc/plane_closure.hpp>
#include <nmbc/plane_family.hpp>
#include <nmbc/plane_nodes.hpp>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace nmbc {

namespace detail {

/// Psi_J(X_I) of the nodes J, I of a quarter of the plane, whose sides are at x = 0 and y = 0; dX =
/// 1. Psi_J = phi_J G_J/sum, phi_J the cubic spline of |X - X_J|/a_J, a_J = n + 1, but 3/2 of nodes
/// on a side, and G_J = 1 + (2/pi) atan(lambda . (X - X_J)), lambda(X) from sum_J Psi_J (X_J - X) =
/// 0. On a side they are their limit, that of the side's own nodes, and in the corner 1 and 0.
class PlaneConvexKernels {
  public:
    explicit PlaneConvexKernels(unsigned radius_squared)
        : radius_(static_cast<double>(horizon_of(radius_squared) + 1)),
          family_(plane_family(radius_squared)) {
        family_.push_back({0, 0});
    }

    struct Entry {
        PlaneOffset owner{};
        double value = 0;
    };
    /// Of the J whose Psi_J is not 0 at X_I.
    std::vector<Entry> at(const PlaneOffset& node) const {
        std::vector<Entry> kernels;
        for (const PlaneOffset& offset : family_) {
            const PlaneOffset owner{node.x + offset.x, node.y + offset.y};
            const bool is_there =
                node.x == 0 ? owner.x == 0 : owner.x >= 0;  // on a side its own nodes only
            const bool is_there_too = node.y == 0 ? owner.y == 0 : owner.y >= 0;
            const double window = is_there && is_there_too ? window_of(owner, node) : 0;
            if (window > 0) {
                kernels.push_back({owner, window});
            }
        }
        const std::array<double, 2> lambda =
            is_on_side(node) ? std::array{0.0, 0.0} : lambda_of(kernels, node);
        double sum = 0;
        for (Entry& entry : kernels) {
            const double slope =
                lambda[0] * (node.x - entry.owner.x) + lambda[1] * (node.y - entry.owner.y);
            entry.value *= 1 + 2 / std::numbers::pi * std::atan(slope);
            sum += entry.value;
        }
        for (Entry& entry : kernels) {
            entry.value /= sum;
        }
        return kernels;
    }

  private:
    static bool is_on_side(const PlaneOffset& node) { return node.x == 0 || node.y == 0; }

    /// On a side it reaches the nearest node to the left and that to the right only.
    double window_of(const PlaneOffset& owner, const PlaneOffset& at) const {
        return cubic_spline(std::hypot(owner.x - at.x, owner.y - at.y) /
                            (is_on_side(owner) ? 1.5 : radius_));
    }

    /// Where sum phi (d lambda.d + (2/pi) A(lambda.d)) is least, d = X - X_J and A the integral of
    /// the arc tangent: it is convex in lambda.
    static std::array<double, 2> lambda_of(const std::vector<Entry>& windows,
                                           const PlaneOffset& node) {
        struct Point {
            double value = 0;
            std::array<double, 2> slope{};
            std::array<double, 3> curvature{};  // xx, xy, yy
        };
        const auto look = [&](const std::array<double, 2>& lambda) {
            Point point;
            for (const auto& [owner, window] : windows) {
                const double x = node.x - owner.x;
                const double y = node.y - owner.y;
                const double s = lambda[0] * x + lambda[1] * y;
                const double turn = 2 / std::numbers::pi;
                point.value += window * (s + turn * (s * std::atan(s) - std::log1p(s * s) / 2));
                const double first = window * (1 + turn * std::atan(s));
                const double second = window * turn / (1 + s * s);
                point.slope[0] += first * x;
                point.slope[1] += first * y;
                point.curvature[0] += second * x * x;
                point.curvature[1] += second * x * y;
                point.curvature[2] += second * y * y;
            }
            return point;
        };
        const auto is_better = [](const Point& point, const Point& than) {
            return point.value < than.value || std::hypot(point.slope[0], point.slope[1]) <
                                                   std::hypot(than.slope[0], than.slope[1]);
        };
        std::array<double, 2> lambda{};
        Point here = look(lambda);
        constexpr int most = 200;
        for (int i = 0; i < most; ++i) {
            const auto& [xx, xy, yy] = here.curvature;
            const double determinant = xx * yy - xy * xy;
            std::array<double, 2> step{(xy * here.slope[1] - yy * here.slope[0]) / determinant,
                                       (xy * here.slope[0] - xx * here.slope[1]) / determinant};
            const auto moved = [&] { return std::array{lambda[0] + step[0], lambda[1] + step[1]}; };
            Point there = look(moved());
            while (!is_better(there, here) && moved() != lambda) {
                step = {step[0] / 2, step[1] / 2};
                there = look(moved());
            }
            if (moved() == lambda) {
                break;  // nothing but roundings is left
            }
            lambda = moved();
            here = there;
        }
        return lambda;
    }

    double radius_;
    std::vector<PlaneOffset> family_;  // of a node, itself included
};

}  // namespace detail

/// The influence of a cubic spline of radius (n + 1) dX, by |R|^2, for with_influence(). Throws
/// std::invalid_argument of a family that has not all bonds within that radius.
inline std::vector<double> spline_influence(unsigned radius_squared) {
    detail::require_radius(radius_squared);
    const auto radius = static_cast<unsigned>(horizon_of(radius_squared)) + 1;
    if (plane_family(radius_squared).size() != plane_family(radius * radius - 1).size()) {
        throw std::invalid_argument(
            "the influence of a cubic spline of radius (n + 1) dX is for families of all bonds "
            "within it: of a radius squared of 2, 8, 13, 20, ..");
    }
    std::vector<double> influence;
    for (const unsigned length : squared_lengths(radius_squared)) {
        influence.push_back(detail::cubic_spline(std::sqrt(length) / radius));
    }
    return influence;
}

/// Gradients with the convex kernels in the place of the influence, (31) and (32): the bond from J
/// to I counts Psi_J(X_I), so that nodes on a side are in no families but those of its own nodes.
/// Volumes are 1 throughout, by (25), which gives the nodes of a side the force of an even strain,
/// but for those next to a corner. Nodes further in have not: this is no method that passes the
/// patch test.
/// Throws std::invalid_argument for another influence than that of spline_influence().
inline PlaneClosure convex_kernel_closure(const CorrespondenceModel& model) {
    const CorrespondenceModel of_spline =
        with_influence(model, spline_influence(model.radius_squared));
    constexpr double roundings = 1e-12;
    bool is_spline = model.influence.size() == of_spline.influence.size();
    for (std::size_t i = 0; is_spline && i < model.influence.size(); ++i) {
        is_spline = std::abs(model.influence[i] - of_spline.influence[i]) <= roundings;
    }
    if (!is_spline) {
        throw std::invalid_argument(
            "convex kernels continue the influence of a cubic spline of radius (n + 1) dX "
            "(spline_influence)");
    }
    const auto n = static_cast<int>(model.horizon());
    const int layers = 2 * n + 1;  // families of others are those of the interior
    const int wide = layers + 1;
    PlaneClosure closure{.radius_squared = model.radius_squared,
                         .influence = model.influence,
                         .layers = static_cast<std::size_t>(layers)};
    std::vector<std::vector<detail::WeightedBond>> families(static_cast<std::size_t>(wide * wide));
    const detail::PlaneConvexKernels kernels(model.radius_squared);
    for (int y = 0; y < wide + n; ++y) {
        for (int x = 0; x < wide + n; ++x) {
            for (const auto& [owner, value] : kernels.at({x, y})) {
                const PlaneOffset bond{x - owner.x, y - owner.y};
                if (owner.x < wide && owner.y < wide && bond != PlaneOffset{}) {
                    families[static_cast<std::size_t>(owner.y * wide + owner.x)].push_back(
                        {bond.x, bond.y, value});
                }
            }
        }
    }
    for (const auto& family : families) {
        const auto [xx, xy, yy] = detail::inverse_shape_of(family);
        PlaneClosure::Node& node = closure.nodes.emplace_back();
        for (const auto& [x, y, value] : family) {
            node.gradient.push_back({x, y, value * (xx * x + xy * y), value * (xy * x + yy * y)});
        }
    }
    // In a corner each side has half of a node's length.
    closure.surface.assign(static_cast<std::size_t>(wide), 1);
    closure.surface.front() = 0.5;
    return closure;
}

}  // namespace nmbc
