// SPDX-License-Identifier: GPL-2.0-or-later
/// A million steps between true ends: nothing grows, whatever the closure.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <numeric>
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

/// Of a cubic spline of radius 3 dX, which convex kernels continue: weights 15, 2; G = 0.
nmbc::Lattice spline() {
    constexpr double shape = 2 * (15 + 4 * 2);
    const std::vector<double> strain{-4 / shape, -15 / shape, 0, 15 / shape, 4 / shape};
    nmbc::Lattice lattice;
    lattice.energy.push_back({nmbc::EnergyPart::strain, 1, strain});
    for (std::size_t m = 0; m < strain.size(); ++m) {
        lattice.symbol.push_back(std::inner_product(strain.begin() + std::ptrdiff_t(m),
                                                    strain.end(), strain.begin(), 0.0));
    }
    return lattice;
}

struct Ends {
    Closure left = Closure::mirror;
    Closure right = Closure::mirror;
    OnSurface left_given = OnSurface::traction;
    OnSurface right_given = OnSurface::traction;
};

/// The rate [1/step] at which the root mean square of u grows from the first tenth of a million
/// steps to the last, from a start at rest.
double growth(const nmbc::Lattice& lattice, const Ends& ends) {
    constexpr std::size_t nodes = 41;
    nmbc::ChainParameters p{.nodes = nodes};
    p.time_step =
        2 * (1 - 1e-9) /
        std::sqrt(std::max(nmbc::largest_eigenvalue(lattice, ends.left, ends.left_given, nodes),
                           nmbc::largest_eigenvalue(lattice, ends.right, ends.right_given, nodes)));
    nmbc::Chain chain(lattice, nmbc::SurfaceEnd{ends.left, ends.left_given, {}},
                      nmbc::SurfaceEnd{ends.right, ends.right_given, {}}, p);
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
                const double own = std::as_const(chain).displacement()[chain.first_interior() + i];
                tenth += own * own;
            }
        }
    }
    return std::log(tenths.back() / tenths.front()) / 2 / 9e5;
}

struct Body {
    std::string name{};
    nmbc::Lattice lattice{};
    std::vector<Closure> closures{};
};

std::vector<Body> bodies() {
    const std::vector<Closure> of_strains{Closure::mirror, Closure::node_mirror, Closure::sbp,
                                          Closure::cut};
    std::vector<Closure> of_spline = of_strains;
    of_spline.push_back(Closure::kernel);
    const std::vector<Closure> of_bonds{Closure::mirror, Closure::node_mirror,
                                        Closure::surface_node, Closure::sbp, Closure::cut};
    return {{"n = 2, G = 0", correspondence(2, 0), of_strains},
            {"n = 2, G = 1", correspondence(2, 1), of_strains},
            {"n = 3, G = 0", correspondence(3, 0), of_strains},
            {"n = 3, G = 4", correspondence(3, 4), of_strains},
            {"15, 2, G = 0", spline(), of_spline},
            {"bonds, m = 4", snm_bonds(4), of_bonds}};
}

std::string name_of(Closure closure) {
    switch (closure) {
        case Closure::mirror:
            return "mirror";
        case Closure::surface_node:
            return "snm";
        case Closure::sbp:
            return "sbp";
        case Closure::kernel:
            return "kernel";
        case Closure::cut:
            return "cut";
        case Closure::node_mirror:
            break;
    }
    return "node_mirror";
}

}  // namespace

// With -s the rates of all pairs are printed: docs/evidence/closures.md has the largest.
TEST_CASE("a million steps between true ends of any two kinds") {
    constexpr auto u = OnSurface::displacement;
    constexpr auto t = OnSurface::traction;
    for (const Body& body : bodies()) {
        const std::vector<Closure>& closures = body.closures;
        for (std::size_t i = 0; i < closures.size(); ++i) {
            for (std::size_t j = i; j < closures.size(); ++j) {
                const Closure one = closures[i];
                const Closure other = closures[j];
                double largest = -1;
                for (const Ends& ends : {Ends{one, other, u, u}, Ends{one, other, t, t},
                                         Ends{one, other, u, t}, Ends{one, other, t, u}}) {
                    largest = std::max(largest, growth(body.lattice, ends));
                }
                CAPTURE(body.name);
                CAPTURE(name_of(one));
                CAPTURE(name_of(other));
                // As many waves meet again and again the mean of a tenth differs by some 3e-3.
                CHECK(largest < 1e-8);
            }
        }
    }
}
