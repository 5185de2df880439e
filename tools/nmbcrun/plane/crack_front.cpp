// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/crack_front.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <nmbc/plane_family.hpp>

namespace nmbcrun {
namespace {

double distance(const std::array<double, 2>& one, const std::array<double, 2>& other) {
    return std::hypot(one[0] - other[0], one[1] - other[1]);
}

using Line = std::array<double, 4>;
using PlanePoint = std::array<double, 2>;

std::array<PlanePoint, 2> ends_of(const Line& line) {
    return {PlanePoint{line[0], line[1]}, PlanePoint{line[2], line[3]}};
}

/// Along the line from its first point and across it [length].
PlanePoint in_frame_of(const Line& line, const PlanePoint& X) {
    const double dx = line[2] - line[0];
    const double dy = line[3] - line[1];
    const double length = std::hypot(dx, dy);
    return {((X[0] - line[0]) * dx + (X[1] - line[1]) * dy) / length,
            ((X[0] - line[0]) * dy - (X[1] - line[1]) * dx) / length};
}

/// Whether the point is beside the line, not beyond its ends by more than `beyond`, and within
/// `near` of it.
bool is_beside(const Line& line, const PlanePoint& X, double near, double beyond = 0) {
    const auto [along, across] = in_frame_of(line, X);
    return along >= -beyond && along <= distance(ends_of(line)[0], ends_of(line)[1]) + beyond &&
           std::abs(across) <= near;
}

bool do_cross(const Line& one, const Line& other) {
    const auto parts = [](const Line& line, const Line& points) {
        const auto [first, last] = ends_of(points);
        return in_frame_of(line, first)[1] * in_frame_of(line, last)[1] < 0;
    };
    return parts(one, other) && parts(other, one);
}

bool do_touch(const Line& one, const Line& other, double near) {
    const auto has_end_beside = [near](const Line& line, const Line& beside) {
        return std::ranges::any_of(ends_of(line), [&](const PlanePoint& end) {
            return is_beside(beside, end, near, near);
        });
    };
    return do_cross(one, other) || has_end_beside(one, other) || has_end_beside(other, one);
}

/// Each line once.
std::vector<Line> without_repeats(const std::vector<Line>& lines) {
    std::vector<Line> all;
    for (const Line& line : lines) {
        const Line turned{line[2], line[3], line[0], line[1]};
        if (std::ranges::count(all, line) + std::ranges::count(all, turned) == 0) {
            all.push_back(line);
        }
    }
    return all;
}

}  // namespace

CrackFront::CrackFront(const PlaneScene& scene)
    : nodes_(scene.nodes),
      spacing_(scene.spacing),
      horizon_(scene.spacing * std::sqrt(double(scene.radius_squared))),
      is_periodic_{scene.sides[0].kind == SideKind::periodic,
                   scene.sides[2].kind == SideKind::periodic},
      lines_(without_repeats(scene.fracture->cracks)) {
    const std::vector<nmbc::PlaneOffset> family = nmbc::plane_family(scene.radius_squared);
    const auto across =
        std::ranges::count_if(family, [](const nmbc::PlaneOffset& bond) { return bond.y > 0; });
    constexpr double nearly = 0.9;  // a crack may leave a bond or two
    cracked_above_ = nearly * double(across) / double(family.size());
    join_lines();
    find_ends();
}

/// Numbers the lines: those that touch, one by one, have one number.
void CrackFront::join_lines() {
    group_.resize(lines_.size());
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        group_[i] = i;
        for (std::size_t j = 0; j < i; ++j) {
            if (group_[j] != i && do_touch(lines_[i], lines_[j], horizon_)) {
                std::ranges::replace(group_, std::size_t(group_[j]), i);
            }
        }
    }
}

void CrackFront::find_ends() {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        for (const PlanePoint& end : ends_of(lines_[i])) {
            const auto is_inside = [&](std::size_t axis) {
                return end[axis] > spacing_ / 2 &&
                       end[axis] < (double(nodes_[axis]) + 0.5) * spacing_;
            };
            bool goes_on = false;  // as another line
            for (std::size_t j = 0; j < lines_.size(); ++j) {
                goes_on =
                    goes_on || (j != i && is_beside(lines_[j], end, spacing_ / 2, spacing_ / 2));
            }
            if (is_inside(0) && is_inside(1) && !goes_on) {
                ends_.push_back(end);
                line_of_end_.push_back(i);
            }
        }
    }
}

