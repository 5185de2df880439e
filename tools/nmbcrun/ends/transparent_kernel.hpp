// SPDX-License-Identifier: MIT
/// The kernel of the discrete transparent boundary: how a half line of the lattice follows the
/// nodes next to it, level by level, in the very scheme that the chain is stepped by.
#pragma once

#include <cstddef>
#include <nmbc/lattice.hpp>
#include <vector>

namespace nmbcrun {

/// Let nodes 1, 2, .. be at rest up to level 0. At every level k > 0, r the lattice's reach,
///     u_e^k = sum_{i=1}^r sum_{m=1}^k kernel[i-1][m] u_{e-i}^{k-m},
/// for each of them from the r nodes next to it. Row by row that is the convolution
/// u_ghost^k = sum_m K_m u_int^{k-m} of r ghosts with r x r matrices K_m, without storing these.
///
/// lambda^e z^k solves leapfrog where the symmetric Laurent polynomial
///     (z - 2 + 1/z) / courant^2 + sum_{|m|<=r} (symbol_m + damping_m (1 - 1/z) / courant) lambda^m
/// vanishes. For |z| > 1 r of its roots are within the unit circle, and lambda^r -
/// sum_i kernel_i(z) lambda^{r-i} is the polynomial with these roots; kernel[i-1][m] is its
/// coefficient of z^-m, found by a sum over points of a circle |z| > 1.
///
/// courant: c dt / dX. Entries 0 .. steps; entry 0 is 0, since leapfrog is explicit.
/// They are right to about the last bit: the errors of a row of 101 add up to less than 5e-15
/// (tests/tools/exam_exact_kernel.cpp).
/// Throws std::invalid_argument where courant is not positive and finite, the damping reaches
/// further than the symbol, leapfrog is not stable in such steps, or the sum's own check, entry 0,
/// fails.
std::vector<std::vector<double>> transparent_kernel(const nmbc::Lattice& lattice, double courant,
                                                    std::size_t steps);

}  // namespace nmbcrun
