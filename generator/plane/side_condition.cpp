// SPDX-License-Identifier: MIT
#include "generator/plane/side_condition.hpp"

namespace nmbcgen {

ShiftPolynomial product(const ShiftPolynomial& one, const ShiftPolynomial& other) {
    const std::size_t shifts = one.front().size() + other.front().size() - 1;
    ShiftPolynomial result(one.size() + other.size() - 1, std::vector<double>(shifts));
    for (std::size_t p = 0; p < one.size(); ++p) {
        for (std::size_t q = 0; q < other.size(); ++q) {
            for (std::size_t i = 0; i < one[p].size(); ++i) {
                for (std::size_t j = 0; j < other[q].size(); ++j) {
                    result[p + q][i + j] += one[p][i] * other[q][j];
                }
            }
        }
    }
    return result;
}

ShiftPolynomial absorbs(double speed, double shift) {
    return {{shift + 2 * speed, shift - 2 * speed}, {1, 1}};
}

ShiftPolynomial matching_residual(const std::vector<double>& c, const std::vector<double>& b,
                                  std::size_t stride, double speed) {
    const std::vector<double> none(stride * (c.size() - 1) + 1);
    ShiftPolynomial residual{none, none};
    for (std::size_t j = 0; j < c.size(); ++j) {
        residual[0][stride * j] = -speed * b[j];
        residual[1][stride * j] = c[j];
    }
    return residual;
}

SideCondition published_condition(const PlaneLattice& lattice) {
    return {{absorbs(lattice.speed_P), absorbs(lattice.speed_P)}};
}

SideCondition polarisation_wise_condition(const PlaneLattice& lattice) {
    return {{absorbs(lattice.speed_P), absorbs(lattice.speed_S)}};
}

SideCondition higdon_condition(const PlaneLattice& lattice, double shift) {
    const ShiftPolynomial both =
        product(absorbs(lattice.speed_P, shift), absorbs(lattice.speed_S, shift));
    return {{both, both}};
}

SideCondition fixed_condition() {
    return {{ShiftPolynomial{{0}, {1}}, ShiftPolynomial{{0}, {1}}}};
}

}  // namespace nmbcgen
