// SPDX-License-Identifier: GPL-2.0-or-later
/// A million steps between true ends: nothing grows, whatever the closure.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/snm_bonds.hpp"

namespace {

using nmbc::Closure;
using nmbc::OnSurface;
using nmbcgen::test::snm_bonds;

nmbc::Lattice correspondence(int horizon, double G) {
    return nmbc::make_lattice(*nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1, 1),
                              G);
}

/// Of the influence 1, whose cubic spline has radius 2.
nmbc::Lattice spline() {
    return correspondence(1, 0.5);
}

/// max |u| in the last tenth of a million steps over that in the first, from a start at rest.
double growth(const nmbc::Lattice& lattice, Closure left, Closure right, OnSurface given) {
    constexpr std::size_t nodes = 41;
    nmbc::ChainParameters p{.nodes = nodes};
    double largest = 0;
    for (const Closure closure : {left, right}) {
        for (const OnSurface each : {given, OnSurface::traction}) {
            largest = std::max(largest, nmbc::largest_eigenvalue(lattice, closure, each, nodes));
        }
    }
    p.time_step = 2 * (1 - 1e-9) / std::sqrt(largest);
    nmbc::Chain chain(lattice, nmbc::SurfaceEnd{left, given, {}},
                      nmbc::SurfaceEnd{right, OnSurface::traction, {}}, p);
    std::vector<double> u(chain.nodes());
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = std::sin(double(i * i));
    }
    chain.start(u, std::vector<double>(u.size()));
    std::vector<double> tenths(10);
    for (double& tenth : tenths) {
        for (int look = 0; look < 10000; ++look) {
            chain.advance(10);
            for (std::size_t i = 0; i < nodes; ++i) {
                tenth = std::max(
                    tenth,
                    std::abs(std::as_const(chain).displacement()[chain.first_interior() + i]));
            }
        }
    }
    return tenths.back() / tenths.front();
}

}  // namespace

TEST_CASE("a million steps between true ends of either kind") {
    struct Case {
        std::string name{};
        nmbc::Lattice lattice{};
        Closure left = Closure::mirror;
        Closure right = Closure::mirror;
    };
    for (const Case& one :
         {Case{"mirror", correspondence(2, 1), Closure::mirror, Closure::mirror},
          Case{"mirror, bonds", snm_bonds(4), Closure::mirror, Closure::mirror},
          Case{"node mirror", correspondence(2, 1), Closure::node_mirror, Closure::node_mirror},
          Case{"surface node", snm_bonds(4), Closure::surface_node, Closure::surface_node},
          Case{"sbp", correspondence(2, 1), Closure::sbp, Closure::sbp},
          Case{"sbp, n = 3, G = 0", correspondence(3, 0), Closure::sbp, Closure::sbp},
          Case{"sbp and mirror", correspondence(2, 1), Closure::sbp, Closure::mirror},
          Case{"kernel", spline(), Closure::kernel, Closure::kernel},
          Case{"cut", correspondence(2, 1), Closure::cut, Closure::cut},
          Case{"cut, bonds", snm_bonds(4), Closure::cut, Closure::cut}}) {
        for (const auto given : {OnSurface::displacement, OnSurface::traction}) {
            CAPTURE(one.name);
            // As many waves meet again and again: their highest sums in a tenth differ by some
            // per cent; what grew by 1e-6 a step would be e^0.9 higher.
            CHECK(growth(one.lattice, one.left, one.right, given) < 1.3);
        }
    }
}
