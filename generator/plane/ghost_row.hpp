// SPDX-License-Identifier: MIT
/// What a side condition makes of a ghost's displacement, velocity or acceleration, each a row: a
/// linear function of the state.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

/// The ghost's row of the derivative that the residual has the highest power of D of, from the
/// lower ones, 0 first, and from this one of the nodes further in. row_of(j): the row of the node j
/// layers inwards.
template <class RowOf>
void close_ghost(const ShiftPolynomial& residual, const std::vector<const Eigen::MatrixXd*>& lower,
                 Eigen::MatrixXd& highest, RowOf row_of) {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(highest.cols());
    const std::vector<double>& own = residual.back();
    for (std::size_t j = 1; j < own.size(); ++j) {
        sum += own[j] * highest.row(row_of(j));
    }
    for (std::size_t p = 0; p < lower.size(); ++p) {
        for (std::size_t j = 0; j < residual[p].size(); ++j) {
            sum += residual[p][j] * lower[p]->row(row_of(j));
        }
    }
    highest.row(row_of(0)) = -sum / own[0];
}

}  // namespace nmbcgen
