// SPDX-License-Identifier: MIT
/// The nodes of a rectangle between its sides: their neighbours, weights and gradients.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/correspondence_model.hpp>
#include <nmbc/plane_block.hpp>
#include <nmbc/plane_closure.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// u or v of all nodes and ghosts: component a of node (x, y) is at a[y * pitch + x], and those of
/// (0, 0) are what the pointers point at.
template <class Real>
using PlaneField = std::array<Real*, 2>;

/// What a node has at its place.
struct PlaneWeights {
    double strain = 1;
    double stabilisation = 1;
    std::array<double, 2> mass{1, 1};
};

/// The neighbours that a node has, and what makes the gradient of what they do.
struct PlaneNeighbours {
    struct Bond {
        std::ptrdiff_t entry = 0;  ///< from the node's entry of a field
        int x = 0;
        int y = 0;
    };
    std::vector<Bond> bonds{};
    std::array<double, 3> inverse_shape{};  ///< xx, xy, yy
    double sum_x = 0;                       ///< of the offsets
    double sum_y = 0;
};

/// What a node near a closed side has.
struct ClosedNode {
    struct Entry {
        std::ptrdiff_t entry = 0;  ///< from the node's entry of a field
        int x = 0;
        int y = 0;
        std::array<double, 2> along{};  ///< factors of u there in the gradient
    };
    double volume = 1;
    std::vector<Entry> gradient{};
};

/// The nodes of the plane: what each weighs, which neighbours it has, and the gradient there.
class PlaneNodes {
  public:
    /// pitch: entries of a field from one row to the next. Throws std::invalid_argument where a
    /// node has too few neighbours for a gradient.
    PlaneNodes(const CorrespondenceModel& model, PlaneAxis x, PlaneAxis y, std::ptrdiff_t pitch,
               const PlaneClosure* closure = nullptr)
        : model_(model),
          x_(std::move(x)),
          y_(std::move(y)),
          horizon_(static_cast<std::ptrdiff_t>(model.horizon())),
          pitch_(pitch) {
        find_neighbours();
        if (closure != nullptr) {
            find_closed_nodes(*closure);
        }
    }

    const CorrespondenceModel& model() const { return model_; }
    const PlaneAxis& x() const { return x_; }
    const PlaneAxis& y() const { return y_; }
    std::ptrdiff_t horizon() const { return horizon_; }
    std::ptrdiff_t pitch() const { return pitch_; }

    /// Layers beside a closed side with nodes of their own; 0: no side is closed.
    std::ptrdiff_t closed_layers() const { return closed_layers_; }
    /// nullptr: the node is not near a closed side.
    const ClosedNode* closed(std::ptrdiff_t x, std::ptrdiff_t y) const {
        if (closed_layers_ == 0) {
            return nullptr;
        }
        const std::size_t number =
            x_.place(x, closed_places_) + y_.place(y, closed_places_) * places();
        return closed_[number].gradient.empty() ? nullptr : &closed_[number];
    }

    /// Beside a closed side, those of the other sides times its volume.
    PlaneWeights weights(std::ptrdiff_t x, std::ptrdiff_t y) const {
        const ClosedNode* const own = closed(x, y);
        const double V = own == nullptr ? 1 : own->volume;
        return {V * x_.strain(x) * y_.strain(y),
                V * x_.stabilisation(x) * y_.stabilisation(y),
                {V * x_.mass(0, x) * y_.mass(0, y), V * x_.mass(1, x) * y_.mass(1, y)}};
    }

    const PlaneNeighbours& neighbours(std::ptrdiff_t x, std::ptrdiff_t y) const {
        return neighbours_[kind(x, y)];
    }

