// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/mirrors.hpp"

namespace nmbcrun {
namespace {

/// Of the numbers of a node and its image.
std::ptrdiff_t sum_with_image(bool at_left, BoundaryKind kind, std::ptrdiff_t nodes) {
    // Midway between the outermost node and the ghost beyond; fixed on this, or the other one.
    const bool on_node = is_surface(kind) && nmbc::ends_on_node(closure_of(kind));
    const std::ptrdiff_t outwards = kind == BoundaryKind::fixed ? 1 : on_node ? -1 : 0;
    return at_left ? -1 - outwards : 2 * nodes - 1 + outwards;
}

}  // namespace

std::vector<double> Mirrors::folded(std::span<const double> field) const {
    std::vector<double> interior(field.begin(), field.begin() + std::ptrdiff_t(nodes_));
    if (count() == 0) {
        return interior;
    }
    const auto nodes = std::ptrdiff_t(nodes_);
    const auto period = std::ptrdiff_t(field.size());
    const std::ptrdiff_t beyond = (period - nodes) / 2;
    for (std::ptrdiff_t entry = nodes; entry < period; ++entry) {
        std::ptrdiff_t node = entry < nodes + beyond ? entry : entry - period;
        double value = node < 0 ? -field[std::size_t(entry)] : field[std::size_t(entry)];
        // A fixed end's own node is its own image, so that nothing of it is left.
        while ((node < 0 && at_left()) || (node >= nodes && at_right())) {
            const Boundary& end = node < 0 ? left_ : right_;
            const bool fixed = end.kind == BoundaryKind::fixed;
            const std::ptrdiff_t sum = sum_with_image(node < 0, end.kind, nodes);
            if (2 * node == sum) {
                value = 0;
                break;
            }
            const bool held = is_surface(end.kind) && end.given == nmbc::OnSurface::displacement;
            value = fixed || held ? -value : value;
            node = sum - node;
        }
        if (node >= 0 && node < nodes) {
            interior[std::size_t(node)] += value;
        }
    }
    return interior;
}

}  // namespace nmbcrun
