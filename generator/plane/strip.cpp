// SPDX-License-Identifier: MIT
#include "generator/plane/strip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "generator/dense/decompositions.hpp"
#include "generator/plane/ghost_row.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Displacements, velocities and accelerations of all layers as linear functions of the state: the
/// displacements of all, and the velocities of those where they are no function of it.
class Strip {
  public:
    Strip(const LateralChain& chain, const SideCondition& condition, std::size_t layers)
        : chain_(chain),
          condition_(condition),
          size_(chain.components()),
          reach_(Index(chain.reach())),
          all_(Index(layers) + 2 * reach_),
          order_(Index(condition.residual[0].size()) - 1),
          slaved_(order_ == 1 ? reach_ : 0),
          state_(size_ * (2 * all_ - 2 * slaved_)),
          displacement_(MatrixXd::Identity(size_ * all_, state_)),
          velocity_(MatrixXd::Zero(size_ * all_, state_)),
          acceleration_(MatrixXd::Zero(size_ * all_, state_)) {
        const Index moving = size_ * (all_ - 2 * slaved_);
        velocity_.block(size_ * slaved_, size_ * all_, moving, moving).setIdentity();
        if (order_ == 1) {
            close(velocity_, {&displacement_});
        }
        for (Index layer = reach_; layer < all_ - reach_; ++layer) {
            for (Index r = -reach_; r <= reach_; ++r) {
                const auto from = std::size_t(r + reach_);
                rows(acceleration_, layer) -=
                    chain_.stiffness[from] * rows(displacement_, layer + r) +
                    chain_.damping[from] * rows(velocity_, layer + r);
            }
        }
        if (order_ == 2) {
            close(acceleration_, {&displacement_, &velocity_});
        }
    }

    double growth() const {
        MatrixXd rates(state_, state_);
        rates << velocity_, acceleration_.middleRows(size_ * slaved_, state_ - size_ * all_);
        return eigenvalues(rates).real().maxCoeff();
    }

  private:
    Eigen::Block<MatrixXd> rows(MatrixXd& matrix, Index layer) const {
        return matrix.block(size_ * layer, 0, size_, state_);
    }

    /// The rows of ghost layers of the highest derivative from those of the lower ones, outwards.
    void close(MatrixXd& highest, const std::vector<const MatrixXd*>& lower) const {
        for (Index ghost = reach_ - 1; ghost >= 0; --ghost) {
            for (const bool left : {true, false}) {
                const Index inwards = left ? 1 : -1;
                const Index layer = left ? ghost : all_ - 1 - ghost;
                for (Index a = 0; a < size_; ++a) {
                    close_ghost(
                        condition_.residual[std::size_t(a)], lower, highest,
                        [&](std::size_t j) { return size_ * (layer + inwards * Index(j)) + a; });
                }
            }
        }
    }

    const LateralChain& chain_;
    const SideCondition& condition_;
    Index size_;  ///< components of a layer
    Index reach_;
    Index all_;
    Index order_;   ///< highest power of D
    Index slaved_;  ///< layers a side whose velocities follow from the state
    Index state_;
    MatrixXd displacement_;
    MatrixXd velocity_;
    MatrixXd acceleration_;
};

}  // namespace

double growth_in_strip(const LateralChain& chain, const SideCondition& condition,
                       std::size_t layers) {
    return Strip(chain, condition, layers).growth();
}

std::vector<double> strip_wave_numbers(std::size_t steps) {
    std::vector<double> all;
    for (std::size_t i = 0; i <= steps; ++i) {
        all.push_back(std::numbers::pi * double(i) / double(steps));
    }
    constexpr int halves = 5;
    for (int i = 1; i <= halves; ++i) {
        all.push_back(std::ldexp(std::numbers::pi / double(steps), -i));
    }
    return all;
}

double largest_growth_in_strip(const PlaneLattice& lattice, const SideCondition& condition,
                               std::size_t layers, std::size_t wave_numbers) {
    double largest = -HUGE_VAL;
    for (const double wave_number : strip_wave_numbers(wave_numbers)) {
        largest = std::max(largest,
                           growth_in_strip(lateral_chain(lattice, wave_number), condition, layers));
    }
    return largest;
}

}  // namespace nmbcgen
