// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/crack_front.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>

namespace nmbcrun {
namespace {

constexpr double is_cracked = 0.35;
constexpr double shortest_branch = 5;  // horizons

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

/// Cracked nodes of one band of distances that hang together.
struct Piece {
    std::array<double, 2> nearest{};     ///< its first node
    double from = HUGE_VAL;              ///< distance of that
    double deepest = 0;                  ///< distance to which it goes on
    std::vector<std::size_t> further{};  ///< pieces of the next band beside it
};

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
    std::vector<std::vector<Node>> cracked(ends_.size());
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

CrackGrowth CrackFront::growth_of(std::vector<Node> nodes, std::size_t end) const {
    CrackGrowth growth{.tip = ends_[end]};
    for (const Node& node : nodes) {
        if (node.distance > growth.reach) {
            growth.reach = node.distance;
            growth.tip = node.X;
        }
    }
    growth.branches = branches_of(nodes);
    return growth;
}

/// Bands of distance, a horizon wide each, whose cracked nodes fall into pieces: a piece that goes
/// on in several of the next band is where the crack branches, if these go on far enough.
std::vector<std::array<double, 2>> CrackFront::branches_of(const std::vector<Node>& nodes) const {
    const auto band_of = [&](const Node& node) { return std::size_t(node.distance / horizon_); };
    std::map<std::array<std::size_t, 2>, std::size_t> number;  // of a node
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        number[nodes[i].place] = i;
    }
    constexpr long gap = 2;  // nodes: cracks are two nodes wide, and ragged
    const auto visit_near = [&](std::size_t i, const auto& visit) {
        for (long dy = -gap; dy <= gap; ++dy) {
            for (long dx = -gap; dx <= gap; ++dx) {
                const auto found = number.find(
                    {nodes[i].place[0] + std::size_t(dx), nodes[i].place[1] + std::size_t(dy)});
                if (found != number.end()) {
                    visit(found->second);
                }
            }
        }
    };
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> piece_of(nodes.size(), none);
    std::vector<std::vector<std::size_t>> members;
    for (std::size_t start = 0; start < nodes.size(); ++start) {
        if (piece_of[start] != none) {
            continue;
        }
        std::vector<std::size_t> piece{start};
        piece_of[start] = members.size();
        for (std::size_t next = 0; next < piece.size(); ++next) {
            visit_near(piece[next], [&](std::size_t other) {
                if (piece_of[other] == none && band_of(nodes[other]) == band_of(nodes[start])) {
                    piece_of[other] = members.size();
                    piece.push_back(other);
                }
            });
        }
        members.push_back(piece);
    }
    std::vector<Piece> pieces(members.size());
    std::vector<std::size_t> outwards(members.size());
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        outwards[p] = p;
        for (const std::size_t i : members[p]) {
            if (nodes[i].distance < pieces[p].from) {
                pieces[p].from = nodes[i].distance;
                pieces[p].nearest = nodes[i].X;
            }
            pieces[p].deepest = std::max(pieces[p].deepest, nodes[i].distance);
            visit_near(i, [&](std::size_t other) {
                auto& further = pieces[p].further;
                if (band_of(nodes[other]) == band_of(nodes[i]) + 1 &&
                    std::ranges::find(further, piece_of[other]) == further.end()) {
                    further.push_back(piece_of[other]);
                }
            });
        }
    }
    const auto band = [&](std::size_t p) { return band_of(nodes[members[p][0]]); };
    std::ranges::sort(outwards, {}, band);
    for (auto p = outwards.rbegin(); p != outwards.rend(); ++p) {
        for (const std::size_t q : pieces[*p].further) {
            pieces[*p].deepest = std::max(pieces[*p].deepest, pieces[q].deepest);
        }
    }
    std::vector<std::array<double, 2>> branches;
    for (const std::size_t p : outwards) {
        std::array<double, 2> sum{};
        double ways = 0;
        for (const std::size_t q : pieces[p].further) {
            if (pieces[q].deepest - pieces[q].from >= shortest_branch * horizon_) {
                ways += 1;
                sum[0] += pieces[q].nearest[0];
                sum[1] += pieces[q].nearest[1];
            }
        }
        if (ways > 1) {
            branches.push_back({sum[0] / ways, sum[1] / ways});
        }
    }
    return branches;
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
