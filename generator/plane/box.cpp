// SPDX-License-Identifier: MIT
#include "generator/plane/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "generator/dense/decompositions.hpp"

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
          displacement_(MatrixXd::Identity(unknowns_, state_)),
          velocity_(MatrixXd::Zero(unknowns_, state_)),
          acceleration_(MatrixXd::Zero(unknowns_, state_)) {
        Index entry = unknowns_;
        for (Index row = 0; row < unknowns_; ++row) {
            if (order_ == 2 || is_interior(row)) {
                velocity_(row, entry++) = 1;
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

    Index row_of(Index i, Index j, Index component) const {
        return 2 * (j * all_ + i) + component;
    }
    std::array<Index, 2> node_of(Index row) const { return {row / 2 % all_, row / 2 / all_}; }
    bool is_interior(Index row) const {
        return std::ranges::all_of(
            node_of(row), [this](Index at) { return at >= reach_ && at < all_ - reach_; });
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
        for (const std::size_t axis : {1U, 0U}) {
            const SideCondition& condition = axis == 0 ? sides_.across_x : sides_.across_y;
            const Index corner = axis == 0 ? 0 : reach_;
            for (Index ghost = reach_ - 1; ghost >= 0; --ghost) {
                for (Index along = corner; along < all_ - corner; ++along) {
                    for (const Index inwards : {1, -1}) {
                        const Index layer = inwards == 1 ? ghost : all_ - 1 - ghost;
                        for (const Index a : {0, 1}) {
                            const bool is_normal = std::size_t(a) == axis;
                            close_one(highest, lower, condition.residual[is_normal ? 0 : 1],
                                      [&](std::size_t shift) {
                                          const Index at = layer + inwards * Index(shift);
                                          return axis == 0 ? row_of(at, along, a)
                                                           : row_of(along, at, a);
                                      });
                        }
                    }
                }
            }
        }
    }

    template <class Row>
    void close_one(MatrixXd& highest, const std::vector<const MatrixXd*>& lower,
                   const ShiftPolynomial& residual, Row row) const {
        Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(state_);
        const std::vector<double>& own = residual.back();
        for (std::size_t j = 1; j < own.size(); ++j) {
            sum += own[j] * highest.row(row(j));
        }
        for (std::size_t p = 0; p < lower.size(); ++p) {
            for (std::size_t j = 0; j < residual[p].size(); ++j) {
                sum += residual[p][j] * lower[p]->row(row(j));
            }
        }
        highest.row(row(0)) = -sum / own[0];
    }

    /// The row of a state's displacement or velocity.
    Index row_of_state(Index entry) const {
        return entry < unknowns_ ? entry : moving_[std::size_t(entry - unknowns_)];
    }

    /// d/dt of the state of a quarter, the others being its mirror images.
    MatrixXd of_parity(int in_x, int in_y) const {
        std::vector<Index> quarter;
        std::vector<Index> place(std::size_t(state_), -1);  // of its image in the quarter
        std::vector<Index> moving_place(std::size_t(unknowns_), -1);
        for (std::size_t i = 0; i < moving_.size(); ++i) {
            moving_place[std::size_t(moving_[i])] = unknowns_ + Index(i);
        }
        std::vector<Index> image(std::size_t(state_), 0);
        std::vector<double> sign(std::size_t(state_), 1);
        for (Index entry = 0; entry < state_; ++entry) {
            const Index row = row_of_state(entry);
            auto [i, j] = node_of(row);
            const Index a = row % 2;
            double& own = sign[std::size_t(entry)];
            if (2 * i >= all_) {
                i = all_ - 1 - i;
                own *= a == 0 ? -in_x : in_x;
            }
            if (2 * j >= all_) {
                j = all_ - 1 - j;
                own *= a == 1 ? -in_y : in_y;
            }
            const Index mirrored = row_of(i, j, a);
            image[std::size_t(entry)] =
                entry < unknowns_ ? mirrored : moving_place[std::size_t(mirrored)];
            if (image[std::size_t(entry)] == entry) {
                place[std::size_t(entry)] = Index(quarter.size());
                quarter.push_back(entry);
            }
        }
        MatrixXd rates = MatrixXd::Zero(Index(quarter.size()), Index(quarter.size()));
        for (Index entry = 0; entry < state_; ++entry) {
            const Index column = place[std::size_t(image[std::size_t(entry)])];
            for (Index k = 0; k < Index(quarter.size()); ++k) {
                const Index of = quarter[std::size_t(k)];
                const MatrixXd& derivative = of < unknowns_ ? velocity_ : acceleration_;
                rates(k, column) +=
                    sign[std::size_t(entry)] * derivative(row_of_state(of), entry);
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
    std::vector<Index> moving_{};  ///< rows whose velocities are part of the state
    MatrixXd displacement_;
    MatrixXd velocity_;
    MatrixXd acceleration_;
};

}  // namespace

double growth_in_box(const PlaneLattice& lattice, const BoxSides& sides, std::size_t nodes) {
    return Box(lattice, sides, Index(nodes)).growth();
}

}  // namespace nmbcgen
