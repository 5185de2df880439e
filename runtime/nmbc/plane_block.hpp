// SPDX-License-Identifier: MIT
/// The nodes of a rectangle and what its sides make of them: which neighbours there are, and with
/// what weights and masses.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nmbc/plane_model.hpp>
#include <nmbc/plane_sides.hpp>
#include <stdexcept>
#include <variant>
#include <vector>

namespace nmbc::detail {

/// Along one axis: what each node has by its place between the two sides. The weights of a node are
/// the products of those of both axes.
class PlaneAxis {
  public:
    /// nodes: of the body, layers included; ghosts: beyond each side, some of which may be there.
    PlaneAxis(const PlaneSide& low, const PlaneSide& high, std::size_t axis, std::size_t nodes,
              std::size_t horizon)
        : nodes_(static_cast<std::ptrdiff_t>(nodes)),
          ghosts_(static_cast<std::ptrdiff_t>(2 * horizon)),
          horizon_(static_cast<std::ptrdiff_t>(horizon)),
          is_cut_{is_cut(low), is_cut(high)},
          is_periodic_(std::holds_alternative<PeriodicSide>(low)),
          mirrors_{signs_of(low, axis), signs_of(high, axis)},
          is_halo_{std::holds_alternative<HaloSide>(low), std::holds_alternative<HaloSide>(high)},
          strain_(nodes + 4 * horizon, 1),
          stabilisation_(strain_),
          mass_{strain_, strain_} {
        take(low, axis, false);
        take(high, axis, true);
        const auto own = [](const PlaneSide& side) {
            return static_cast<std::ptrdiff_t>(own_layers(side));
        };
        // What a cut side does not reach is plain; beyond sides that are not cut, there is more.
        const Range all = with_energy();
        stressed_.first = is_cut_[0] ? std::max(own(low), horizon_) : all.first;
        stressed_.last = is_cut_[1] ? nodes_ - std::max(own(high), horizon_) : all.last;
        kicked_.first = is_cut_[0] ? own(low) + horizon_ : all.first;
        kicked_.last = is_cut_[1] ? nodes_ - own(high) - horizon_ : all.last;
        const auto passive = [](const PlaneSide& side) {
            return std::holds_alternative<PassiveSide>(side)
                       ? static_cast<std::ptrdiff_t>(own_layers(side))
                       : 0;
        };
        passive_ = {passive(low), nodes_ - passive(high)};
        is_closed_ = {std::holds_alternative<ClosedSide>(low),
                      std::holds_alternative<ClosedSide>(high)};
    }

    std::ptrdiff_t nodes() const { return nodes_; }

    double strain(std::ptrdiff_t node) const { return strain_[index(node)]; }
    double stabilisation(std::ptrdiff_t node) const { return stabilisation_[index(node)]; }
    double mass(std::size_t component, std::ptrdiff_t node) const {
        return mass_[component][index(node)];
    }

    /// A bond's weight is that of the one of its nodes that is nearer to a side with layers of its
    /// own: `low` and the one `step` nodes on.
    double strain_of_bond(std::ptrdiff_t low, std::ptrdiff_t step) const {
        return low < passive_.first ? strain(low) : strain(low + step);
    }

    bool is_periodic() const { return is_periodic_; }
    /// Whether the nodes beyond an end are images of the body's.
    bool has_images(std::size_t end) const { return is_periodic_ || mirrors_[end][0] != 0; }
    /// The node that it is an image of, and the sign with which it moves; else itself, and 1.
    std::ptrdiff_t original(std::ptrdiff_t node) const {
        if (is_periodic_) {
            return (node % nodes_ + nodes_) % nodes_;
        }
        return !is_mirrored(node) ? node : node < 0 ? -1 - node : 2 * nodes_ - 1 - node;
    }
    int sign(std::size_t component, std::ptrdiff_t node) const {
        return is_mirrored(node) ? mirrors_[node < 0 ? 0 : 1][component] : 1;
    }

