// SPDX-License-Identifier: GPL-2.0-or-later
/// A matching boundary that is made for a chain closes a plane, line by line, and the steps of a
/// chain are those of a plane.
#include <doctest/doctest.h>

#include <algorithm>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <random>
#include <vector>

namespace {

using nmbc::End;

template <class Real>
std::vector<Real> random_field(std::size_t nodes, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<Real> normal;
    std::vector<Real> values(nodes);
    std::ranges::generate(values, [&] { return normal(random); });
    return values;
}

/// The entries of a row-major field on the line with this x (axis 1) or y (axis 0), in ascending
/// order of the other one.
template <class Real>
std::vector<Real> line_of(const std::vector<Real>& field, const nmbc::Grid& grid, std::size_t axis,
                          std::size_t number) {
    std::vector<Real> line;
    for (std::size_t i = 0; i < (axis == 0 ? grid.nx : grid.ny); ++i) {
        line.push_back(axis == 0 ? field[number * grid.nx + i] : field[i * grid.nx + number]);
    }
    return line;
}

TEST_CASE_TEMPLATE("lines of a plane normal to its four sides are closed as a chain, bit for bit",
                   Real, double, float) {
    constexpr nmbc::Grid grid{.nx = 31, .ny = 27};
    for (const auto* table : nmbc::generated::tables) {
        auto coefficients = nmbc::boundary_coefficients(*table, 0.37, nmbc::allow_unstable);
        coefficients.matched_time_step = 0;
        const nmbc::BasicMatchingBoundary<Real> boundary(coefficients,
                                                         {.ghost_layers = table->ghost_layers(),
                                                          .wave_speed = 2,
                                                          .spacing = 0.3,
                                                          .time_step = 0.01});
        if (boundary.reach() > grid.ny) {
            continue;
        }
        CAPTURE(table->name);
        const auto u = random_field<Real>(grid.nx * grid.ny, 1);
        const auto before = random_field<Real>(grid.nx * grid.ny, 2);
        for (const std::size_t axis : {0U, 1U}) {
            for (const auto end : {End::left, End::right}) {
                auto v = before;
                const std::size_t lines = axis == 0 ? grid.ny : grid.nx;
                for (std::size_t line = 0; line < lines; ++line) {
                    const nmbc::Side side{axis, end};
                    boundary.update(nmbc::NodeLine<const Real>(u, grid, side, line),
                                    nmbc::NodeLine<Real>(v, grid, side, line));
                }
                for (std::size_t line = 0; line < lines; ++line) {
                    auto chain = line_of(before, grid, axis, line);
                    boundary.update(line_of(u, grid, axis, line), chain, end);
                    CHECK(line_of(v, grid, axis, line) == chain);
                }
            }
        }
    }
}

TEST_CASE("a line of one component among several at each node") {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", 2, 2);
    REQUIRE(table != nullptr);
    const nmbc::MatchingBoundary boundary(
        nmbc::boundary_coefficients(*table, 0.37, nmbc::allow_unstable),
        {.ghost_layers = table->ghost_layers(),
         .wave_speed = 2,
         .spacing = 0.3,
         .time_step = 0.01});
    const auto u = random_field<double>(40, 1);  // 20 nodes of 2
    const auto before = random_field<double>(40, 2);
    auto v = before;
    boundary.update({&u[38], -2}, {&v[38], -2});
    auto chain = line_of(before, {2, 20}, 1, 0);
    boundary.update(line_of(u, {2, 20}, 1, 0), chain, End::right);
    CHECK(line_of(v, {2, 20}, 1, 0) == chain);
    CHECK(line_of(v, {2, 20}, 1, 1) == line_of(before, {2, 20}, 1, 1));
}

/// Lines of nodes side by side that do not know of each other, each a chain along the axis.
struct TwoFields {
    nmbc::Grid grid;
    std::size_t axis;
    const nmbc::detail::Kick<double>& force;
    const nmbc::MatchingBoundary& boundary;
    double time_step;
    std::vector<double> u;
    std::vector<double> v;

    std::size_t lines() const { return axis == 0 ? grid.ny : grid.nx; }

    void kick() {
        for (std::size_t line = 0; line < lines(); ++line) {
            auto velocities = line_of(v, grid, axis, line);
            force.kick(line_of(u, grid, axis, line), velocities);
            const nmbc::NodeLine<double> into(v, grid, {axis, End::left}, line);
            for (std::size_t i = 0; i < velocities.size(); ++i) {
                into[i] = velocities[i];
            }
        }
    }
    void close_sides() {
        for (const auto end : {End::left, End::right}) {
            for (std::size_t line = 0; line < lines(); ++line) {
                const nmbc::Side side{axis, end};
                boundary.update({std::span<const double>(u), grid, side, line},
                                {std::span(v), grid, side, line});
            }
        }
    }
    void drift() { nmbc::detail::drift<double>(time_step, u, v); }
    void drift_and_kick() {
        drift();
        kick();
    }
};

TEST_CASE("a plane of chains side by side, stepped as a plane, is those chains, bit for bit") {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", 2, 1);
    REQUIRE(table != nullptr);
    constexpr double G = 1;
    constexpr double time_step = 0.3;
    const auto lattice = nmbc::make_lattice(*table, G);
    const auto coefficients = nmbc::boundary_coefficients(*table, G);
    const nmbc::MatchingBoundary boundary(
        coefficients,
        {.ghost_layers = lattice.reach(), .wave_speed = 1, .spacing = 1, .time_step = time_step});
    const auto force = nmbc::detail::make_kick<double>(lattice.symbol, -time_step);
    for (const std::size_t axis : {0U, 1U}) {
        const nmbc::Grid grid = axis == 0 ? nmbc::Grid{48, 3} : nmbc::Grid{3, 48};
        TwoFields plane{grid,
                        axis,
                        *force,
                        boundary,
                        time_step,
                        random_field<double>(std::size_t{48} * 3, 1),
                        random_field<double>(std::size_t{48} * 3, 2)};
        const TwoFields before = plane;
        nmbc::detail::advance(plane, 50);
        for (std::size_t line = 0; line < plane.lines(); ++line) {
            nmbc::Chain chain(lattice, nmbc::MatchingEnd{coefficients},
                              {.nodes = 40, .time_step = time_step});
            std::ranges::copy(line_of(before.u, grid, axis, line), chain.displacement().begin());
            std::ranges::copy(line_of(before.v, grid, axis, line), chain.velocity().begin());
            chain.advance(50);
            CHECK(std::ranges::equal(line_of(plane.u, grid, axis, line), chain.displacement()));
            CHECK(std::ranges::equal(line_of(plane.v, grid, axis, line), chain.velocity()));
        }
    }
}

}  // namespace