std::vector<CrackGrowth> CrackFront::look(
    const std::function<double(std::size_t, std::size_t)>& damage) const {
    std::vector<bool> cracked(nodes_[0] * nodes_[1], false);
    for (std::size_t y = 0; y < nodes_[1] && !ends_.empty(); ++y) {
        for (std::size_t x = 0; x < nodes_[0]; ++x) {
            cracked[y * nodes_[0] + x] = damage(x, y) > cracked_above_;
        }
    }
    std::vector<CrackGrowth> growth;
    for (std::size_t end = 0; end < ends_.size(); ++end) {
        growth.push_back(growth_of(connected_to(end, cracked), end));
    }
    return growth;
}

/// Whether the point is beside a line of this group.
bool CrackFront::is_beside_group(std::size_t group, const std::array<double, 2>& X) const {
    const auto turns = [this](std::size_t axis) { return is_periodic_[axis] ? 1 : 0; };
    for (int j = -turns(1); j <= turns(1); ++j) {
        for (int i = -turns(0); i <= turns(0); ++i) {
            const std::array<double, 2> image{X[0] + i * double(nodes_[0]) * spacing_,
                                              X[1] + j * double(nodes_[1]) * spacing_};
            for (std::size_t line = 0; line < lines_.size(); ++line) {
                if (group_[line] == group && is_beside(lines_[line], image, horizon_)) {
                    return true;
                }
            }
        }
    }
    return false;
}

/// From the nodes within two horizons of the end on, from node to node. Places go on beyond a
/// periodic side.
std::vector<CrackedNode> CrackFront::connected_to(std::size_t number,
                                                  const std::vector<bool>& cracked) const {
    const PlanePoint& end = ends_[number];
    const std::size_t own_group = group_[line_of_end_[number]];
    using Place = std::array<long, 2>;
    std::vector<bool> is_known(cracked.size(), false);
    std::vector<CrackedNode> nodes;
    const auto visit = [&](const Place& place) {
        std::array<std::size_t, 2> node{};
        for (const std::size_t axis : {0U, 1U}) {
            const auto count = long(nodes_[axis]);
            const long inside =
                is_periodic_[axis] ? (place[axis] % count + count) % count : place[axis];
            if (inside < 0 || inside >= count) {
                return;
            }
            node[axis] = std::size_t(inside);
        }
        const std::size_t index = node[1] * nodes_[0] + node[0];
        const PlanePoint X{double(place[0] + 1) * spacing_, double(place[1] + 1) * spacing_};
        if (cracked[index] && !is_known[index] && !is_beside_group(own_group, X)) {
            is_known[index] = true;
            nodes.push_back({place, X, distance(end, X)});
        }
    };
    const auto visit_around = [&](const Place& middle, long reach) {
        for (long dy = -reach; dy <= reach; ++dy) {
            for (long dx = -reach; dx <= reach; ++dx) {
                visit({middle[0] + dx, middle[1] + dy});
            }
        }
    };
    const auto near = std::lround(2 * horizon_ / spacing_);
    visit_around({std::lround(end[0] / spacing_) - 1, std::lround(end[1] / spacing_) - 1}, near);
    std::size_t next = 0;
    while (next < nodes.size()) {
        const Place place = nodes[next++].place;  // a copy: more nodes come
        visit_around(place, CrackPieces::gap);
    }
    return nodes;
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

/// With x = c^2/c_S^2 and r = c_S^2/c_P^2: x^3 - 8 x^2 + (24 - 16 r) x = 16 (1 - r), which has one
/// root between 0 and 1.
std::optional<double> rayleigh_speed(double speed_P, double speed_S) {
    const double ratio = speed_S * speed_S / (speed_P * speed_P);
    if (!(ratio > 0 && ratio < 1)) {
        return std::nullopt;
    }
    const auto equation = [ratio](double x) {
        return ((x - 8) * x + 24 - 16 * ratio) * x - 16 * (1 - ratio);
    };
    std::uintmax_t iterations = 100;
    const auto [low, high] = boost::math::tools::toms748_solve(
        equation, 0.0, 1.0, boost::math::tools::eps_tolerance<double>(40), iterations);
    return std::sqrt((low + high) / 2) * speed_S;
}

}  // namespace nmbcrun
