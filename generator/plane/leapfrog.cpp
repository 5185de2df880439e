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
    // Where D is the highest power, the mean of u over two levels is u + dt v/2, v between them.
    // Where D^2 is, means of two such means, at the middle one of three levels: u + dt^2 a/4 and,
    // beside the older v, v + dt a/2.
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
