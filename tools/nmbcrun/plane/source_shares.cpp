// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/source_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace nmbcrun {
namespace {

struct Neighbour {
    std::size_t node = 0;  ///< of the original
    double weight = 0;
    bool is_beyond = false;  ///< its sides, and stood for by another one
};

/// The node of the original that stands for such a one, which may be beyond its sides.
std::optional<Neighbour> neighbour(const PlaneScene& original, std::size_t axis,
                                   std::ptrdiff_t node, double weight) {
    const auto nodes = std::ptrdiff_t(original.nodes[axis]);
    if (node >= 0 && node < nodes) {
        return Neighbour{std::size_t(node), weight};
    }
    switch (original.sides[2 * axis + (node < 0 ? 0 : 1)].kind) {
        case SideKind::periodic:
            return Neighbour{std::size_t((node + nodes) % nodes), weight};
        case SideKind::free:  // half a cell more belongs to the outermost node
        case SideKind::mirror:
            return Neighbour{std::size_t(std::clamp<std::ptrdiff_t>(node, 0, nodes - 1)), weight,
                             true};
        default:
            return std::nullopt;
    }
}

std::vector<Neighbour> neighbours_of(const PlaneScene& scene, std::size_t axis,
                                     std::ptrdiff_t node) {
    const PlaneOriginal& from = *scene.original;
    const double place = from.first[axis] + double(node) / double(from.ratio);
    constexpr double roundings = 1e-9;
    const double low = std::floor(place + roundings);
    const double above = place - low > roundings ? place - low : 0;
    std::vector<Neighbour> neighbours;
    for (const auto& [at, weight] : {std::pair(low, 1 - above), std::pair(low + 1, above)}) {
        const auto found = neighbour(*from.scene, axis, std::ptrdiff_t(at), weight);
        if (found && weight > 0) {
            neighbours.push_back(*found);
        }
    }
    return neighbours;
}

}  // namespace

std::vector<NodeShare> shares_of(const PlaneScene& scene, const PlaneBody& body,
                                 const std::vector<bool>& chosen) {
    const auto place = [&](std::size_t axis, std::size_t node) {
        return std::ptrdiff_t(node) - std::ptrdiff_t(body.before[axis]);
    };
    std::array<std::vector<std::vector<Neighbour>>, 2> neighbours;
    for (const std::size_t axis : {0U, 1U}) {
        for (std::size_t node = 0; node < body.nodes[axis]; ++node) {
            neighbours[axis].push_back(neighbours_of(scene, axis, place(axis, node)));
        }
    }
    const std::size_t row = scene.original->scene->nodes[0];
    std::vector<NodeShare> shares;
    for (std::size_t y = 0; y < body.nodes[1]; ++y) {
        for (std::size_t x = 0; x < body.nodes[0]; ++x) {
            double share = 0;
            bool is_between = true;
            for (const Neighbour& above : neighbours[1][y]) {
                for (const Neighbour& beside : neighbours[0][x]) {
                    share +=
                        chosen[above.node * row + beside.node] ? above.weight * beside.weight : 0;
                    is_between = is_between && !above.is_beyond && !beside.is_beyond;
                }
            }
            if (share > 0) {
                shares.push_back({place(0, x), place(1, y), share, is_between});
            }
        }
    }
    return shares;
}

}  // namespace nmbcrun
