// SPDX-License-Identifier: GPL-2.0-or-later
/// What a certificate does not cover: a chain so short that waves which decay from one end still
/// matter at the other. A half space knows travelling waves of the other end only.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/certificate.hpp>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/energy.hpp>

#include "generator/pipeline.hpp"
#include "generator/stability/certify.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/least_nodes.hpp"
#include "tests/stability/boundary.hpp"
#include "tests/stability/spectra.hpp"

namespace {

using nmbcgen::test::Boundary;
using nmbcgen::test::spectral_abscissa;

TEST_CASE("inside a window chains grow up to some length, and none above it") {
    struct Case {
        Boundary boundary;
        nmbc::Grade grade;
        std::size_t longest;  ///< that grows; 0: none does
    };
    constexpr auto contractive = nmbc::Grade::contractive;
    // As found; the nearer to an edge, the longer.
    for (const Case& each : {
             Case{{1, 2, 1, 0.3}, contractive, 0},
             Case{{1, 4, 1, 0.3}, contractive, 4},
             Case{{2, 2, 2, 2.9}, contractive, 5},
             Case{{2, 3, 2, 1}, contractive, 6},
             Case{{2, 3, 2, 0.8609}, contractive, 16},
             Case{{3, 2, 3, 3}, contractive, 0},
             Case{{3, 2, 3, 4.54}, nmbc::Grade::paired, 15},
             Case{{3, 3, 3, 2.39}, contractive, 9},
             Case{{3, 3, 3, 1.8532}, contractive, 25},
         }) {
        const Boundary& boundary = each.boundary;
        CAPTURE(boundary.horizon);
        CAPTURE(boundary.order);
        CAPTURE(boundary.G);
        CHECK(certified_grade(committed_table(boundary), boundary.G) == each.grade);
        const auto h = half_space(boundary);
        constexpr double roundings = 1e-11;  // of eigenvalues: 2e-12 at most was found
        std::size_t longest = 0;
        for (std::size_t nodes = std::size_t(boundary.order) * boundary.stride; nodes <= 60;
             ++nodes) {
            if (spectral_abscissa(h, nodes) > roundings) {
                longest = nodes;
            }
        }
        CHECK(longest == each.longest);
    }
}

TEST_CASE("at horizon 5 chains of up to 46 nodes grow in certified steps, and none of 47 to 60") {
    const auto h = make_half_space(
        nmbcgen::derive({.horizon = 5, .order = 2, .stride = 5, .stabilisation = {}}),
        nmbcgen::Rational(103, 34));
    const nmbcgen::LatticeEnd end{nmbcgen::LatticeEnd::Kind::matching, h};
    constexpr double cfl = 0.46;
    std::size_t longest = 0;
    for (std::size_t nodes = 40; nodes <= 60; ++nodes) {
        constexpr double roundings = 1e-9;
        const double largest = spectral_radius(end, nodes, 2 * cfl / maximum_frequency(h));
        longest = largest > 1 + roundings ? nodes : longest;
    }
    CHECK(longest == 46);
}

TEST_CASE("a certificate holds from a length on from which none grows") {
    for (const nmbcgen::Specification& what :
         {nmbcgen::Specification{
              .horizon = 5, .order = 2, .stride = 5, .stabilisation = nmbcgen::Rational(103, 34)},
          nmbcgen::Specification{
              .horizon = 2, .order = 2, .stride = 2, .stabilisation = nmbcgen::Rational(29, 10)}}) {
        const nmbcgen::Table table = nmbcgen::derive(what);
        const auto h = make_half_space(table, *what.stabilisation);
        const nmbcgen::LatticeEnd end{nmbcgen::LatticeEnd::Kind::matching, h};
        const auto certificate = nmbcgen::certify(table);
        CAPTURE(what.horizon);
        REQUIRE(certificate.max_cfl.size() == 1);
        CHECK(certificate.least_nodes > (what.horizon == 5 ? 46 : 5));
        const double step = 2 * certificate.max_cfl[0].cfl / maximum_frequency(h);
        for (std::size_t more = 0; more < 12; ++more) {
            constexpr double roundings = 1e-9;
            CHECK(spectral_radius(end, certificate.least_nodes + more, step) < 1 + roundings);
        }
    }
}

/// 6 nodes grow there by 4.5e-3 and 5e-4 a step.
TEST_CASE("nor does one where a piece of the certified steps begins") {
    for (const double G : {1.9046, 1.8489}) {
        CAPTURE(G);
        const Boundary boundary{2, 3, 1, G};
        const auto& table = committed_table(boundary);
        const auto h = half_space(boundary);
        const nmbcgen::LatticeEnd end{nmbcgen::LatticeEnd::Kind::matching, h};
        const double step = 2 * nmbc::certified_cfl(table, G) / maximum_frequency(h);
        CHECK(spectral_radius(end, 6, step) > 1 + 1e-4);
        for (std::size_t nodes = table.least_nodes; nodes < 40U; ++nodes) {
            CAPTURE(nodes);
            constexpr double roundings = 1e-9;
            CHECK(spectral_radius(end, nodes, step) < 1 + roundings);
        }
    }
}

TEST_CASE("roundings do not make chains of a large G grow") {
    const nmbcgen::Rational G = 1000;
    const auto h = make_half_space(
        nmbcgen::derive({.horizon = 1, .order = 5, .stride = 1, .stabilisation = G}), G);
    const nmbcgen::LatticeEnd end{nmbcgen::LatticeEnd::Kind::matching, h};
    for (const double cfl : {0.05, 0.5, 0.99}) {
        for (std::size_t nodes = 6; nodes <= 96; nodes *= 2) {
            CAPTURE(cfl);
            CAPTURE(nodes);
            constexpr double roundings = 1e-8;  // as least_nodes() has it
            CHECK(spectral_radius(end, nodes, 2 * cfl / maximum_frequency(h)) < 1 + roundings);
        }
    }
}

TEST_CASE("where doubles do not tell the waves apart there is no certificate" *
          doctest::test_suite("long")) {
    CHECK_THROWS_AS(
        nmbcgen::certify(nmbcgen::derive(
            {.horizon = 1, .order = 5, .stride = 1, .stabilisation = nmbcgen::Rational(10000)})),
        nmbcgen::NotCertifiable);
}

TEST_CASE("the runtime's short chain grows so, and a longer one does not") {
    const Boundary boundary{3, 3, 3, 2};
    const auto& table = committed_table(boundary);
    const auto lattice = nmbc::make_lattice(table, boundary.G);
    const double cfl = 0.5 * nmbc::certified_cfl(table, boundary.G);
    REQUIRE(cfl > 0);
    const auto growth = [&](std::size_t nodes, double time) {
        nmbc::Chain chain(
            lattice,
            nmbc::MatchingEnd{nmbc::boundary_coefficients(table, boundary.G, nmbc::allow_unstable)},
            {.nodes = nodes, .time_step = 2 * cfl / maximum_frequency(lattice)});
        // Neither even nor odd, some of every wave.
        for (std::size_t node = 0; node < chain.nodes(); ++node) {
            chain.displacement()[node] = std::sin(double(node * node));
        }
        while (chain.time() < time) {
            chain.step();
        }
        const double half_way = nmbc::energies(chain).total();
        while (chain.time() < 2 * time) {
            chain.step();
        }
        return std::log(nmbc::energies(chain).total() / half_way) / (2 * time);
    };
    const double predicted = spectral_abscissa(half_space(boundary), 9);
    REQUIRE(predicted > 1e-3);
    // exp(40) until the fit begins leaves no other wave; the energy of a wave that grows swings by
    // a factor of order 1 in exp(40), and the time step is not 0.
    CHECK(growth(9, 20 / predicted) == nmbcgen::test::relative(predicted, 0.05));
    CHECK(growth(40, 20 / predicted) < 0);
}

}  // namespace
