// SPDX-License-Identifier: GPL-2.0-or-later
/// What is refused when a boundary or a chain is made, and what is said.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using nmbc::Opposite;
using nmbc::generated::nopd1d_n1_order2;
using nmbc::generated::nopd1d_n2_order1;
using nmbc::generated::nopd1d_n2_order2_s2;
using nmbc::generated::nopd1d_n3_order2_s3;

constexpr double half_G = 0.5;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A loop of one's own over the lattice of nopd1d_n1_order2 at G, to t = 5000 or infinity.
double largest_after(const nmbc::MatchingBoundary& boundary, double time_step) {
    const auto lattice = nmbc::make_lattice(nopd1d_n1_order2, half_G);
    std::vector<double> u(104);
    std::vector<double> v(u.size());
    std::vector<double> a(u.size());
    u[50] = 1;
    double largest = 1;
    for (double t = 0; t < 5000; t += time_step) {
        nmbc::accelerations(lattice, 1, u, a);
        for (std::size_t i = 2; i < 102; ++i) {
            v[i] += time_step * a[i];
        }
        boundary.update(u, v, nmbc::End::left);
        boundary.update(u, v, nmbc::End::right);
        largest = 0;
        for (std::size_t i = 0; i < u.size(); ++i) {
            u[i] += time_step * v[i];
            if (!std::isfinite(u[i])) {
                return infinite;
            }
            largest = std::max(largest, std::abs(u[i]));
        }
    }
    return largest;
}

TEST_CASE("a boundary refuses a step longer than the certified, which blows up") {
    const auto boundary = [](double step, const nmbc::BoundaryCoefficients& coefficients) {
        return nmbc::MatchingBoundary(
            coefficients, {.ghost_layers = 2, .wave_speed = 1, .spacing = 1, .time_step = step});
    };
    const auto certified = nmbc::boundary_coefficients(nopd1d_n1_order2, half_G);
    const auto any = nmbc::boundary_coefficients(nopd1d_n1_order2, half_G, nmbc::allow_unstable);
    CHECK_THROWS_WITH_AS(
        boundary(0.75, certified),
        "a time step of 0.75 is not certified: it may be 0.69 at most, in the units given; take "
        "the coefficients with allow_unstable to run it",
        nmbc::NotCertified);
    CHECK(largest_after(boundary(0.75, any), 0.75) == infinite);
    const double longest = nmbc::stable_time_step(nopd1d_n1_order2, half_G, 1, 1);
    CHECK(longest == doctest::Approx(0.69).scale(0).epsilon(1e-12));
    // Short waves, which hardly move, are what is left.
    CHECK(largest_after(boundary(longest, certified), longest) < 0.1);
}

TEST_CASE("at the edge of a window no step is certified, and the boundary says so") {
    const auto coefficients = nmbc::boundary_coefficients(nmbc::generated::nopd1d_n2_order2, 3.774);
    CHECK_THROWS_WITH_AS(
        nmbc::MatchingBoundary(
            coefficients, {.ghost_layers = 4, .wave_speed = 1, .spacing = 1, .time_step = 1e-6}),
        doctest::Contains("is not certified: none is at this G;"), nmbc::NotCertified);
}

TEST_CASE("the longest step is accepted in all units, and no longer one") {
    const auto coefficients = nmbc::boundary_coefficients(nopd1d_n3_order2_s3, 2);
    for (double c = 1e-3; c < 1e6; c *= 7.3) {
        for (double spacing = 1e-9; spacing < 1e3; spacing *= 11.9) {
            const double longest = nmbc::stable_time_step(nopd1d_n3_order2_s3, 2, c, spacing);
            const auto make = [&](double step) {
                return nmbc::MatchingBoundary(
                    coefficients,
                    {.ghost_layers = 6, .wave_speed = c, .spacing = spacing, .time_step = step});
            };
            CHECK_NOTHROW(make(longest));
            CHECK_NOTHROW(make(longest / 2));
            CHECK_THROWS_AS(make(longest * (1 + 1e-12)), nmbc::NotCertified);
        }
    }
}

template <class Parameters>
concept Positional = requires {
    Parameters{std::size_t(4), 1.0, 1.0, 0.1};
};
template <class Parameters>
concept ByName = requires {
    Parameters{.ghost_layers = 4, .wave_speed = 1.0, .spacing = 1.0, .time_step = 0.1};
};
// Speed and spacing cannot be swapped by their places.
static_assert(ByName<nmbc::BoundaryParameters> && !Positional<nmbc::BoundaryParameters>);

