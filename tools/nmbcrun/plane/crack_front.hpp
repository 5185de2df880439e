// SPDX-License-Identifier: MIT
/// How far the cracks of a plane scene have grown, and where they have branched.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "tools/nmbcrun/plane/crack_pieces.hpp"
#include "tools/nmbcrun/plane/plane_scene.hpp"

namespace nmbcrun {

/// Of a crack that grows from an end of a line of fracture.cracks. A node is cracked where more
/// than 0.35 of its bonds do not hold: beside a straight cut along an axis, 11 of 28 at radius 3.
struct CrackGrowth {
    double reach = 0;  ///< to the farthest of the cracked nodes that hang together with it [length]
    std::array<double, 2> tip{};  ///< that node
    /// Where it goes on in two ways or more, of at least five horizons each; the nearest first.
    std::vector<CrackBranch> branches{};
};

class CrackFront {
  public:
    explicit CrackFront(const PlaneScene& scene);

    double horizon() const { return horizon_; }
    /// The ends of the lines that are within the plane, and not where another line goes on.
    const std::vector<std::array<double, 2>>& ends() const { return ends_; }

    /// Of each end; damage: of node (x, y).
    std::vector<CrackGrowth> look(
        const std::function<double(std::size_t, std::size_t)>& damage) const;

  private:
    void join_lines();
    void find_ends();
    bool is_beside_group(std::size_t group, const std::array<double, 2>& X) const;
    std::vector<CrackedNode> connected_to(std::size_t number,
                                          const std::vector<bool>& cracked) const;
    CrackGrowth growth_of(const std::vector<CrackedNode>& nodes, std::size_t end) const;

    std::array<std::size_t, 2> nodes_;
    double spacing_;
    double horizon_;  // [length]
    double cracked_above_ = 0;
    std::array<bool, 2> is_periodic_;
    std::vector<std::array<double, 4>> lines_;
    std::vector<std::size_t> group_{};  ///< of each line: those that touch have one
    std::vector<std::array<double, 2>> ends_{};
    std::vector<std::size_t> line_of_end_{};
};

/// The speed of Rayleigh waves on a solid with these two; none where c_S is 0 or not below c_P.
std::optional<double> rayleigh_speed(double speed_P, double speed_S);

}  // namespace nmbcrun
