// SPDX-License-Identifier: GPL-2.0-or-later
/// True ends on the outermost node: summation by parts, convex kernels (Wu 2015), the plain cut.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/nmbc.hpp>
#include <utility>
#include <vector>

#include "tests/runtime/edge_chains.hpp"

namespace {

using nmbc::Closure;
using nmbc::OnSurface;
using nmbc::SurfaceEnd;

/// X of an entry, from the left surface.
double place(const nmbc::Chain& chain, std::size_t entry) {
    return (double(entry) - double(chain.first_interior())) * chain.parameters().spacing;
}

/// The largest departure from an even strain of 1/4 in 2000 steps between a displacement and the
/// traction of that strain, over the largest displacement.
double failure_of_patch(const nmbc::Lattice& lattice, Closure closure) {
    constexpr double strain = 0.25;
    const auto p = parameters_of(40, closure, lattice);
    const auto constant = [](double value) { return [value](double) { return value; }; };
    nmbc::Chain chain(lattice, SurfaceEnd{closure, OnSurface::displacement, constant(1.5)},
                      SurfaceEnd{closure, OnSurface::traction, constant(p.youngs_modulus * strain)},
                      p);
    std::vector<double> u(chain.nodes());
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = 1.5 + strain * place(chain, i);
    }
    chain.start(u, std::vector<double>(u.size()));
    chain.advance(2000);
    double failure = 0;
    const std::size_t end = chain.first_interior() + p.nodes;
    for (std::size_t i = chain.first_interior(); i < end; ++i) {
        failure = std::max(failure, std::abs(std::as_const(chain).displacement()[i] - u[i]));
    }
    return failure / u[end - 1];
}

void start_anyhow(nmbc::Chain& chain) {
    std::vector<double> u(chain.nodes());
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = std::sin(double(i * i));
    }
    chain.start(u, std::vector<double>(u.size()));
}

}  // namespace

TEST_CASE("summation by parts passes the patch test, as mirrors do, whatever G is") {
    for (int horizon = 1; horizon <= 5; ++horizon) {
        for (const double G : {0.0, 0.3, 1.0, 4.0}) {
            CAPTURE(horizon);
            CAPTURE(G);
            CHECK(failure_of_patch(constant_influence(horizon, G), Closure::sbp) < 1e-12);
            CHECK(failure_of_patch(constant_influence(horizon, G), Closure::node_mirror) < 1e-12);
        }
    }
    CHECK(failure_of_patch(spline_lattice(), Closure::sbp) < 1e-12);
    for (const nmbc::Lattice& lattice : lattices_of_bonds()) {
        CAPTURE(lattice.energy.size());
        CHECK(failure_of_patch(lattice, Closure::sbp) < 1e-12);
    }
}

TEST_CASE("a plain cut and convex kernels do not pass it") {
    CHECK(failure_of_patch(constant_influence(2, 0), Closure::cut) > 0.01);
    CHECK(failure_of_patch(bonds_of({1, 5, 0, 2}), Closure::cut) > 0.01);
    CHECK(failure_of_patch(spline_lattice(), Closure::cut) > 0.01);
    CHECK(failure_of_patch(spline_lattice(), Closure::kernel) > 0.01);
}

TEST_CASE("convex kernels: partition of unity, (20), and the force at the end, (25)") {
    for (const std::size_t n : {1U, 2U, 3U, 5U}) {
        const std::size_t nodes = 4 * n + 3;
        const auto psi = nmbc::detail::convex_kernels(n, nodes);
        for (std::size_t at = 0; at + n < nodes; ++at) {
            double sum = 0;
            double moment = 0;
            for (std::size_t node = 0; node < nodes; ++node) {
                CHECK(psi[node * nodes + at] >= 0);
                sum += psi[node * nodes + at];
                moment += psi[node * nodes + at] * double(node);
            }
            CHECK(std::abs(sum - 1) < 1e-12);
            CHECK(std::abs(moment - double(at)) < 1e-12);
            CHECK(psi[at] == doctest::Approx(at == 0 ? 1 : at == 1 ? psi[1] : 0));
        }
    }
    // Forces of an even strain of 1, of which node 0 has the stress itself.
    const nmbc::Lattice lattice = spline_lattice();
    const auto K = nmbc::detail::stiffness_of(nmbc::kernel_edge(lattice), lattice);
    std::vector<double> force(K.rows);
    for (std::size_t row = 0; row < K.rows; ++row) {
        for (std::size_t column = 0; column < K.columns; ++column) {
            force[row] -= K.entries[row * K.columns + column] * double(column);
        }
    }
    constexpr double digits = 5e-3;
    CHECK(std::abs(force[0] - 1) < 1e-12);
    CHECK(std::abs(force[1] - 0.06) < digits);
    CHECK(std::abs(force[2] - 0.22) < digits);
    CHECK(std::abs(force[3] + 0.15) < digits);
}

