// SPDX-License-Identifier: MIT
/// The forces of nodes near closed sides of a plane, of the displacements around them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <nmbc/plane_nodes.hpp>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// M^-1 times the force on a node, sum of the factors times u_J - u_I.
struct ClosedRow {
    struct Entry {
        std::ptrdiff_t entry = 0;         ///< from the node's entry of a field
        std::array<double, 4> factors{};  ///< xx, xy, yx, yy: the first is the force's
    };
    std::vector<Entry> entries{};
};

/// Where a node is so far from the closed sides that all in whose gradients it is have the
/// lattice's own, its force is the lattice's.
class ClosedRows {
  public:
    ClosedRows() = default;
    explicit ClosedRows(const PlaneNodes& nodes)
        : reached_(std::max(nodes.x().cut_layers(), nodes.y().cut_layers()) + nodes.horizon()) {
        rows_.resize(places() * places());
        const auto xs = nodes.x().nodes_of_places(reached_);
        const std::ptrdiff_t far = nodes.closed_layers() + nodes.horizon();
        for (const auto& [place_y, y] : nodes.y().nodes_of_places(reached_)) {
            for (const auto& [place_x, x] : xs) {
                if (nodes.x().from_closed(x, far).layers < far ||
                    nodes.y().from_closed(y, far).layers < far) {
                    rows_[place_y * places() + place_x] = row_of(nodes, x, y);
                }
            }
        }
    }

    bool empty() const { return rows_.empty(); }
    /// nullptr: the force is the lattice's.
    const ClosedRow* at(const PlaneNodes& nodes, std::ptrdiff_t x, std::ptrdiff_t y) const {
        const ClosedRow& row =
            rows_[nodes.y().place(y, reached_) * places() + nodes.x().place(x, reached_)];
        return row.entries.empty() ? nullptr : &row;
    }

  private:
    std::size_t places() const { return static_cast<std::size_t>(2 * reached_ + 1); }

    using Offset = std::array<int, 2>;
    using Gradient = std::map<Offset, std::array<double, 2>>;
    using Blocks = std::map<Offset, std::array<double, 4>>;

    /// Of a node, by the offsets from it, itself and all its bonds included.
    static Gradient gradient_of(const PlaneNodes& nodes, std::ptrdiff_t x, std::ptrdiff_t y) {
        Gradient gradient{{Offset{}, {0, 0}}};
        const ClosedNode* const own = nodes.closed(x, y);
        const PlaneNeighbours& near = nodes.neighbours(x, y);
        const auto& [xx, xy, yy] = near.inverse_shape;
        for (const PlaneNeighbours::Bond& bond : near.bonds) {
            gradient[{bond.x, bond.y}] =
                own != nullptr ? std::array{0.0, 0.0}
                               : std::array{bond.influence * (xx * bond.x + xy * bond.y),
                                            bond.influence * (xy * bond.x + yy * bond.y)};
        }
        if (own == nullptr) {
            gradient[{0, 0}] = {-xx * near.sum_x - xy * near.sum_y,
                                -xy * near.sum_x - yy * near.sum_y};
            return gradient;
        }
        for (const ClosedNode::Entry& entry : own->gradient) {
            gradient[{entry.x, entry.y}] = entry.along;
            gradient[{0, 0}][0] -= entry.along[0];
            gradient[{0, 0}][1] -= entry.along[1];
        }
        return gradient;
    }

    /// Adds what the energy of one node, at the offset `owner` from the node in question, has to do
    /// with its force: the stiffness by offset from the node in question.
    static void add_energy(const PlaneNodes& nodes, const std::array<std::ptrdiff_t, 2>& at,
                           const Offset& owner, Blocks& stiffness) {
        const std::ptrdiff_t x = at[0] + owner[0];
        const std::ptrdiff_t y = at[1] + owner[1];
        const Gradient gradient = gradient_of(nodes, x, y);
        const PlaneWeights own = nodes.weights(x, y);
        const Offset node{-owner[0], -owner[1]};  // in question, from the owner
        const std::array<double, 2> G = gradient.at(node);
        const double k = own.strain * nodes.model().bulk;
        const double mu = own.strain * nodes.model().shear;
        const auto block_of = [&](const Offset& other) -> std::array<double, 4>& {
            return stiffness[{owner[0] + other[0], owner[1] + other[1]}];
        };
        for (const auto& [other, H] : gradient) {
            std::array<double, 4>& block = block_of(other);
            block[0] += (k + mu) * G[0] * H[0] + mu * G[1] * H[1];
            block[1] += (k - mu) * G[0] * H[1] + mu * G[1] * H[0];
            block[2] += (k - mu) * G[1] * H[0] + mu * G[0] * H[1];
            block[3] += (k + mu) * G[1] * H[1] + mu * G[0] * H[0];
        }
        const double w = own.stabilisation * nodes.model().stabilisation;
        if (w == 0) {
            return;
        }
        // z = u_J - u_I - g R of each bond, in which the node in question has the factor f / w: the
        // sums over the bonds come first, as every node of the gradient is in every z.
        const auto add = [&](const Offset& other, double factor) {
            block_of(other)[0] += factor;
            block_of(other)[3] += factor;
        };
        double sum = 0;                  // of f
        std::array<double, 2> moment{};  // of f R
        for (const PlaneNeighbours::Bond& bond : nodes.neighbours(x, y).bonds) {
            const Offset neighbour{bond.x, bond.y};
            const double f = w * bond.influence *
                             ((node == neighbour ? 1 : 0) - (node == Offset{} ? 1 : 0) -
                              G[0] * bond.x - G[1] * bond.y);
            add(neighbour, f);
            sum += f;
            moment[0] += f * bond.x;
            moment[1] += f * bond.y;
        }
        add({}, -sum);
        for (const auto& [other, H] : gradient) {
            add(other, -H[0] * moment[0] - H[1] * moment[1]);
        }
    }

    static ClosedRow row_of(const PlaneNodes& nodes, std::ptrdiff_t x, std::ptrdiff_t y) {
        Blocks stiffness;
        const PlaneNeighbours& near = nodes.neighbours(x, y);
        add_energy(nodes, {x, y}, {0, 0}, stiffness);
        for (const PlaneNeighbours::Bond& bond : near.bonds) {
            add_energy(nodes, {x, y}, {bond.x, bond.y}, stiffness);
        }
        ClosedRow row;
        const std::array<double, 2> mass = nodes.weights(x, y).mass;
        for (const auto& [offset, block] : stiffness) {
            if (offset != Offset{}) {
                row.entries.push_back({offset[1] * nodes.pitch() + offset[0],
                                       {-block[0] / mass[0], -block[1] / mass[0],
                                        -block[2] / mass[1], -block[3] / mass[1]}});
            }
        }
        return row;
    }

    std::ptrdiff_t reached_ = 0;
    std::vector<ClosedRow> rows_{};  // by the axes' place()
};

}  // namespace nmbc::detail
