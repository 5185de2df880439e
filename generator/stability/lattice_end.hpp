// SPDX-License-Identifier: MIT
/// What a lattice can end in. The nodes next to an end are counted inwards, j = 0 the outermost
/// interior one; its ghost layers, as many as the stencil reaches, are j = -1, -2, ..
///     matching   s C(k) = B(k) on every ghost layer, (60)
///     fixed      u_j = 0 on every ghost layer
///     free       u_{-1-j} = u_j: the mirror image, the mirror midway between the outermost
///                interior node and the innermost ghost
/// A fixed and a free end conserve energy: the stiffness that they leave to the interior nodes,
/// symbol_{i-j} without the ghosts' columns, or plus symbol_{i+j+1}, is symmetric.
#pragma once

#include "generator/stability/half_space.hpp"

namespace nmbcgen {

struct LatticeEnd {
    enum class Kind { matching, fixed, free };

    Kind kind = Kind::matching;
    HalfSpace half_space{};  ///< the lattice and its condition; fixed and free: C = 1, B = 0
};

/// A fixed or free end of the lattice that a half space is made of. C = 1, B = 0 is what a fixed
/// end is, v = 0; a free one does not use it, but is to have no zeros of C and B either.
LatticeEnd fixed_end(const HalfSpace& lattice);
LatticeEnd free_end(const HalfSpace& lattice);

}  // namespace nmbcgen
