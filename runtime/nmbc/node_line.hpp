// SPDX-License-Identifier: MIT
/// A field as a boundary sees it: along a line of nodes that runs inwards.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

namespace nmbc {

/// The end of an axis: left, where its coordinate is least, or right.
enum class End { left, right };

/// The side of a lattice at one end of an axis, which it is normal to: axis 0 is x, 1 is y.
struct Side {
    std::size_t axis = 0;
    End end = End::left;
};

/// Nodes of a lattice along each axis. Its fields have an entry for each node, row by row, x
/// fastest. A chain is one row.
struct Grid {
    std::size_t nx = 0;
    std::size_t ny = 1;
};

/// The entries of a field on a line of nodes normal to a side, counted inwards: 0 is the outermost
/// ghost node. The same code then does for every side. It does not know how long the line is: an
/// object of two members is passed in registers, and a larger one through memory, which takes
/// longer than most boundaries.
template <class Value>
class NodeLine {
  public:
    /// first: entry 0; stride: from an entry to the next one inwards.
    NodeLine(Value* first, std::ptrdiff_t stride) : first_(first), stride_(stride) {}

    /// The nodes of a chain from one of its ends on.
    NodeLine(std::span<Value> field, End end)
        : NodeLine(field, {.nx = field.size()}, {.end = end}, 0) {}

    /// Line `number` of those normal to a side, counted along the other axis.
    NodeLine(std::span<Value> field, const Grid& grid, Side side, std::size_t number)
        : first_(field.data() + number * (side.axis == 0 ? grid.nx : 1)),
          stride_(side.axis == 0 ? 1 : static_cast<std::ptrdiff_t>(grid.nx)) {
        const std::size_t length = side.axis == 0 ? grid.nx : grid.ny;
        if (side.end == End::right && length > 0) {
            first_ += static_cast<std::ptrdiff_t>(length - 1) * stride_;
            stride_ = -stride_;
        }
    }

    /// Of entries that may be written, those that may only be read.
    template <class Writable>
    requires(std::is_same_v<const Writable, Value> && !std::is_same_v<Writable, Value>)
        NodeLine(const NodeLine<Writable>& other)  // NOLINT(google-explicit-constructor)
        : first_(other.first_), stride_(other.stride_) {}

    Value& operator[](std::size_t j) const {
        return first_[stride_ * static_cast<std::ptrdiff_t>(j)];
    }

  private:
    template <class Other>
    friend class NodeLine;

    Value* first_ = nullptr;
    std::ptrdiff_t stride_ = 0;
};

}  // namespace nmbc
