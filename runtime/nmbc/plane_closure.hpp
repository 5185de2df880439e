// SPDX-License-Identifier: MIT
/// Nodes near the surface of a plane, corners included, whose gradients and volumes are their own.
#pragma once

#include <cstddef>
#include <vector>

namespace nmbc {

/// How a plane of correspondence is closed at its surfaces, on which its outermost nodes lie: with
/// the gradients g and volumes V of nodes near a side, and near the corner of two, its energy is
/// the sum of V times the energy of a node, and V is the mass. Whatever the numbers are, it is a
/// sum of squares while all V are positive. dX = 1.
struct PlaneClosure {
    /// A node J at this offset from the node I, and its factors in the gradient there: g_ax = sum
    /// along_x (u_J - u_I)_a.
    struct Entry {
        int x = 0;
        int y = 0;
        double along_x = 0;
        double along_y = 0;
    };
    struct Node {
        double volume = 1;
        std::vector<Entry> gradient{};  ///< of its family, without itself: of u_J - u_I
    };

    unsigned radius_squared = 0;
    std::vector<double> influence{};  ///< of the lattice, as its CorrespondenceModel has it
    std::size_t layers = 0;  ///< nodes this far from all closed sides are the lattice's own
    /// That of the node (i, j), counted from the corner of the sides across x and y at their low
    /// ends, is entry j * (layers + 1) + i; i or j = layers: far from the side. Along other sides
    /// they are mirror images. The last entry does not count.
    std::vector<Node> nodes{};
    /// Of node j of a side, counted from the end where another closed side begins, the length of
    /// the surface that it stands for, on which a traction acts; 1 from `layers` on.
    std::vector<double> surface{};
};

}  // namespace nmbc