TEST_CASE("the energy is kept, between unlike ends, too") {
    for (const Closure closure : {Closure::sbp, Closure::kernel, Closure::cut}) {
        for (const nmbc::Lattice& lattice : lattices_for(closure)) {
            for (const auto given : {OnSurface::displacement, OnSurface::traction}) {
                CAPTURE(int(closure));
                CAPTURE(lattice.reach());
                CAPTURE(lattice.energy.size());
                const auto p = parameters_of(30, closure, lattice);
                nmbc::Chain chain(lattice, SurfaceEnd{closure, given, {}},
                                  SurfaceEnd{closure, OnSurface::traction, {}}, p);
                start_anyhow(chain);
                const double start = nmbc::energies(chain).staggered;
                double drift = 0;
                for (int step = 0; step < 2000; ++step) {
                    chain.step();
                    drift = std::max(drift, std::abs(nmbc::energies(chain).staggered / start - 1));
                }
                CHECK(drift < 1e-12);  // 2000 steps of roundings
                CHECK(nmbc::energies(chain, 0, 3).kinetic + nmbc::energies(chain, 3, 30).kinetic ==
                      doctest::Approx(nmbc::energies(chain).kinetic).epsilon(1e-13));
            }
        }
    }
}

TEST_CASE(
    "a square has no sign: the strain of an edge is the lattice's, whichever way it is written") {
    nmbc::Lattice turned = spline_lattice();
    for (double& entry : turned.energy[0].stencil) {
        entry = -entry;
    }
    for (const Closure closure : {Closure::sbp, Closure::cut}) {
        const auto edge = nmbc::detail::closure_edge(closure, spline_lattice());
        const auto other = nmbc::detail::closure_edge(closure, turned);
        REQUIRE(edge.squares.size() == other.squares.size());
        for (std::size_t i = 0; i < edge.squares.size(); ++i) {
            CHECK(edge.squares[i].stencil == other.squares[i].stencil);
        }
    }
}

TEST_CASE("wherever a bond is counted, half of it is at each of its ends") {
    const nmbc::Lattice near = bonds_of({1, 0.5});
    const nmbc::Lattice far = bonds_of({1, 0.5}, Counted::far);
    nmbc::Lattice more;  // on one side than on the other, in one order and the other
    for (const double back : {0.25, 0.75}) {
        more = near;
        for (std::size_t i = 0; i < near.energy.size(); ++i) {
            more.energy[i].weight = near.energy[i].weight * (1 - back);
            more.energy.push_back(far.energy[i]);
            more.energy.back().weight *= back;
        }
        for (const nmbc::Lattice& lattice : {near, far, more}) {
            const nmbc::Lattice whole = nmbc::with_mirror_images(lattice);
            for (const auto& [part, weight, stencil] : near.energy) {
                const std::size_t k = stencil.size() / 2;
                double forth = 0;
                double both = 0;
                for (const nmbc::Lattice::Square& square : whole.energy) {
                    if (square.stencil.size() == stencil.size()) {
                        both += square.weight;
                        forth += square.stencil[2 * k] != 0 ? square.weight : 0;
                    }
                }
                CHECK(both == doctest::Approx(weight).epsilon(1e-15));
                CHECK(forth == doctest::Approx(weight / 2).epsilon(1e-15));
            }
        }
    }
}

