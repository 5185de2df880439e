// SPDX-License-Identifier: MIT
#include "generator/plane/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "generator/dense/decompositions.hpp"
#include "generator/plane/ghost_row.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Displacements, velocities and accelerations of all nodes as linear functions of the state: the
/// displacements of all, and the velocities of those where they are no function of it.
class Box {
  public:
    Box(const PlaneLattice& lattice, const BoxSides& sides, Index nodes)
        : sides_(sides),
          reach_(reach_of(lattice)),
          all_(nodes + 2 * reach_),
          order_(Index(sides.across_x.residual[0].size()) - 1),
          unknowns_(2 * all_ * all_),
          state_(unknowns_ + (order_ == 1 ? 2 * nodes * nodes : unknowns_)),
          velocity_entry_(std::size_t(unknowns_), -1),
          displacement_(MatrixXd::Identity(unknowns_, state_)),
          velocity_(MatrixXd::Zero(unknowns_, state_)),
          acceleration_(MatrixXd::Zero(unknowns_, state_)) {
        for (Index row = 0; row < unknowns_; ++row) {
            if (order_ == 2 || is_interior(row)) {
                const Index entry = unknowns_ + Index(moving_.size());
                velocity_(row, entry) = 1;
                velocity_entry_[std::size_t(row)] = entry;
                moving_.push_back(row);
            }
        }
        if (order_ == 1) {
            close(velocity_, {&displacement_});
        }
        for (Index row = 0; row < unknowns_; ++row) {
            if (is_interior(row)) {
                accelerate(lattice, row);
            }
        }
        if (order_ == 2) {
            close(acceleration_, {&displacement_, &velocity_});
        }
    }

    /// Motions are even or odd in x, and in y.
    double growth() const {
        double largest = -HUGE_VAL;
        for (const int in_x : {1, -1}) {
            for (const int in_y : {1, -1}) {
                largest = std::max(largest, eigenvalues(of_parity(in_x, in_y)).real().maxCoeff());
            }
        }
        return largest;
    }

  private:
    static Index reach_of(const PlaneLattice& lattice) {
        int reach = 0;
        for (const PlaneBond& bond : lattice.bonds) {
            reach = std::max({reach, std::abs(bond.offset[0]), std::abs(bond.offset[1])});
        }
        return reach;
    }

    Index row_of(Index i, Index j, Index component) const { return 2 * (j * all_ + i) + component; }
    std::array<Index, 2> node_of(Index row) const { return {row / 2 % all_, row / 2 / all_}; }
    bool is_interior(Index row) const {
        return std::ranges::all_of(node_of(row),
                                   [this](Index at) { return at >= reach_ && at < all_ - reach_; });
    }

    void accelerate(const PlaneLattice& lattice, Index row) {
        const auto [i, j] = node_of(row);
        const Index a = row % 2;
        for (const PlaneBond& bond : lattice.bonds) {
            for (const Index b : {0, 1}) {
                const Index from = row_of(i + bond.offset[0], j + bond.offset[1], b);
                acceleration_.row(row) -= bond.stiffness(a, b) * displacement_.row(from) +
                                          bond.damping(a, b) * velocity_.row(from);
            }
        }
    }

    /// The rows of ghosts of the highest derivative from those of the lower ones, outwards.
    void close(MatrixXd& highest, const std::vector<const MatrixXd*>& lower) const {
        for (const Index axis : {1, 0}) {
            for (const Index inwards : {1, -1}) {
                close_side(axis, inwards, highest, lower);
            }
        }
    }

    void close_side(Index axis, Index inwards, MatrixXd& highest,
                    const std::vector<const MatrixXd*>& lower) const {
        const SideCondition& condition = axis == 0 ? sides_.across_x : sides_.across_y;
        const Index corner = axis == 0 ? 0 : reach_;
        for (Index ghost = reach_ - 1; ghost >= 0; --ghost) {
            const Index layer = inwards == 1 ? ghost : all_ - 1 - ghost;
            for (Index along = corner; along < all_ - corner; ++along) {
                for (const Index a : {0, 1}) {
                    close_ghost(condition.residual[a == axis ? 0 : 1], lower, highest,
                                [&](std::size_t shift) {
                                    const Index at = layer + inwards * Index(shift);
                                    return axis == 0 ? row_of(at, along, a) : row_of(along, at, a);
                                });
                }
            }
        }
    }

    /// The row of a state's displacement or velocity.
    Index row_of_state(Index entry) const {
        return entry < unknowns_ ? entry : moving_[std::size_t(entry - unknowns_)];
    }

    /// The entry's image in the quarter of low i and j, and its sign under these parities.
    struct Image {
        Index entry;
        double sign;
    };
    Image image_of(Index entry, int in_x, int in_y) const {
        const Index row = row_of_state(entry);
        auto [i, j] = node_of(row);
        const Index a = row % 2;
        double sign = 1;
        if (2 * i >= all_) {
            i = all_ - 1 - i;
            sign *= a == 0 ? -in_x : in_x;
        }
        if (2 * j >= all_) {
            j = all_ - 1 - j;
            sign *= a == 1 ? -in_y : in_y;
        }
        const Index mirrored = row_of(i, j, a);
        return {.entry = entry < unknowns_ ? mirrored : velocity_entry_[std::size_t(mirrored)],
                .sign = sign};
    }

    /// d/dt of the state of a quarter, the others being its mirror images.
    MatrixXd of_parity(int in_x, int in_y) const {
        std::vector<Index> quarter;
        std::vector<Index> place(std::size_t(state_), -1);
        for (Index entry = 0; entry < state_; ++entry) {
            if (image_of(entry, in_x, in_y).entry == entry) {
                place[std::size_t(entry)] = Index(quarter.size());
                quarter.push_back(entry);
            }
        }
        MatrixXd rates = MatrixXd::Zero(Index(quarter.size()), Index(quarter.size()));
        for (Index entry = 0; entry < state_; ++entry) {
            const Image image = image_of(entry, in_x, in_y);
            const Index column = place[std::size_t(image.entry)];
            for (Index k = 0; k < rates.rows(); ++k) {
                const Index of = quarter[std::size_t(k)];
                const MatrixXd& derivative = of < unknowns_ ? velocity_ : acceleration_;
                rates(k, column) += image.sign * derivative(row_of_state(of), entry);
            }
        }
        return rates;
    }

    const BoxSides& sides_;
    Index reach_;
    Index all_;    ///< nodes along an axis, with ghosts
    Index order_;  ///< highest power of D
    Index unknowns_;
    Index state_;
    std::vector<Index> moving_{};        ///< rows whose velocities are part of the state
    std::vector<Index> velocity_entry_;  ///< of a row's velocity in the state; or -1
    MatrixXd displacement_;
    MatrixXd velocity_;
    MatrixXd acceleration_;
};

}  // namespace

double growth_in_box(const PlaneLattice& lattice, const BoxSides& sides, std::size_t nodes) {
    return Box(lattice, sides, Index(nodes)).growth();
}

}  // namespace nmbcgen
