// SPDX-License-Identifier: MIT
/// Waves of a bond-based square lattice, in doubles.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "generator/table/vector_model.hpp"

namespace nmbcgen {

/// All bonds that the square lattice's symmetries make of (i, j, 0), i >= j >= 0, each once.
std::vector<Offset> members_of_class(const Offset& bond);

/// Of two rows and columns.
struct SymmetricMatrix {
    double xx = 0;
    double xy = 0;
    double yy = 0;

    /// The larger eigenvalue, and the other one.
    std::array<double, 2> eigenvalues() const;
};

/// The dynamical matrix D = sum over bonds b of w b b^T (1 - cos k.b), w one weight for each class.
class BondLattice {
  public:
    BondLattice(std::span<const Offset> classes, std::span<const double> weights);

    SymmetricMatrix at(double k_x, double k_y) const;

    /// D/k^2 of long waves in this direction, in the limit.
    SymmetricMatrix of_long_waves(double radians) const;

    /// The least omega^2/k^2: of long waves at 129 angles, and of wave vectors in steps of pi/128.
    double least_squared_speed() const;

  private:
    std::vector<std::array<double, 3>> bonds_{};  // weight, i, j
};

}  // namespace nmbcgen
