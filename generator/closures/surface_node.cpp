// SPDX-License-Identifier: MIT
#include "generator/closures/surface_node.hpp"

#include <stdexcept>

namespace nmbcgen {

SurfaceNode surface_node(unsigned horizon, bool corrected) {
    if (horizon < 1 || horizon > largest_closure_horizon) {
        throw std::invalid_argument("no such horizon of a closure");
    }
    const auto m = int(horizon);
    SurfaceNode node;
    for (int k = 1; k <= m; ++k) {
        // The cell of the outermost neighbour is cut in half by the horizon; corrected, the half
        // cell around the node itself, which no neighbour has, goes to the nearest ones.
        node.quadrature.emplace_back((k == m ? Rational(1, 2) : Rational(1)) +
                                     (corrected && k == 1 ? Rational(1, 2) : Rational(0)));
        node.ghosts.push_back({2 * k, 1 - 2 * k});
    }
    // (5): the bonds from nodes i to ghosts f, of length k = i + f - 1, bear the traction,
    //     m e = sum beta_k (u_f - u_i)/k^2 = own u_s - sum_i others_i u_i.
    Rational own = 0;
    std::vector<Rational> others(horizon);
    for (int i = 1; i <= m; ++i) {
        for (int f = 1; i + f - 1 <= m; ++f) {
            const int k = i + f - 1;
            const Rational stiffness = node.quadrature[std::size_t(k) - 1] / (k * k);
            const std::vector<Rational>& ghost = node.ghosts[std::size_t(f) - 1];
            own += stiffness * ghost[0];
            others[0] -= stiffness * ghost[1];
            others[std::size_t(i) - 1] += stiffness;
        }
    }
    for (const Rational& other : others) {
        node.row.push_back(other / own);
    }
    node.load = m / own;
    return node;
}

}  // namespace nmbcgen
