// SPDX-License-Identifier: GPL-2.0-or-later
/// The fully discrete chain: largest cfl, against known values and against the runtime itself.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/chain.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/tables/nopd1d_n2_order3.hpp>

#include "generator/pipeline.hpp"
#include "generator/stability/discrete.hpp"

namespace {

using nmbcgen::Rational;

nmbcgen::HalfSpace half_space(unsigned horizon, unsigned order, unsigned stride,
                              const Rational& G) {
    return make_half_space(nmbcgen::derive({"nopd1d", horizon, order, stride, std::nullopt}), G);
}

TEST_CASE("largest cfl") {
    struct Known {
        unsigned horizon, order, stride;
        Rational G;
        double cfl;
    };
    const Rational half = Rational(1) / 2;
    // Found before by assembled spectra of 21 to 100 nodes, within .01.
    for (const Known& known :
         {Known{1, 1, 1, half, .98}, Known{1, 2, 1, half, .70}, Known{1, 3, 1, half, .50},
          Known{1, 4, 1, half, .38}, Known{2, 1, 1, 1, .82}, Known{2, 2, 2, 1, .74},
          Known{3, 1, 1, 0, .60}}) {
        const auto h = half_space(known.horizon, known.order, known.stride, known.G);
        CAPTURE(known.horizon);
        CAPTURE(known.order);
        CHECK(std::abs(stable_range(h).largest - known.cfl) < 0.0101);
    }
    // Its edge is cfl 0.5 itself, (dt/2)^2 = 1/16, where a mode neither grows nor dies.
    CHECK(stable_range(half_space(1, 3, 1, half)).largest == 0.49);
}

/// One step of a chain from a rough state, ghosts included, by the map and by the runtime.
void compare_step(const nmbcgen::LatticeEnd& left, const nmbcgen::LatticeEnd& right,
                  nmbc::Chain chain) {
    const auto& p = chain.parameters();
    const auto map = nmbcgen::one_step_map(left, right, p.nodes, p.time_step);
    Eigen::VectorXd state(map.cols());
    for (Eigen::Index i = 0; i < state.size(); ++i) {
        state(i) = std::sin(1.7 * double(i * i));
    }
    const auto all = std::size_t(chain.nodes());
    for (std::size_t i = 0; i < all; ++i) {
        chain.displacement()[i] = state(Eigen::Index(i));
        chain.velocity()[i] = state(Eigen::Index(all + i));
    }
    chain.step();
    const Eigen::VectorXd after = map * state;
    for (std::size_t i = 0; i < all; ++i) {
        // Coefficients up to 20, a cascade of 4 ghost layers: some thousand roundings.
        CHECK(chain.displacement()[i] ==
              doctest::Approx(after(Eigen::Index(i))).scale(100).epsilon(1e-13));
        CHECK(chain.velocity()[i] ==
              doctest::Approx(after(Eigen::Index(all + i))).scale(100).epsilon(1e-13));
    }
}

TEST_CASE("the map is the runtime's step, whatever the ends") {
    constexpr double G = 1.85;
    const auto& table = nmbc::generated::nopd1d_n2_order3;
    const auto h = half_space(2, 3, 1, Rational(G));
    const std::vector<std::pair<nmbcgen::LatticeEnd, nmbc::ChainEnd>> ends{
        {{nmbcgen::LatticeEnd::Kind::matching, h},
         nmbc::MatchingEnd{nmbc::boundary_coefficients(table, G, nmbc::allow_unstable)}},
        {fixed_end(h), nmbc::FixedEnd{}},
        {free_end(h), nmbc::FreeEnd{}}};
    for (const auto& left : ends) {
        for (const auto& right : ends) {
            compare_step(left.first, right.first,
                         nmbc::Chain(nmbc::make_lattice(table, G), left.second, right.second,
                                     {.nodes = 12, .time_step = 0.3}));
        }
    }
}

}  // namespace