TEST_CASE("a boundary refuses other ghosts than its lattice has") {
    const auto coefficients = nmbc::boundary_coefficients(nopd1d_n2_order1, 1);
    for (const std::size_t ghosts : {1U, 2U, 3U, 5U}) {
        CHECK_THROWS_WITH_AS(
            nmbc::MatchingBoundary(
                coefficients,
                {.ghost_layers = ghosts, .wave_speed = 1, .spacing = 1, .time_step = 0.1}),
            doctest::Contains("ghost layers must be 4, not "), std::invalid_argument);
    }
    CHECK_NOTHROW(nmbc::MatchingBoundary(
        coefficients, {.ghost_layers = 4, .wave_speed = 1, .spacing = 1, .time_step = 0.1}));
    CHECK_THROWS_WITH_AS(nmbc::MatchingBoundary(
                             {{1, 1}, {-2, 2}},
                             {.ghost_layers = 0, .wave_speed = 1, .spacing = 1, .time_step = 0.1}),
                         doctest::Contains("ghost layer"), std::invalid_argument);
    const auto less_than_none = static_cast<std::size_t>(-1);
    CHECK_THROWS_WITH_AS(
        nmbc::MatchingBoundary(
            coefficients,
            {.ghost_layers = less_than_none, .wave_speed = 1, .spacing = 1, .time_step = 0.1}),
        doctest::Contains("not -1"), std::invalid_argument);
    CHECK_THROWS_WITH_AS(
        nmbc::MatchingBoundary(coefficients,
                               {.ghost_layers = 4, .wave_speed = 1, .spacing = 1, .time_step = 0.1},
                               nmbc::GhostRule::explicit_rule),
        doctest::Contains("explicit ghosts have no certificate"), nmbc::NotCertified);
}

TEST_CASE("opposite another end a boundary needs a certificate for any") {
    // Certified to cfl 0.55 with its like, to less than half of it opposite any other end.
    constexpr double contractive = 4;
    const auto& table = nopd1d_n3_order2_s3;
    const auto lattice = nmbc::make_lattice(table, contractive);
    const double like_step = nmbc::stable_time_step(table, contractive, 1, 1);
    const double any_step = nmbc::stable_time_step(table, contractive, 1, 1, Opposite::any);
    const nmbc::ChainEnd like = nmbc::MatchingEnd{nmbc::boundary_coefficients(table, contractive)};
    const nmbc::ChainEnd any =
        nmbc::MatchingEnd{nmbc::boundary_coefficients(table, contractive, Opposite::any)};
    const nmbc::ChainEnd unstable =
        nmbc::MatchingEnd{nmbc::boundary_coefficients(table, contractive, nmbc::allow_unstable)};
    const nmbc::ChainEnd fixed = nmbc::FixedEnd{};
    const auto chain = [&](const nmbc::ChainEnd& left, const nmbc::ChainEnd& right, double step) {
        return nmbc::Chain(lattice, left, right, {.nodes = 50, .time_step = step});
    };
    CHECK_NOTHROW(chain(like, like, like_step));
    CHECK_NOTHROW(chain(fixed, any, any_step));
    CHECK_NOTHROW(chain(any, any, any_step));
    CHECK_NOTHROW(chain(fixed, unstable, like_step));
    for (const auto& [left, right] : {std::pair(fixed, like), {like, fixed}, {like, any}}) {
        CHECK_THROWS_WITH_AS(chain(left, right, any_step), doctest::Contains("with Opposite::any"),
                             nmbc::NotCertified);
    }
    CHECK_THROWS_WITH_AS(chain(fixed, any, like_step), doctest::Contains("is not certified: it"),
                         nmbc::NotCertified);
    // Stable with its like only: no step is certified, and what is instead is named.
    CHECK_THROWS_WITH_AS(
        nmbc::boundary_coefficients(nopd1d_n2_order2_s2, 2.95, Opposite::any,
                                    nmbc::generated::tables),
        doctest::Contains("is not certified to be stable opposite another end than its like at "
                          "G = 2.95; opposite any end NMBC2 with stride 2 is certified for G from"),
        nmbc::NotCertified);
}

TEST_CASE("a chain refuses to be so short that its certificate does not hold") {
    const nmbc::MatchingTable& table = nopd1d_n2_order2_s2;
    const auto lattice = nmbc::make_lattice(table, 1);
    const nmbc::MatchingEnd end{nmbc::boundary_coefficients(table, 1)};
    const auto least = std::size_t(table.least_nodes);
    REQUIRE(least > 15);  // which grow at the upper edge of the window
    const std::string words = "from " + std::to_string(least) + " interior nodes on, and has";
    CHECK_THROWS_WITH_AS(nmbc::Chain(lattice, end, {.nodes = least - 1, .time_step = 0.1}),
                         doctest::Contains(words.c_str()), nmbc::NotCertified);
    CHECK_NOTHROW(nmbc::Chain(lattice, end, {.nodes = least, .time_step = 0.1}));
}

}  // namespace