TEST_CASE("stabilisation that is counted on one side has the edges of one that is on both") {
    const nmbc::Lattice both = constant_influence(2, 1);
    nmbc::Lattice one_sided = both;
    std::vector<nmbc::Lattice::Square> kept;
    for (nmbc::Lattice::Square square : both.energy) {
        const bool has_image_before =
            std::ranges::any_of(kept, [&](const nmbc::Lattice::Square& other) {
                return nmbc::detail::is_image(square, {other.part, square.weight, other.stencil},
                                              1) ||
                       nmbc::detail::is_image(square, {other.part, square.weight, other.stencil},
                                              -1);
            });
        if (square.part == nmbc::EnergyPart::strain) {
            kept.push_back(square);
        } else if (!has_image_before) {
            square.weight *= 2;
            kept.push_back(square);
        }
    }
    REQUIRE(kept.size() < both.energy.size());
    one_sided.energy = kept;
    for (const Closure closure : {Closure::sbp, Closure::cut}) {
        const auto bound = [&](const nmbc::Lattice& lattice) {
            return nmbc::largest_eigenvalue(lattice, closure, OnSurface::traction, 30);
        };
        CHECK(bound(one_sided) == doctest::Approx(bound(both)).epsilon(1e-12));
    }
}

TEST_CASE("the strain of nopd1d at n = 1 is no bond from I - 1 to I + 1") {
    const nmbc::EdgeEnergy edge = nmbc::cut_edge(constant_influence(1, 0));
    REQUIRE(edge.squares.size() == 1);
    CHECK(edge.squares[0].stencil == std::vector<double>{-1, 1});
}

TEST_CASE("a bar of bonds that is cut has no bonds beyond, at either end") {
    const nmbc::Lattice bonds = bonds_of({1, 0.25});  // 1/2 and 1/8
    const nmbc::ChainParameters p{.nodes = 12, .time_step = 0.5};
    nmbc::Chain chain(bonds, SurfaceEnd{.closure = Closure::cut}, p);
    std::vector<double> u(chain.nodes());
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = place(chain, i);
    }
    chain.start(u, std::vector<double>(u.size()));
    chain.step();
    for (std::size_t i = 0; i < p.nodes; ++i) {
        // Of an even strain of 1, a bond k has the force w_k k.
        const std::size_t depth = std::min(i, p.nodes - 1 - i);
        const double missing = (depth == 0 ? 0.5 : 0.0) + (depth < 2 ? 0.25 : 0.0);
        const double sign = i < 6 ? 1 : -1;
        CHECK(std::as_const(chain).velocity()[chain.first_interior() + i] ==
              doctest::Approx(sign * missing * 0.25).epsilon(1e-13));  // half a step
    }
}

TEST_CASE("a surface that moves far takes the bar with it, without roundings of the way") {
    const nmbc::Lattice lattice = constant_influence(2, 1);
    const auto p = parameters_of(40, Closure::sbp, lattice);
    nmbc::Chain chain(lattice, SurfaceEnd{.closure = Closure::sbp}, p);
    std::vector<double> far(chain.nodes(), 1e9);
    chain.start(far, std::vector<double>(far.size()));
    chain.advance(1000);
    for (std::size_t i = 0; i < far.size(); ++i) {
        CHECK(std::as_const(chain).displacement()[i] == 1e9);
    }
}

TEST_CASE("what is given in time goes in as a wave, to second order in dX") {
    for (const nmbc::Lattice& lattice : {constant_influence(2, 1), bonds_of({1, 0.5})}) {
        for (const auto given : {OnSurface::displacement, OnSurface::traction}) {
            CAPTURE(lattice.energy.size());
            CAPTURE(int(given));
            std::vector<double> errors;
            for (const double width : {20.0, 40.0}) {
                auto p = parameters_of(std::size_t(24 * width), Closure::sbp, lattice);
                const double c = p.wave_speed();
                const double unit = width * p.spacing / c;
                const auto g = [=](double t) { return std::exp(-std::pow(t / unit - 6, 2)); };
                const auto value = [=](double t) {
                    const double slope = -2 * (t / unit - 6) / unit * g(t);
                    return given == OnSurface::displacement ? g(t) : p.density * c * slope;
                };
                nmbc::Chain chain(lattice, SurfaceEnd{Closure::sbp, given, value}, nmbc::FixedEnd{},
                                  p);
                double error = 0;
                while (chain.time() < 15 * unit) {
                    chain.step();
                    for (std::size_t i = chain.first_interior(); i + chain.ghosts() < chain.nodes();
                         ++i) {
                        error = std::max(error, std::abs(std::as_const(chain).displacement()[i] -
                                                         g(chain.time() - place(chain, i) / c)));
                    }
                }
                errors.push_back(error);
            }
            CHECK(errors[0] < 0.02);
            CHECK(errors[0] / errors[1] > 3.5);
        }
    }
}
