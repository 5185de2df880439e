// SPDX-License-Identifier: MIT
/// What the place where two bars meet makes of a wave: the waves of either bar, matched by the
/// equations of motion of the nodes between. Density 1, masses on the nodes.
#pragma once

#include "generator/coupling/mesh.hpp"
#include "generator/coupling/pair_matrix.hpp"
#include "generator/plane/plane_modes.hpp"

namespace nmbcgen {

/// Of the energy of the wave that arrives.
struct Scattering {
    double reflected = 0;
    double transmitted = 0;
};

/// Nodes of a uniform bar, in units of its element's length.
LateralChain bar_chain(const Rational& length, const Medium& medium);

class Junction {
  public:
    Junction(const Halves& halves, CouplingForm form);

    /// Of a wave from the left with wave number xi in 1/h of the left elements, 0 < xi < pi. Throws
    /// std::domain_error where waves cannot be told, as at the edge of a band.
    Scattering from_left(double xi) const;

  private:
    struct Bar {
        LateralChain chain;
        Eigen::Index reach = 0;  ///< nodes
        Eigen::Index own = 0;    ///< nodes up to where rows are those of the uniform bar
        double length = 0;       ///< of an element
    };

    static Bar bar_of(const Rational& length, const Medium& medium, const Rational& farthest);

    Bar left_;
    Bar right_;
    Eigen::MatrixXd rows_;  ///< M^-1 K of nodes -own .. own, columns a reach more at either side
};

}  // namespace nmbcgen