    /// xx, xy, yx, yy: the first is the component of u.
    template <class Real>
    static std::array<double, 4> gradient(const ClosedNode& own, std::ptrdiff_t at,
                                          const std::array<Real*, 2>& u) {
        std::array<double, 4> g{};
        for (std::size_t a = 0; a < 2; ++a) {
            for (const ClosedNode::Entry& entry : own.gradient) {
                const double difference =
                    static_cast<double>(u[a][at + entry.entry]) - static_cast<double>(u[a][at]);
                g[2 * a] += entry.along[0] * difference;
                g[2 * a + 1] += entry.along[1] * difference;
            }
        }
        return g;
    }
    template <class Real>
    std::array<double, 4> gradient(const PlaneNeighbours& near, std::ptrdiff_t at,
                                   const std::array<Real*, 2>& u) const {
        std::array<double, 4> g{};
        for (std::size_t a = 0; a < 2; ++a) {
            double by_x = -static_cast<double>(near.sum_x) * static_cast<double>(u[a][at]);
            double by_y = -static_cast<double>(near.sum_y) * static_cast<double>(u[a][at]);
            for (const auto& bond : near.bonds) {
                const auto there = static_cast<double>(u[a][at + bond.entry]);
                by_x += bond.x * there;
                by_y += bond.y * there;
            }
            g[2 * a] = near.inverse_shape[0] * by_x + near.inverse_shape[1] * by_y;
            g[2 * a + 1] = near.inverse_shape[1] * by_x + near.inverse_shape[2] * by_y;
        }
        return g;
    }

  private:
    std::size_t kind(std::ptrdiff_t x, std::ptrdiff_t y) const {
        std::ptrdiff_t number = 0;
        for (const bool is_high : {false, true}) {
            number = number * (horizon_ + 1) + x_.neighbours(is_high, x);
            number = number * (horizon_ + 1) + y_.neighbours(is_high, y);
        }
        return static_cast<std::size_t>(number);
    }

    void find_neighbours();
    void find_closed_nodes(const PlaneClosure& closure);
    ClosedNode closed_node_at(const PlaneClosure& closure,
                              const std::array<std::size_t, 2>& place) const;
    static void make_exact(ClosedNode& node);
    std::size_t places() const { return static_cast<std::size_t>(2 * closed_places_ + 1); }

    CorrespondenceModel model_;
    PlaneAxis x_;
    PlaneAxis y_;
    std::ptrdiff_t horizon_;
    std::ptrdiff_t pitch_;
    std::vector<PlaneNeighbours> neighbours_{};
    std::ptrdiff_t closed_layers_ = 0;
    std::ptrdiff_t closed_places_ = 0;  // beside each side that is cut off
    std::vector<ClosedNode> closed_{};  // by the axes' place()
};

inline void PlaneNodes::find_closed_nodes(const PlaneClosure& closure) {
    closed_layers_ = static_cast<std::ptrdiff_t>(closure.layers);
    closed_places_ = std::max(closed_layers_, horizon_);
    for (std::size_t y = 0; y < places(); ++y) {
        for (std::size_t x = 0; x < places(); ++x) {
            closed_.push_back(closed_node_at(closure, {x, y}));
        }
    }
}