    /// Whether the node is beyond a side that holds u, or moves it by a condition.
    bool is_ghost(std::ptrdiff_t node) const {
        const std::size_t end = node < 0 ? 0 : 1;
        return (node < 0 || node >= nodes_) && !is_cut_[end] && !has_images(end) && !is_halo_[end];
    }

    /// Whether the node is one of the body's or, beyond a halo, of another block's.
    bool is_material(std::ptrdiff_t node) const {
        return (node >= 0 || is_halo_[0]) && (node < nodes_ || is_halo_[1]);
    }

    /// Nodes from first to last - 1 have what is asked for.
    using Range = PlaneRange;
    /// T is not 0 there: beyond sides that are not cut off, too.
    Range with_energy() const {
        return {is_cut_[0] ? 0 : -horizon_, is_cut_[1] ? nodes_ : nodes_ + horizon_};
    }
    /// Those of them whose energy is this body's: beyond sides with ghosts, too.
    Range with_own_energy() const {
        return {is_ghost(-1) ? -horizon_ : 0, is_ghost(nodes_) ? nodes_ + horizon_ : nodes_};
    }
    // Empty, or from last to first, in a thin body; beyond sides that are not cut off, too:
    Range plain_stress() const { return stressed_; }  ///< the family is whole, own weights are 1
    Range plain_force() const { return kicked_; }     ///< and those of the whole family are 1
    /// Of the body: masses are 1, times the volume that closed sides give.
    Range plain_mass() const { return passive_; }

    /// Those of them that are nodes of the body.
    Range in_body(const Range& range) const {
        return {std::max<std::ptrdiff_t>(range.first, 0), std::min(range.last, nodes_)};
    }

    /// Whether the node is in a layer that has numbers of its own.
    bool is_passive(std::ptrdiff_t node) const {
        return node < passive_.first || node >= passive_.last;
    }

    /// Layers between a node and the nearest of some sides.
    struct Depth {
        std::ptrdiff_t layers = 0;  ///< 0: on the side, or beyond it
        bool is_high = false;       ///< of the high side
    };
    /// From a closed side; `layers`, of the low side: the node is so far from both, or farther.
    Depth from_closed(std::ptrdiff_t node, std::ptrdiff_t layers) const {
        return depth(is_closed_, node, layers);
    }
    /// Layers beside sides that are cut off, closed ones included, where nodes have a gradient or
    /// weights of their own; 0: there are no such sides.
    std::ptrdiff_t cut_layers() const {
        return std::max(is_cut_[0] ? stressed_.first : 0, is_cut_[1] ? nodes_ - stressed_.last : 0);
    }
    /// Where a node is between sides that are cut off: its layer at the low one, 0 on it; `layers`
    /// where it is so far from both, or farther; up to 2 layers on the high one. Beyond such a side
    /// there are no nodes, and what is asked for is that on it.
    std::size_t place(std::ptrdiff_t node, std::ptrdiff_t layers) const {
        const Depth from_cut = depth(is_cut_, node, layers);
        return static_cast<std::size_t>(from_cut.is_high ? 2 * layers - from_cut.layers
                                                         : from_cut.layers);
    }
    /// A node of each place() that there is.
    std::map<std::size_t, std::ptrdiff_t> nodes_of_places(std::ptrdiff_t layers) const {
        std::map<std::size_t, std::ptrdiff_t> nodes;
        const Range all = with_energy();
        for (std::ptrdiff_t node = all.first; node < all.last; ++node) {
            nodes.try_emplace(place(node, layers), node);
        }
        return nodes;
    }

    /// How many neighbours there can be towards the low or the high side, up to the horizon.
    std::ptrdiff_t neighbours(bool is_high, std::ptrdiff_t node) const {
        const std::ptrdiff_t there = is_high ? nodes_ - 1 - node : node;
        return is_cut_[is_high ? 1 : 0] ? std::clamp<std::ptrdiff_t>(there, 0, horizon_) : horizon_;
    }

