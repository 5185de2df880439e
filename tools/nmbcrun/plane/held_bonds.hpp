// SPDX-License-Identifier: MIT
/// The bonds of a plane that hold, and what they still join.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nmbc/plane.hpp>
#include <string>
#include <vector>

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/plane/plane_sources.hpp"

namespace nmbcrun {

class HeldBonds {
  public:
    /// Those of now, of a bond-based scene's plane.
    HeldBonds(const PlaneScene& scene, const nmbc::Plane& plane);

    /// Largest difference of a component of u between the ends of a bond within the interior, over
    /// the bond's length.
    double largest_strain() const;

    /// The nodes, of these entries of a field or not, that a chain of bonds joins to one of them.
    std::size_t joined_to(const std::vector<std::size_t>& entries) const;
    /// Layers of sides included.
    std::size_t nodes() const { return count_[0] * count_[1]; }

  private:
    using Node = std::array<std::ptrdiff_t, 2>;  // of the body, layers included

    /// Calls work(other, offset) for each of the node's bonds whose other end is a node of the
    /// body, beyond a periodic side, too.
    template <class Work>
    void for_each_bond(const Node& node, const Work& work) const;
    std::size_t index(const Node& node) const {
        return std::size_t(node[1]) * count_[0] + std::size_t(node[0]);
    }

    const nmbc::Plane* plane_;
    std::vector<nmbc::detail::BondGroup> groups_;
    std::array<std::size_t, 2> count_{};
    std::array<bool, 2> is_periodic_{};
    std::vector<std::uint32_t> held_;  // word by word
};

/// In words: the sources whose nodes are joined to less than a tenth of the others, once bonds have
/// broken.
std::vector<std::string> warnings_of_torn_loads(const PlaneScene& scene, const nmbc::Plane& plane,
                                                const PlaneSources& sources);

}  // namespace nmbcrun
