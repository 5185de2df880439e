// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/crack_front.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace nmbcrun {
namespace {

constexpr double is_cracked = 0.35;

double distance(const std::array<double, 2>& one, const std::array<double, 2>& other) {
    return std::hypot(one[0] - other[0], one[1] - other[1]);
}

/// Whether the point is beside the line, between its ends and within `near` of it.
bool is_beside(const std::array<double, 4>& line, const std::array<double, 2>& X, double near) {
    const double dx = line[2] - line[0];
    const double dy = line[3] - line[1];
    const double length = std::hypot(dx, dy);
    const double along = ((X[0] - line[0]) * dx + (X[1] - line[1]) * dy) / length;
    const double across = ((X[0] - line[0]) * dy - (X[1] - line[1]) * dx) / length;
    return along >= 0 && along <= length && std::abs(across) <= near;
}

}  // namespace

CrackFront::CrackFront(const PlaneScene& scene)
    : nodes_(scene.nodes),
      spacing_(scene.spacing),
      horizon_(scene.spacing * std::sqrt(double(scene.radius_squared))),
      lines_(scene.fracture->cracks) {
    for (const auto& line : lines_) {
        for (const std::array<double, 2>& end :
             {std::array{line[0], line[1]}, std::array{line[2], line[3]}}) {
            const auto is_inside = [&](std::size_t axis) {
                return end[axis] > spacing_ && end[axis] < double(nodes_[axis]) * spacing_;
            };
            if (is_inside(0) && is_inside(1)) {
                ends_.push_back(end);
            }
        }
    }
}

std::vector<CrackGrowth> CrackFront::look(
    const std::function<double(std::size_t, std::size_t)>& damage) const {
    std::vector<std::vector<CrackedNode>> cracked(ends_.size());
    for (std::size_t y = 0; y < nodes_[1] && !ends_.empty(); ++y) {
        for (std::size_t x = 0; x < nodes_[0]; ++x) {
            if (damage(x, y) <= is_cracked) {
                continue;
            }
            const std::array<double, 2> X{double(x + 1) * spacing_, double(y + 1) * spacing_};
            if (std::ranges::any_of(
                    lines_, [&](const auto& line) { return is_beside(line, X, horizon_); })) {
                continue;
            }
            const auto nearest = std::ranges::min_element(
                ends_, {}, [&](const auto& end) { return distance(end, X); });
            cracked[std::size_t(nearest - ends_.begin())].push_back(
                {{x, y}, X, distance(*nearest, X)});
        }
    }
    std::vector<CrackGrowth> growth;
    for (std::size_t end = 0; end < ends_.size(); ++end) {
        growth.push_back(growth_of(cracked[end], end));
    }
    return growth;
}

CrackGrowth CrackFront::growth_of(const std::vector<CrackedNode>& nodes, std::size_t end) const {
    CrackGrowth growth{.tip = ends_[end]};
    for (const CrackedNode& node : nodes) {
        if (node.distance > growth.reach) {
            growth.reach = node.distance;
            growth.tip = node.X;
        }
    }
    growth.branches = CrackPieces(nodes, horizon_).branches();
    return growth;
}

/// (2 - c^2/c_S^2)^2 = 4 sqrt(1 - c^2/c_P^2) sqrt(1 - c^2/c_S^2), between 0.6 and 1 of c_S.
double rayleigh_speed(double speed_P, double speed_S) {
    const double ratio = speed_S / speed_P;
    const auto equation = [&](double x) {
        return std::pow(2 - x * x, 2) -
               4 * std::sqrt(1 - ratio * ratio * x * x) * std::sqrt(1 - x * x);
    };
    std::uintmax_t iterations = 100;
    const auto [low, high] = boost::math::tools::toms748_solve(
        equation, 0.6, 1.0, boost::math::tools::eps_tolerance<double>(40), iterations);
    return (low + high) / 2 * speed_S;
}

}  // namespace nmbcrun
