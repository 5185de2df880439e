// SPDX-License-Identifier: GPL-2.0-or-later
/// How stiff true ends on the outermost node are.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/nmbc.hpp>
#include <vector>

#include "generator/dense/decompositions.hpp"
#include "tests/runtime/edge_chains.hpp"

namespace {

using nmbc::Closure;
using nmbc::OnSurface;

/// The largest eigenvalue of M^-1 K between like ends, column by column from the forces.
double eigenvalue_between(const nmbc::EdgeEnergy& edge, const nmbc::Lattice& lattice,
                          OnSurface given, std::size_t nodes) {
    const std::size_t held = given == OnSurface::displacement ? 1 : 0;
    const auto size = Eigen::Index(nodes - 2 * held);
    Eigen::MatrixXd matrix(size, size);
    for (Eigen::Index column = 0; column < size; ++column) {
        std::vector<double> u(nodes);
        u[std::size_t(column) + held] = 1;
        const std::vector<double> force = nmbc::detail::between_edges(edge, lattice, u);
        for (Eigen::Index row = 0; row < size; ++row) {
            matrix(row, column) = force[std::size_t(row) + held];
        }
    }
    return nmbcgen::eigenvalues(matrix).real().maxCoeff();
}

}  // namespace

TEST_CASE("the largest eigenvalue between true ends is a bound, 1 % above it") {
    constexpr std::size_t nodes = 31;  // an odd number: modes even and odd about the middle
    for (const Closure closure : {Closure::sbp, Closure::kernel, Closure::cut}) {
        for (const nmbc::Lattice& lattice : lattices_for(closure)) {
            for (const auto given : {OnSurface::displacement, OnSurface::traction}) {
                CAPTURE(int(closure));
                CAPTURE(lattice.reach());
                CAPTURE(lattice.energy.size());
                const double bound = nmbc::largest_eigenvalue(lattice, closure, given, nodes);
                const double largest =
                    eigenvalue_between(nmbc::detail::closure_edge(closure, lattice),
                                       nmbc::with_mirror_images(lattice), given, nodes);
                CHECK(largest <= bound * (1 + 1e-13));
                // Of the interior the bound is for chains of any length.
                const double top = std::pow(nmbc::maximum_frequency(lattice), 2);
                CHECK(bound < 1.0101 * std::max(largest, top));
            }
        }
    }
}
