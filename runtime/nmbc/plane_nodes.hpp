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
        double influence = 1;
    };
    std::vector<Bond> bonds{};
    std::array<double, 3> inverse_shape{};  ///< xx, xy, yy
    double sum_x = 0;                       ///< of the influence times the offset
    double sum_y = 0;
};

/// What a node near a closed side has.
struct ClosedNode {
    struct Entry {
        std::ptrdiff_t entry = 0;  ///< from the node's entry of a field
        int x = 0;
        int y = 0;
        double influence = 1;
        std::array<double, 2> along{};  ///< factors of u there in the gradient
    };
    double volume = 1;
    std::vector<Entry> gradient{};
};

/// xx, xy, yy of the inverse of the shape tensor, the sum of w R R^T over bonds R, w their
/// influence. Throws std::invalid_argument where they all have one direction.
template <class Bonds>
std::array<double, 3> inverse_shape_of(const Bonds& bonds) {
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const auto& bond : bonds) {
        xx += bond.influence * bond.x * bond.x;
        xy += bond.influence * bond.x * bond.y;
        yy += bond.influence * bond.y * bond.y;
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0)) {
        throw std::invalid_argument(
            "the body is too thin: a node has neighbours in one direction only");
    }
    return {yy / determinant, -xy / determinant, xx / determinant};
}

/// The nodes of the plane: what each weighs, which neighbours it has, and the gradient there.
class PlaneNodes {
  public:
    /// pitch: entries of a field from one row to the next. Throws std::invalid_argument where a
    /// node has too few neighbours for a gradient.
    PlaneNodes(const CorrespondenceModel& model, PlaneAxis x, PlaneAxis y, std::ptrdiff_t pitch,
               const PlaneClosure* closure = nullptr)
        : model_(model),
          family_(weighted_family(model)),
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
            x_.place(x, closed_reach()) + y_.place(y, closed_reach()) * places();
        return closed_[number].gradient.empty() ? nullptr : &closed_[number];
    }

    /// That closed sides give a node; 1: it is not near one.
    double volume(std::ptrdiff_t x, std::ptrdiff_t y) const {
        const ClosedNode* const own = closed(x, y);
        return own == nullptr ? 1 : own->volume;
    }
    /// Those of the other sides, times the volume.
    PlaneWeights weights(std::ptrdiff_t x, std::ptrdiff_t y) const {
        const double V = volume(x, y);
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
                by_x += bond.influence * bond.x * there;
                by_y += bond.influence * bond.y * there;
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
    ClosedNode closed_node_at(const PlaneClosure& closure, std::ptrdiff_t x,
                              std::ptrdiff_t y) const;
    /// Of a bond of the family.
    double influence_of(int x, int y) const {
        return std::ranges::find_if(
                   family_, [=](const WeightedBond& bond) { return bond.x == x && bond.y == y; })
            ->influence;
    }
    static void make_exact(ClosedNode& node);
    /// Layers beside each side that is cut off, where the nodes of a closed one are unlike others.
    std::ptrdiff_t closed_reach() const { return std::max(closed_layers_, horizon_); }
    std::size_t places() const { return static_cast<std::size_t>(2 * closed_reach() + 1); }

    CorrespondenceModel model_;
    std::vector<WeightedBond> family_;
    PlaneAxis x_;
    PlaneAxis y_;
    std::ptrdiff_t horizon_;
    std::ptrdiff_t pitch_;
    std::vector<PlaneNeighbours> neighbours_{};
    std::ptrdiff_t closed_layers_ = 0;
    std::vector<ClosedNode> closed_{};  // by the axes' place()
};

inline void PlaneNodes::find_closed_nodes(const PlaneClosure& closure) {
    closed_layers_ = static_cast<std::ptrdiff_t>(closure.layers);
    closed_.resize(places() * places());
    const auto xs = x_.nodes_of_places(closed_reach());
    for (const auto& [place_y, y] : y_.nodes_of_places(closed_reach())) {
        for (const auto& [place_x, x] : xs) {
            closed_[place_y * places() + place_x] = closed_node_at(closure, x, y);
        }
    }
}

/// Where the lattice is cut off by another side, too, neighbours beyond that side are not there.
inline ClosedNode PlaneNodes::closed_node_at(const PlaneClosure& closure, std::ptrdiff_t x,
                                             std::ptrdiff_t y) const {
    const PlaneAxis::Depth from_x = x_.from_closed(x, closed_layers_);
    const PlaneAxis::Depth from_y = y_.from_closed(y, closed_layers_);
    ClosedNode node;
    if (from_x.layers == closed_layers_ && from_y.layers == closed_layers_) {
        return node;  // the lattice's own
    }
    const PlaneClosure::Node& given =
        closure
            .nodes[static_cast<std::size_t>(from_y.layers * (closed_layers_ + 1) + from_x.layers)];
    node.volume = given.volume;
    const int sign_x = from_x.is_high ? -1 : 1;
    const int sign_y = from_y.is_high ? -1 : 1;
    for (const PlaneClosure::Entry& entry : given.gradient) {
        const int to_x = sign_x * entry.x;
        const int to_y = sign_y * entry.y;
        if (x_.reaches(x, to_x) && y_.reaches(y, to_y)) {
            node.gradient.push_back({to_y * pitch_ + to_x,
                                     to_x,
                                     to_y,
                                     influence_of(to_x, to_y),
                                     {sign_x * entry.along_x, sign_y * entry.along_y}});
        }
    }
    if (node.gradient.size() < given.gradient.size()) {
        make_exact(node);
    }
    return node;
}

/// Gives linear displacements their own gradient again, by the least change of the factors over the
/// square root of the influence, which is that of a cut family where they were the lattice's own.
inline void PlaneNodes::make_exact(ClosedNode& node) {
    const auto [xx, xy, yy] = inverse_shape_of(node.gradient);
    std::array<std::array<double, 2>, 2> missing{{{1, 0}, {0, 1}}};
    for (const ClosedNode::Entry& entry : node.gradient) {
        for (std::size_t b = 0; b < 2; ++b) {
            missing[b][0] -= entry.along[b] * entry.x;
            missing[b][1] -= entry.along[b] * entry.y;
        }
    }
    for (ClosedNode::Entry& entry : node.gradient) {
        for (std::size_t b = 0; b < 2; ++b) {
            entry.along[b] += entry.influence * (missing[b][0] * (xx * entry.x + xy * entry.y) +
                                                 missing[b][1] * (xy * entry.x + yy * entry.y));
        }
    }
}

inline void PlaneNodes::find_neighbours() {
    const auto kinds = static_cast<std::size_t>(horizon_ + 1);
    neighbours_.resize(kinds * kinds * kinds * kinds);
    for (const std::ptrdiff_t y : y_.representatives()) {
        for (const std::ptrdiff_t x : x_.representatives()) {
            PlaneNeighbours& near = neighbours_[kind(x, y)];
            if (!near.bonds.empty()) {
                continue;
            }
            for (const auto& [to_x, to_y, influence] : family_) {
                if (x_.reaches(x, to_x) && y_.reaches(y, to_y)) {
                    near.bonds.push_back({to_y * pitch_ + to_x, to_x, to_y, influence});
                    near.sum_x += influence * to_x;
                    near.sum_y += influence * to_y;
                }
            }
            near.inverse_shape = inverse_shape_of(near.bonds);
        }
    }
}

}  // namespace nmbc::detail
