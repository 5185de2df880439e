// SPDX-License-Identifier: MIT
#include "generator/plane/motion.hpp"

#include <utility>

namespace nmbcgen {

using Eigen::Index;
using Eigen::MatrixXd;

Motion::Motion(const MotionRows& rows, const std::function<void(MotionFields&)>& accelerate,
               const CloseGhosts& close)
    : velocity_entry_(rows.orders.size(), -1) {
    const double dt = rows.time_step;
    const Index all = rows.size();
    for (Index row = 0; row < all; ++row) {
        // In steps the velocity of half a step before is needed where damping acts on it.
        const bool follows =
            rows.orders[std::size_t(row)] == 1 && !(rows.time_step > 0 && rows.is_damped);
        if (!follows) {
            velocity_entry_[std::size_t(row)] = all + Index(moving_.size());
            moving_.push_back(row);
        }
    }
    const Index state = all + Index(moving_.size());
    MotionFields now{.displacement = MatrixXd::Identity(all, state),
                     .velocity = MatrixXd::Zero(all, state),
                     .acceleration = MatrixXd::Zero(all, state)};
    for (const Index row : moving_) {
        now.velocity(row, velocity_entry_[std::size_t(row)]) = 1;
    }
    if (dt == 0) {
        close(1, {&now.displacement}, now.velocity);
    }
    accelerate(now);
    close(2, {&now.displacement, &now.velocity}, now.acceleration);
    if (dt == 0) {
        of_displacement_ = std::move(now.velocity);
        of_velocity_ = std::move(now.acceleration);
        return;
    }
    of_velocity_ = now.velocity + dt * now.acceleration;
    close(1, {&now.displacement}, of_velocity_);
    of_displacement_ = now.displacement + dt * of_velocity_;
}

Index Motion::row_of(Index entry) const {
    const Index all = of_displacement_.rows();
    return entry < all ? entry : moving_[std::size_t(entry - all)];
}

double Motion::image_of(Index entry, Index column) const {
    const MatrixXd& image = entry < of_displacement_.rows() ? of_displacement_ : of_velocity_;
    return image(row_of(entry), column);
}

MatrixXd Motion::map() const {
    MatrixXd map(state_size(), state_size());
    for (Index entry = 0; entry < state_size(); ++entry) {
        for (Index column = 0; column < state_size(); ++column) {
            map(entry, column) = image_of(entry, column);
        }
    }
    return map;
}

MatrixXd Motion::map(const Mirror& mirror) const {
    std::vector<Index> part;
    std::vector<Index> place(std::size_t(state_size()), -1);
    for (Index entry = 0; entry < state_size(); ++entry) {
        const Image image = mirror(row_of(entry));
        if (image.row == row_of(entry) && image.sign != 0) {
            place[std::size_t(entry)] = Index(part.size());
            part.push_back(entry);
        }
    }
    MatrixXd map = MatrixXd::Zero(Index(part.size()), Index(part.size()));
    for (Index entry = 0; entry < state_size(); ++entry) {
        const Image image = mirror(row_of(entry));
        if (image.sign == 0) {
            continue;
        }
        const Index mirrored =
            entry < of_displacement_.rows() ? image.row : velocity_entry_[std::size_t(image.row)];
        const Index column = place[std::size_t(mirrored)];
        for (Index k = 0; k < map.rows(); ++k) {
            map(k, column) += image.sign * image_of(part[std::size_t(k)], entry);
        }
    }
    return map;
}

}  // namespace nmbcgen
