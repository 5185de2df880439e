// SPDX-License-Identifier: MIT
/// A bar in one dimension that is nonlocal here and local there (Seleson 2011, part IV): linear
/// elements, each with a horizon and a stiffness of its own.
///
/// A point x of an element pulls at x' within its horizon delta with
///     c(x', x) (u(x') - u(x)),   c = 2k/(delta^2 |x' - x|),
/// which has the energy k u'^2/2 of the local bar wherever u is linear. delta = 0 is the local bar.
#pragma once

#include <vector>

#include "generator/table/exact.hpp"

namespace nmbcgen {

struct Medium {
    Rational stiffness = 1;  ///< k [force], > 0
    Rational horizon = 0;    ///< delta [length], >= 0
};

struct Mesh {
    std::vector<Rational> nodes;  ///< x [length], ascending
    std::vector<Medium> media;    ///< of the elements between them: one fewer

    Rational length(std::size_t element) const { return nodes[element + 1] - nodes[element]; }
};

/// Two uniform bars that meet at x = 0, as many elements on either side.
struct Halves {
    Rational left_length = 1;  ///< h of an element
    Rational right_length = 1;
    Medium left;
    Medium right;
};

Mesh mesh_of(const Halves& halves, std::size_t left_elements, std::size_t right_elements);

}  // namespace nmbcgen
