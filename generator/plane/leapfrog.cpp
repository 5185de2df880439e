// SPDX-License-Identifier: MIT
#include "generator/plane/leapfrog.hpp"

#include <algorithm>
#include <cmath>

namespace nmbcgen {

std::complex<double> rate_at_side(double omega, double time_step) {
    const double half_turn = omega * time_step / 2;
    return {0, omega / std::sqrt(1 - half_turn * half_turn)};
}

ShiftPolynomial at_midpoints(ShiftPolynomial residual, double time_step) {
    // With a = (new v - v)/dt, means over the old and the new level are u + dt^2 a/4 and v + dt a/2
    // where a is the highest; with the new v, u + dt v/2.
    double factor = 1;
    for (std::size_t p = residual.size() - 1; p-- > 0;) {
        factor *= time_step / 2;
        residual.back().resize(std::max(residual.back().size(), residual[p].size()));
        for (std::size_t j = 0; j < residual[p].size(); ++j) {
            residual.back()[j] += factor * residual[p][j];
        }
    }
    return residual;
}

double largest_growth(const Eigen::VectorXcd& eigenvalues, double time_step) {
    return time_step == 0 ? eigenvalues.real().maxCoeff()
                          : std::log(eigenvalues.cwiseAbs().maxCoeff()) / time_step;
}

}  // namespace nmbcgen
