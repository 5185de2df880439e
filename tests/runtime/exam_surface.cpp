// SPDX-License-Identifier: GPL-2.0-or-later
/// True surfaces: mirrors and surface nodes, with a displacement or a traction given in time.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/nopd1d_n2_order1.hpp>
#include <vector>

#include "tests/runtime/edge_chains.hpp"
#include "tests/support/snm_bonds.hpp"

namespace {

using nmbc::Closure;
using nmbc::OnSurface;
using nmbc::SurfaceEnd;
using nmbcgen::test::snm_bonds;

/// In units of their own, so that none is taken for 1.
nmbc::ChainParameters parameters_of(std::size_t nodes, double cfl, const nmbc::Lattice& lattice) {
    nmbc::ChainParameters p{.nodes = nodes, .spacing = 0.5, .youngs_modulus = 8, .density = 2};
    p.time_step = 2 * cfl / nmbc::maximum_frequency(lattice) * p.spacing / p.wave_speed();
    return p;
}

/// X of an entry, from the left surface.
double place_of(const nmbc::Chain& chain, std::size_t entry) {
    return (double(entry) + 0.5 - double(chain.first_interior())) * chain.parameters().spacing;
}

constexpr auto closures = {Closure::mirror, Closure::surface_node};

}  // namespace

TEST_CASE("a mirror makes one half of a longer chain, even for traction and odd for displacement") {
    const nmbc::Lattice lattice = snm_bonds(3);
    constexpr std::size_t nodes = 50;
    for (const auto given : {OnSurface::displacement, OnSurface::traction}) {
        nmbc::Chain half(lattice, SurfaceEnd{.given = given}, nmbc::FreeEnd{},
                         parameters_of(nodes, 0.9, lattice));
        nmbc::Chain whole(lattice, nmbc::FreeEnd{}, parameters_of(2 * nodes, 0.9, lattice));
        const double sign = given == OnSurface::traction ? 1 : -1;
        std::vector<double> u(half.nodes());
        std::vector<double> v(half.nodes());
        std::vector<double> whole_u(whole.nodes());
        std::vector<double> whole_v(whole.nodes());
        for (std::size_t i = 0; i < nodes; ++i) {
            const auto place = double(i);
            const std::size_t entry = half.ghosts() + i;
            const std::size_t right = whole.ghosts() + nodes + i;
            const std::size_t left = whole.ghosts() + nodes - 1 - i;
            u[entry] = whole_u[right] = std::sin(place * place);
            v[entry] = whole_v[right] = std::cos(place * place);
            whole_u[left] = sign * u[entry];
            whole_v[left] = sign * v[entry];
        }
        half.start(u, v);
        whole.start(whole_u, whole_v);
        half.advance(1000);
        whole.advance(1000);
        for (std::size_t i = 0; i < nodes; ++i) {
            const double difference = half.displacement()[half.ghosts() + i] -
                                      whole.displacement()[whole.ghosts() + nodes + i];
            // Roundings of 1000 steps, which add up as waves meet again and again.
            CHECK(std::abs(difference) < 1e-12);
        }
    }
}

TEST_CASE("a mirror through a node makes one half of a longer chain, too") {
    const nmbc::Lattice lattice = snm_bonds(3);
    constexpr std::size_t nodes = 50;
    for (const auto given : {OnSurface::displacement, OnSurface::traction}) {
        nmbc::Chain half(lattice, SurfaceEnd{Closure::node_mirror, given, {}}, nmbc::FreeEnd{},
                         parameters_of(nodes, 0.9, lattice));
        nmbc::Chain whole(lattice, nmbc::FreeEnd{}, parameters_of(2 * nodes - 1, 0.9, lattice));
        const double sign = given == OnSurface::traction ? 1 : -1;
        std::vector<double> u(half.nodes());
        std::vector<double> whole_u(whole.nodes());
        for (std::size_t i = given == OnSurface::traction ? 0 : 1; i < nodes; ++i) {
            u[half.ghosts() + i] = std::sin(double(i * i + 1));
            whole_u[whole.ghosts() + nodes - 1 + i] = u[half.ghosts() + i];
            whole_u[whole.ghosts() + nodes - 1 - i] = (i == 0 ? 1 : sign) * u[half.ghosts() + i];
        }
        half.start(u, std::vector<double>(u.size()));
        whole.start(whole_u, std::vector<double>(whole_u.size()));
        half.advance(1000);
        whole.advance(1000);
        for (std::size_t i = 0; i < nodes; ++i) {
            const double difference = half.displacement()[half.ghosts() + i] -
                                      whole.displacement()[whole.ghosts() + nodes - 1 + i];
            CHECK(std::abs(difference) < 1e-12);  // as above
        }
    }
}

