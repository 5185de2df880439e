// SPDX-License-Identifier: MIT
/// Where a crack branches.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nmbcrun {

struct CrackedNode {
    std::array<long, 2> place{};  ///< its numbers along x and y, beyond periodic sides, too
    std::array<double, 2> X{};    ///< [length]
    double distance = 0;          ///< from where the crack begins [length]
};

/// The direction from one point to another: above -180, up to 180.
long degrees_from_x(const std::array<double, 2>& from, const std::array<double, 2>& to);

/// Where a crack goes on in several ways.
struct CrackBranch {
    std::array<double, 2> X{};  ///< [length]
    /// Of each way over its first five horizons, from the x axis [degrees].
    std::vector<long> directions{};
};

/// Cracked nodes in bands of distance, a horizon wide each. The nodes of a band that hang together
/// are a piece.
class CrackPieces {
  public:
    /// Cracks are two nodes wide, and ragged: a node between two others may be whole.
    static constexpr long gap = 2;

    CrackPieces(const std::vector<CrackedNode>& nodes, double horizon);

    /// Where a piece goes on in two of the next band or more, which go on for at least five
    /// horizons; the nearest first.
    std::vector<CrackBranch> branches() const;

  private:
    struct Piece {
        std::vector<std::size_t> nodes{};
        std::size_t band = 0;
        std::array<double, 2> nearest{};     ///< its first node
        double from = HUGE_VAL;              ///< distance of that
        double deepest = 0;                  ///< distance to which it goes on
        std::vector<std::size_t> further{};  ///< pieces of the next band beside it
    };
    std::size_t band_of(std::size_t node) const;
    void find_neighbours();
    void find_pieces();
    void join_pieces();
    /// The middle of the nodes that the way has five horizons on.
    std::array<double, 2> far_along(std::size_t way) const;

    const std::vector<CrackedNode>* nodes_;
    double horizon_;
    std::vector<std::vector<std::size_t>> neighbours_{};  ///< of each node
    std::vector<std::size_t> piece_of_{};                 ///< likewise
    std::vector<Piece> pieces_{};                         ///< inner bands first
};

}  // namespace nmbcrun
