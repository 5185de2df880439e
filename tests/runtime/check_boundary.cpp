// SPDX-License-Identifier: GPL-2.0-or-later
/// The boundary's update, against (60) itself.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/boundary.hpp>
#include <nmbc/tables/tables.hpp>
#include <random>

namespace {

std::vector<double> random_values(std::size_t count, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    std::vector<double> values(count);
    for (double& value : values) {
        value = normal(random);
    }
    return values;
}

/// The largest residual of (60) over the ghost layers of one end, relative to its terms; u_time
/// is u at the time level of the rule.
double worst_residual(const nmbc::BoundaryCoefficients& table, std::size_t layers, double rate,
                      const std::vector<double>& u_time, const std::vector<double>& v,
                      nmbc::End end) {
    double worst = 0;
    for (std::size_t layer = 0; layer < layers; ++layer) {
        double sum = 0;
        double size = 0;
        for (std::size_t j = 0; j < table.c.size(); ++j) {
            const std::size_t inwards = layer + j * std::size_t(table.stride);
            const std::size_t node = end == nmbc::End::left ? inwards : v.size() - 1 - inwards;
            const double velocity_term = table.c[j] * v[node];
            const double displacement_term = rate * table.b[j] * u_time[node];
            sum += velocity_term - displacement_term;
            size += std::abs(velocity_term) + std::abs(displacement_term);
        }
        worst = std::max(worst, std::abs(sum) / size);
    }
    return worst;
}

TEST_CASE("after an update, (60) holds in every ghost layer at the rule's time level") {
    constexpr double wave_speed = 7.5;
    constexpr double spacing = 0.3;
    constexpr double time_step = 0.01;
    std::mt19937_64 random(60);
    for (const auto* table : nmbc::generated::tables) {
        // Whatever stride the table was made for: (60) is an identity in the coefficients.
        for (const int stride : {1, 2}) {
            auto coefficients = nmbc::boundary_coefficients(*table, 0.37, nmbc::allow_unstable);
            coefficients.stride = stride;
            coefficients.matched_time_step = 0;  // and in whatever steps
            for (const auto rule : {nmbc::GhostRule::midpoint, nmbc::GhostRule::explicit_rule}) {
                CAPTURE(table->name);
                const nmbc::MatchingBoundary boundary(coefficients,
                                                      {.ghost_layers = table->ghost_layers(),
                                                       .wave_speed = wave_speed,
                                                       .spacing = spacing,
                                                       .time_step = time_step},
                                                      rule);
                const std::size_t nodes = 2 * boundary.reach();
                const auto u = random_values(nodes, random);
                auto v = random_values(nodes, random);
                const auto before = v;
                boundary.update(u, v, nmbc::End::left);
                boundary.update(u, v, nmbc::End::right);

                auto u_time = u;
                if (rule == nmbc::GhostRule::midpoint) {
                    for (std::size_t i = 0; i < nodes; ++i) {
                        u_time[i] += time_step / 2 * v[i];
                    }
                }
                for (const auto end : {nmbc::End::left, nmbc::End::right}) {
                    // Some 4N roundings of terms of mixed sign, scaled by the division: 100 eps.
                    CHECK(worst_residual(coefficients, table->ghost_layers(), wave_speed / spacing,
                                         u_time, v, end) < 100 * 2.2e-16);
                }
                for (std::size_t i = table->ghost_layers(); i < nodes - table->ghost_layers();
                     ++i) {
                    CHECK(v[i] == before[i]);  // interior nodes are not touched
                }
            }
        }
    }
}

TEST_CASE("left and right are mirror images, bit for bit") {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", 3, 4);
    REQUIRE(table != nullptr);
    const nmbc::MatchingBoundary boundary(
        nmbc::boundary_coefficients(*table, 0.8, nmbc::allow_unstable),
        {.ghost_layers = table->ghost_layers(), .wave_speed = 1, .spacing = 1, .time_step = 0.1});
    std::mt19937_64 random(2);
    auto u = random_values(40, random);
    auto v = random_values(40, random);
    auto mirrored_u = std::vector<double>(u.rbegin(), u.rend());
    auto mirrored_v = std::vector<double>(v.rbegin(), v.rend());
    boundary.update(u, v, nmbc::End::left);
    boundary.update(mirrored_u, mirrored_v, nmbc::End::right);
    CHECK(std::vector<double>(mirrored_v.rbegin(), mirrored_v.rend()) == v);
}

TEST_CASE("wrong parameters are refused") {
    const nmbc::BoundaryCoefficients nmbc1{{1, 1}, {-2, 2}, 1};
    CHECK_THROWS_AS(nmbc::MatchingBoundary(
                        nmbc1, {.ghost_layers = 2, .wave_speed = 0, .spacing = 1, .time_step = 1}),
                    std::invalid_argument);
    CHECK_THROWS_AS(nmbc::MatchingBoundary(
                        nmbc1, {.ghost_layers = 2, .wave_speed = 1, .spacing = -1, .time_step = 1}),
                    std::invalid_argument);
    CHECK_THROWS_AS(
        nmbc::MatchingBoundary(
            nmbc1, {.ghost_layers = 2, .wave_speed = 1, .spacing = 1, .time_step = std::nan("")}),
        std::invalid_argument);
    // 1 - (dt/2) b_0 = 0
    CHECK_THROWS_AS(
        nmbc::MatchingBoundary({{1, 1}, {2, -2}, 1},
                               {.ghost_layers = 2, .wave_speed = 1, .spacing = 1, .time_step = 1}),
        std::invalid_argument);
    const auto reject = [](const nmbc::BoundaryCoefficients& coefficients) {
        CHECK_THROWS_AS(
            nmbc::MatchingBoundary(
                coefficients, {.ghost_layers = 2, .wave_speed = 1, .spacing = 1, .time_step = 0.1}),
            std::invalid_argument);
    };
    reject({{}, {}, 1});
    reject({{1, 1}, {-2}, 1});
    reject({{1, 1}, {-2, 2}, -1});
    const nmbc::MatchingBoundary boundary(
        nmbc1, {.ghost_layers = 2, .wave_speed = 1, .spacing = 1, .time_step = 0.1});
    CHECK(boundary.reach() == 3);
    std::vector<double> two(2);
    std::vector<double> four(4);
    CHECK_THROWS_AS(boundary.update(two, two, nmbc::End::left), std::invalid_argument);
    CHECK_THROWS_AS(boundary.update(two, four, nmbc::End::left), std::invalid_argument);
}

}  // namespace