TEST_CASE("a body between mirrors keeps its energy while nothing is given") {
    std::vector<nmbc::Lattice> lattices = lattices_of_bonds();
    lattices.push_back(nmbc::make_lattice(nmbc::generated::nopd1d_n2_order1, 1));
    const SurfaceEnd unlike{Closure::node_mirror, OnSurface::traction, {}};
    for (const nmbc::Lattice& lattice : lattices) {
        for (const auto closure : {Closure::mirror, Closure::node_mirror}) {
            for (const auto given : {OnSurface::displacement, OnSurface::traction}) {
                nmbc::Chain chain(lattice, SurfaceEnd{closure, given, {}}, unlike,
                                  parameters_of(30, 0.5, lattice));
                std::vector<double> u(chain.nodes());
                std::vector<double> v(chain.nodes());
                for (std::size_t i = 0; i < u.size(); ++i) {
                    u[i] = std::sin(double(i * i));
                    v[i] = std::cos(double(i * i));
                }
                chain.start(u, v);
                const double start = nmbc::energies(chain).staggered;
                for (int row = 0; row < 10; ++row) {
                    chain.advance(100);
                    // Roundings of a thousand steps.
                    CHECK(nmbc::energies(chain).staggered == doctest::Approx(start).epsilon(1e-12));
                }
            }
        }
    }
}

TEST_CASE("under no traction a mirror is a free end") {
    const nmbc::Lattice lattice = snm_bonds(2);
    const auto p = parameters_of(30, 0.9, lattice);
    nmbc::Chain mirror(lattice, SurfaceEnd{}, p);
    nmbc::Chain free(lattice, nmbc::FreeEnd{}, p);
    for (nmbc::Chain* chain : {&mirror, &free}) {
        chain->displacement()[10] = 1;
        chain->advance(500);
    }
    for (std::size_t i = 0; i < free.nodes(); ++i) {
        CHECK(std::abs(mirror.displacement()[i] - free.displacement()[i]) < 1e-13);
    }
}

TEST_CASE("a bar under a constant strain stays as it is, between a displacement and a traction") {
    constexpr double strain = 0.25;
    for (const std::size_t horizon : {1U, 2U, 3U, 7U}) {
        const nmbc::Lattice lattice = snm_bonds(horizon);
        for (const Closure closure : closures) {
            CAPTURE(horizon);
            const auto p = parameters_of(40, 0.5, lattice);
            const auto constant = [](double value) { return [value](double) { return value; }; };
            nmbc::Chain chain(
                lattice, SurfaceEnd{closure, OnSurface::displacement, constant(1.5)},
                SurfaceEnd{closure, OnSurface::traction, constant(p.youngs_modulus * strain)}, p);
            std::vector<double> u(chain.nodes());
            for (std::size_t i = 0; i < u.size(); ++i) {
                u[i] = 1.5 + strain * place_of(chain, i);
            }
            chain.start(u, std::vector<double>(u.size()));
            chain.advance(2000);
            for (std::size_t i = 0; i < u.size(); ++i) {
                CHECK(std::abs(chain.displacement()[i] - u[i]) < 1e-12);
            }
        }
    }
}

TEST_CASE("a traction pulls the left end the way it points") {
    const nmbc::Lattice lattice = snm_bonds(2);
    for (const Closure closure : closures) {
        nmbc::Chain chain(lattice,
                          SurfaceEnd{closure, OnSurface::traction, [](double) { return -1.0; }},
                          nmbc::FreeEnd{}, parameters_of(40, 0.5, lattice));
        chain.advance(10);
        CHECK(chain.displacement()[chain.first_interior()] < 0);
    }
}

TEST_CASE("fields written between two steps meet the surface as it is then") {
    const nmbc::Lattice lattice = snm_bonds(2);
    const SurfaceEnd moving{Closure::mirror, OnSurface::displacement,
                            [](double time) { return time * time; }};
    const auto p = parameters_of(40, 0.5, lattice);
    nmbc::Chain written(lattice, moving, nmbc::FreeEnd{}, p);
    nmbc::Chain left_alone(lattice, moving, nmbc::FreeEnd{}, p);
    for (int step = 0; step < 100; ++step) {
        written.displacement()[20] += 0;
        written.step();
        left_alone.step();
    }
    for (std::size_t i = 0; i < written.nodes(); ++i) {
        CHECK(std::abs(written.displacement()[i] - left_alone.displacement()[i]) <
              1e-12 * written.time() * written.time());
    }
}

