// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/held_bonds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/nmbcrun/plane/plane_lattice.hpp"

namespace nmbcrun {

HeldBonds::HeldBonds(const PlaneScene& scene, const nmbc::Plane& plane)
    : plane_(&plane),
      groups_(nmbc::detail::bond_groups(bonds_of(scene))),
      count_{plane.grid().nx - 2 * plane.ghosts(), plane.grid().ny - 2 * plane.ghosts()},
      is_periodic_{scene.sides[0].kind == SideKind::periodic,
                   scene.sides[2].kind == SideKind::periodic},
      held_(plane.state().bonds) {}

template <class Work>
void HeldBonds::for_each_bond(const Node& node, const Work& work) const {
    for (const nmbc::detail::BondGroup& group : groups_) {
        const std::uint32_t bits = held_[group.word * nodes() + index(node)];
        for (unsigned m = 0; m < group.size; ++m) {
            if ((bits >> (group.first_bit + m) & 1U) == 0) {
                continue;
            }
            const nmbc::PlaneOffset& bond = group.members[m];
            Node other{node[0] + bond.x, node[1] + bond.y};
            bool is_node = true;
            for (const std::size_t axis : {0U, 1U}) {
                const auto count = std::ptrdiff_t(count_[axis]);
                if (is_periodic_[axis]) {
                    other[axis] = (other[axis] + count) % count;
                }
                is_node = is_node && other[axis] >= 0 && other[axis] < count;
            }
            if (is_node) {
                work(other, bond);
            }
        }
    }
}

double HeldBonds::largest_strain() const {
    double largest = 0;
    const auto& layers = plane_->layers();
    const auto is_interior = [&](const Node& node) {
        return node[0] >= std::ptrdiff_t(layers[0]) &&
               node[0] < std::ptrdiff_t(count_[0] - layers[1]) &&
               node[1] >= std::ptrdiff_t(layers[2]) &&
               node[1] < std::ptrdiff_t(count_[1] - layers[3]);
    };
    const auto entry = [&](const Node& node) {
        return plane_->entry(std::size_t(node[0]) - layers[0], std::size_t(node[1]) - layers[2]);
    };
    for (auto y = std::ptrdiff_t(layers[2]); y < std::ptrdiff_t(count_[1] - layers[3]); ++y) {
        for (auto x = std::ptrdiff_t(layers[0]); x < std::ptrdiff_t(count_[0] - layers[1]); ++x) {
            for_each_bond({x, y}, [&](const Node& other, const nmbc::PlaneOffset& bond) {
                if (!is_interior(other)) {
                    return;
                }
                for (const std::size_t a : {0U, 1U}) {
                    const auto u = plane_->displacement(a);
                    largest = std::max(largest, std::abs(u[entry(other)] - u[entry({x, y})]) /
                                                    std::hypot(bond.x, bond.y));
                }
            });
        }
    }
    return largest / plane_->parameters().spacing;
}

std::size_t HeldBonds::joined_to(const std::vector<std::size_t>& entries) const {
    std::vector<bool> is_joined(nodes());
    std::vector<Node> next;
    std::size_t joined = 0;
    const auto join = [&](const Node& node) {
        if (!is_joined[index(node)]) {
            is_joined[index(node)] = true;
            ++joined;
            next.push_back(node);
        }
    };
    const std::size_t row = plane_->grid().nx;
    const auto ghosts = std::ptrdiff_t(plane_->ghosts());
    for (const std::size_t entry : entries) {
        join({std::ptrdiff_t(entry % row) - ghosts, std::ptrdiff_t(entry / row) - ghosts});
    }
    while (!next.empty()) {
        const Node node = next.back();
        next.pop_back();
        for_each_bond(node,
                      [&](const Node& other, const nmbc::PlaneOffset& /*bond*/) { join(other); });
    }
    return joined;
}

std::vector<std::string> warnings_of_torn_loads(const PlaneScene& scene, const nmbc::Plane& plane,
                                                const PlaneSources& sources) {
    std::vector<std::string> warnings;
    if (!scene.fracture || plane.broken() == 0) {
        return warnings;
    }
    const HeldBonds bonds(scene, plane);
    for (const auto& [table, entries] : sources.loaded()) {
        const auto others = double(bonds.nodes() - entries.size());
        const auto joined = double(bonds.joined_to(entries) - entries.size());
        constexpr double little = 0.1;
        if (joined < little * others) {
            constexpr double percent = 100;
            warnings.push_back(
                fmt::format("at the end bonds that hold join the nodes of {} to {:.2g} % of the "
                            "others: torn or cut off, they no longer load the body",
                            table, percent * joined / others));
        }
    }
    return warnings;
}

}  // namespace nmbcrun