    /// Whether a bond this far along the axis leads to a node that is there.
    bool reaches(std::ptrdiff_t node, std::ptrdiff_t step) const {
        return -step <= neighbours(false, node) && step <= neighbours(true, node);
    }

    /// Nodes one of which has the neighbours of any.
    std::vector<std::ptrdiff_t> representatives() const {
        std::vector<std::ptrdiff_t> nodes;
        std::vector<std::array<std::ptrdiff_t, 2>> seen;
        const Range all = with_energy();
        for (std::ptrdiff_t node = all.first; node < all.last; ++node) {
            const std::array<std::ptrdiff_t, 2> there{neighbours(false, node),
                                                      neighbours(true, node)};
            if (std::ranges::find(seen, there) == seen.end()) {
                seen.push_back(there);
                nodes.push_back(node);
            }
        }
        return nodes;
    }

  private:
    /// Of the images of both components; 0: there is no mirror.
    static std::array<int, 2> signs_of(const PlaneSide& side, std::size_t axis) {
        const auto* const mirror = std::get_if<MirrorSide>(&side);
        if (mirror == nullptr) {
            return {0, 0};
        }
        const int across = mirror->is_odd ? 1 : -1;
        return axis == 0 ? std::array{across, -across} : std::array{-across, across};
    }
    Depth depth(const std::array<bool, 2>& sides, std::ptrdiff_t node,
                std::ptrdiff_t layers) const {
        const auto from = [layers](bool is_there, std::ptrdiff_t side) {
            return is_there ? std::clamp<std::ptrdiff_t>(side, 0, layers) : layers;
        };
        const std::ptrdiff_t low = from(sides[0], node);
        const std::ptrdiff_t high = from(sides[1], nodes_ - 1 - node);
        return {std::min(low, high), high < low};
    }
    bool is_mirrored(std::ptrdiff_t node) const {
        return (node < 0 && mirrors_[0][0] != 0) || (node >= nodes_ && mirrors_[1][0] != 0);
    }

    std::size_t index(std::ptrdiff_t node) const {
        return static_cast<std::size_t>(node + ghosts_);
    }

    void take(const PlaneSide& side, std::size_t axis, bool is_high) {
        if (const auto* const passive = std::get_if<PassiveSide>(&side)) {
            for (std::size_t layer = 0; layer < passive->strain.size(); ++layer) {
                const auto from_low = static_cast<std::ptrdiff_t>(layer);
                const std::size_t at = index(is_high ? nodes_ - 1 - from_low : from_low);
                strain_[at] = passive->strain[layer];
                stabilisation_[at] = passive->stabilisation[layer];
                for (std::size_t component = 0; component < 2; ++component) {
                    mass_[component][at] = passive->mass[component == axis ? 0 : 1][layer];
                }
            }
        }
    }

    std::ptrdiff_t nodes_;
    std::ptrdiff_t ghosts_;
    std::ptrdiff_t horizon_;
    std::array<bool, 2> is_cut_;
    bool is_periodic_;
    std::array<std::array<int, 2>, 2> mirrors_;  // by end and component
    std::array<bool, 2> is_halo_;
    std::vector<double> strain_;
    std::vector<double> stabilisation_;
    std::array<std::vector<double>, 2> mass_;
    Range stressed_{};
    Range kicked_{};
    std::array<bool, 2> is_closed_{};
    Range passive_{};  ///< between the layers of passive sides
};

/// The images beyond the ends of a row, whose node 0 is row[0], of a field's component; ghosts: at
/// each end.
template <class Real>
void close_row(const PlaneAxis& axis, std::size_t component, Real* row, std::ptrdiff_t ghosts) {
    for (const std::size_t end : {0U, 1U}) {
        if (!axis.has_images(end)) {
            continue;
        }
        for (std::ptrdiff_t ghost = 0; ghost < ghosts; ++ghost) {
            const std::ptrdiff_t node = end == 0 ? -1 - ghost : axis.nodes() + ghost;
            row[node] = static_cast<Real>(axis.sign(component, node)) * row[axis.original(node)];
        }
    }
}

}  // namespace nmbc::detail