namespace {

/// The largest error of a wave that a surface sends in, u = g(t - X/c), g a Gaussian of so many
/// dX/c, by a displacement g or a traction rho c g'.
double error_of_wave(Closure closure, OnSurface given, double width) {
    const nmbc::Lattice lattice = snm_bonds(3);
    const auto p = parameters_of(std::size_t(24 * width), 0.3, lattice);
    const double c = p.wave_speed();
    const double middle = 6 * width * p.spacing / c;
    const auto g = [&](double t) {
        const double s = (t - middle) * c / (width * p.spacing);
        return std::exp(-s * s);
    };
    const auto slope = [&](double t) {
        const double s = (t - middle) * c / (width * p.spacing);
        return -2 * s * c / (width * p.spacing) * std::exp(-s * s);
    };
    const auto value = [&](double t) {
        return given == OnSurface::displacement ? g(t) : p.density * c * slope(t);
    };
    nmbc::Chain chain(lattice, SurfaceEnd{closure, given, value}, nmbc::FixedEnd{}, p);
    double error = 0;
    while (chain.time() < 2.5 * middle) {
        chain.step();
        for (std::size_t i = chain.first_interior(); i + chain.ghosts() < chain.nodes(); ++i) {
            error = std::max(error, std::abs(chain.displacement()[i] -
                                             g(chain.time() - place_of(chain, i) / c)));
        }
    }
    return error;
}

}  // namespace

TEST_CASE("what is given in time goes in as a wave, to second order in dX") {
    for (const Closure closure : closures) {
        for (const auto given : {OnSurface::displacement, OnSurface::traction}) {
            CAPTURE(int(closure));
            CAPTURE(int(given));
            const double coarse = error_of_wave(closure, given, 20);
            const double fine = error_of_wave(closure, given, 40);
            CHECK(coarse < 0.03);
            CHECK(coarse / fine > 3.5);
        }
    }
}

TEST_CASE("in the longest steps that a surface node allows nothing grows") {
    for (const std::size_t horizon : {1U, 2U, 3U, 5U, 10U}) {
        const nmbc::Lattice lattice = snm_bonds(horizon);
        for (const auto given : {OnSurface::displacement, OnSurface::traction}) {
            const std::size_t nodes = 3 * horizon + 5;
            auto p = parameters_of(nodes, 0.5, lattice);
            const double unit = p.spacing / p.wave_speed();
            const double longest =
                2 /
                std::sqrt(nmbc::largest_eigenvalue(lattice, Closure::surface_node, given, nodes)) *
                unit;
            p.time_step = longest * (1 - 1e-12);
            const SurfaceEnd end{Closure::surface_node, given, {}};
            nmbc::Chain chain(lattice, end, p);
            std::vector<double> u(chain.nodes());
            std::vector<double> v(chain.nodes());
            for (std::size_t i = 0; i < u.size(); ++i) {
                u[i] = std::sin(double(i * i));
            }
            chain.start(u, v);
            chain.advance(100000);
            // Between free surfaces the mean displacement stays; the rest swings.
            double largest = 0;
            for (int step = 0; step < 1000; ++step) {
                chain.step();
                largest = std::max(largest, std::abs(chain.displacement()[chain.ghosts()]));
            }
            CHECK(largest < 20);

            p.time_step = longest * (1 + 1e-6);
            CHECK_THROWS_AS(nmbc::Chain(lattice, end, p), nmbc::NotCertified);
        }
    }
}

TEST_CASE("lattices that a surface node does not end") {
    nmbc::Lattice damped = snm_bonds(2);
    damped.damping = {2, -1};
    const SurfaceEnd end{Closure::surface_node, OnSurface::displacement, {}};
    CHECK_THROWS_AS(nmbc::Chain(damped, end, parameters_of(20, 0.3, damped)),
                    std::invalid_argument);
    nmbc::Lattice slack = snm_bonds(2);
    slack.symbol = {0, 0, 0};
    const nmbc::ChainParameters p{.nodes = 20, .time_step = 0.1};
    const SurfaceEnd loaded{Closure::surface_node, OnSurface::traction, {}};
    CHECK_THROWS_AS(nmbc::Chain(slack, loaded, p), std::invalid_argument);
    const nmbc::ChainParameters few{.nodes = 1, .time_step = 0.1};
    CHECK_THROWS_AS(nmbc::Chain(snm_bonds(2), SurfaceEnd{}, few), std::invalid_argument);
}