/// Where the lattice is cut off by another side, too, neighbours beyond that side are not there.
inline ClosedNode PlaneNodes::closed_node_at(const PlaneClosure& closure,
                                             const std::array<std::size_t, 2>& place) const {
    const auto far = static_cast<std::size_t>(closed_places_);
    std::array<int, 2> sign{1, 1};
    std::array<std::size_t, 2> layer{closure.layers, closure.layers};
    std::array<int, 2> beyond{};  // the first step that leads out of the body; 0: none does
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const PlaneAxis& own = axis == 0 ? x_ : y_;
        const std::size_t end = place[axis] > far ? 1 : 0;
        const std::size_t depth = end == 1 ? 2 * far - place[axis] : place[axis];
        if (depth == far || !own.is_cut_off(end)) {
            continue;
        }
        sign[axis] = end == 1 ? -1 : 1;
        if (own.is_closed(end)) {
            layer[axis] = std::min(depth, closure.layers);
        } else {
            beyond[axis] = static_cast<int>(depth) + 1;
        }
    }
    ClosedNode node;
    if (layer[0] == closure.layers && layer[1] == closure.layers) {
        return node;  // the lattice's own
    }
    const PlaneClosure::Node& given = closure.nodes[layer[1] * (closure.layers + 1) + layer[0]];
    node.volume = given.volume;
    for (const PlaneClosure::Entry& entry : given.gradient) {
        const int x = sign[0] * entry.x;
        const int y = sign[1] * entry.y;
        const bool is_there =
            (beyond[0] == 0 || entry.x > -beyond[0]) && (beyond[1] == 0 || entry.y > -beyond[1]);
        if (is_there) {
            node.gradient.push_back(
                {y * pitch_ + x, x, y, {sign[0] * entry.along_x, sign[1] * entry.along_y}});
        }
    }
    if (node.gradient.size() < given.gradient.size()) {
        make_exact(node);
    }
    return node;
}

/// Gives linear displacements their own gradient again, by the least change of the factors, which
/// is that of a cut family where they were the lattice's own.
inline void PlaneNodes::make_exact(ClosedNode& node) {
    std::array<double, 3> shape{};  // xx, xy, yy
    std::array<std::array<double, 2>, 2> missing{{{1, 0}, {0, 1}}};
    for (const ClosedNode::Entry& entry : node.gradient) {
        shape[0] += entry.x * entry.x;
        shape[1] += entry.x * entry.y;
        shape[2] += entry.y * entry.y;
        for (std::size_t b = 0; b < 2; ++b) {
            missing[b][0] -= entry.along[b] * entry.x;
            missing[b][1] -= entry.along[b] * entry.y;
        }
    }
    const double determinant = shape[0] * shape[2] - shape[1] * shape[1];
    if (!(determinant > 0)) {
        throw std::invalid_argument("beside a closed side a node has too few neighbours");
    }
    for (ClosedNode::Entry& entry : node.gradient) {
        const double by_x = (shape[2] * entry.x - shape[1] * entry.y) / determinant;
        const double by_y = (shape[0] * entry.y - shape[1] * entry.x) / determinant;
        for (std::size_t b = 0; b < 2; ++b) {
            entry.along[b] += missing[b][0] * by_x + missing[b][1] * by_y;
        }
    }
}

inline void PlaneNodes::find_neighbours() {
    const auto kinds = static_cast<std::size_t>(horizon_ + 1);
    neighbours_.resize(kinds * kinds * kinds * kinds);
    const std::vector<PlaneOffset> family = plane_family(model_.radius_squared);
    for (const std::ptrdiff_t y : y_.representatives()) {
        for (const std::ptrdiff_t x : x_.representatives()) {
            PlaneNeighbours& near = neighbours_[kind(x, y)];
            if (!near.bonds.empty()) {
                continue;
            }
            double xx = 0;
            double xy = 0;
            double yy = 0;
            for (const PlaneOffset& bond : family) {
                if (-bond.x > x_.neighbours(false, x) || bond.x > x_.neighbours(true, x) ||
                    -bond.y > y_.neighbours(false, y) || bond.y > y_.neighbours(true, y)) {
                    continue;
                }
                near.bonds.push_back({bond.y * pitch_ + bond.x, bond.x, bond.y});
                xx += bond.x * bond.x;
                xy += bond.x * bond.y;
                yy += bond.y * bond.y;
                near.sum_x += bond.x;
                near.sum_y += bond.y;
            }
            const double determinant = xx * yy - xy * xy;
            if (!(determinant > 0)) {
                throw std::invalid_argument(
                    "the body is too thin: a node has neighbours in one direction only");
            }
            near.inverse_shape = {yy / determinant, -xy / determinant, xx / determinant};
        }
    }
}

}  // namespace nmbc::detail
