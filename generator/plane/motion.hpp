// SPDX-License-Identifier: MIT
/// What a lattice and the conditions on its ghosts make of a state: its derivative, or the state a
/// leapfrog step later.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

namespace nmbcgen {

/// A row: a component of the displacement of a node or ghost. Its order: 0 where forces move it, 1
/// and 2 where a condition does whose highest power of D is that.
struct MotionRows {
    std::vector<int> orders;
    bool is_damped = false;  ///< forces are of velocities, too, those of ghosts among them
    double time_step = 0;    ///< 0: continuous time

    Eigen::Index size() const { return Eigen::Index(orders.size()); }
};

/// Linear functions of the state, a row each.
struct MotionFields {
    Eigen::MatrixXd displacement;
    Eigen::MatrixXd velocity;  ///< in steps, half a step before the displacement
    Eigen::MatrixXd acceleration;
};

/// The rows of ghosts of this order of the derivative with this number, from the lower ones and
/// from those of it that forces move.
using CloseGhosts = std::function<void(int order, const std::vector<const Eigen::MatrixXd*>& lower,
                                       Eigen::MatrixXd& highest)>;

/// The state: displacements of all rows, and velocities of those where they are no function of it.
class Motion {
  public:
    /// accelerate(fields): forces, in the rows of order 0. close is of the residuals in continuous
    /// time, or of at_midpoints().
    Motion(const MotionRows& rows, const std::function<void(MotionFields&)>& accelerate,
           const CloseGhosts& close);

    Eigen::Index state_size() const {
        return of_displacement_.rows() + Eigen::Index(moving_.size());
    }

    /// A row's mirror image, and the sign of its entry in a motion of this parity.
    struct Image {
        Eigen::Index row;
        double sign;
    };
    using Mirror = std::function<Image(Eigen::Index row)>;

    /// The map of the whole state.
    Eigen::MatrixXd map() const;

    /// The map of motions that a mirror leaves as they are. mirror() sends every row to one of a
    /// part, whose rows it sends to themselves; rows that have to be at rest to themselves with
    /// sign 0.
    Eigen::MatrixXd map(const Mirror& mirror) const;

  private:
    Eigen::Index row_of(Eigen::Index entry) const;
    double image_of(Eigen::Index entry, Eigen::Index column) const;

    std::vector<Eigen::Index> moving_;          ///< rows whose velocities are part of the state
    std::vector<Eigen::Index> velocity_entry_;  ///< of a row's velocity in the state; or -1
    Eigen::MatrixXd of_displacement_;           ///< what becomes of these rows
    Eigen::MatrixXd of_velocity_;
};

}  // namespace nmbcgen
