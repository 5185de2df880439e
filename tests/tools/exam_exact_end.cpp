// SPDX-License-Identifier: GPL-2.0-or-later
/// The exact end: its kernel, the chain it makes, and what it refuses.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <ostream>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "tools/nmbcrun/ends/exact.hpp"
#include "tools/nmbcrun/ends/online_convolution.hpp"
#include "tools/nmbcrun/ends/transparent_kernel.hpp"

namespace {

using Kernel = std::vector<std::vector<double>>;

nmbc::Lattice lattice_of(int horizon, double G, double tau = 0) {
    const auto& table = *nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1);
    auto lattice = nmbc::make_lattice(table, G);
    if (tau > 0) {  // sigma is what G adds to omega^2 (41)
        lattice.damping = nmbc::make_lattice(table, 1).symbol;
        const auto without = nmbc::make_lattice(table, 0).symbol;
        for (std::size_t m = 0; m < without.size(); ++m) {
            lattice.damping[m] = tau * (lattice.damping[m] - without[m]);
        }
    }
    return lattice;
}

/// (56), in units of its own spring and mass.
const nmbc::Lattice atoms{.symbol = {2, -1}, .energy = {}, .damping = {}};

double courant_of(const nmbc::Lattice& lattice, double cfl) {
    return 2 * cfl / nmbc::maximum_frequency(lattice);
}

struct Case {
    int horizon;
    double G;
    double tau;
    double cfl;  ///< lowered to what the interior is stable at
};

std::vector<Case> cases(const std::vector<int>& horizons, const std::vector<double>& Gs,
                        const std::vector<double>& cfls) {
    std::vector<Case> result;
    for (const int horizon : horizons) {
        for (const double cfl : cfls) {
            result.push_back({horizon, Gs[1], 0.05, cfl});
            for (const double G : Gs) {
                result.push_back({horizon, G, 0, cfl});
            }
        }
    }
    for (Case& one : result) {
        const auto lattice = lattice_of(one.horizon, one.G, one.tau);
        one.cfl = std::min(one.cfl, nmbc::interior_cfl(lattice));
    }
    return result;
}

std::ostream& operator<<(std::ostream& stream, const Case& one) {
    return stream << "n = " << one.horizon << ", G = " << one.G << ", tau = " << one.tau
                  << ", cfl = " << one.cfl;
}

using Long = std::vector<long double>;

long double applied(const Long& stencil, const Long& field, std::size_t node) {
    long double sum = stencil.empty() ? 0.0L : stencil[0] * field[node];
    for (std::size_t m = 1; m < stencil.size(); ++m) {
        sum += stencil[m] * (field[node + m] + field[node - m]);
    }
    return sum;
}

/// Leapfrog in a half line so long that nothing returns, node 1-i moved by 1 at level 0 only; what
/// node 1 does is kernel[i-1]. In long double, whose roundings are none in double.
Long response(const nmbc::Lattice& lattice, double courant, std::size_t i, std::size_t steps) {
    const Long symbol(lattice.symbol.begin(), lattice.symbol.end());
    const Long damping(lattice.damping.begin(), lattice.damping.end());
    const long double dt = static_cast<long double>(courant);
    const std::size_t r = lattice.reach();
    const std::size_t nodes = r * (steps / 2 + 2);
    Long u(nodes + 2 * r);
    Long v(u.size());  // times dt
    Long result{0};
    u[r - i] = 1;
    v[r - i] = 1;
    for (std::size_t k = 0; k < steps; ++k) {
        const auto old = v;
        for (std::size_t node = r; node < r + nodes; ++node) {
            v[node] -= dt * (dt * applied(symbol, u, node) + applied(damping, old, node));
        }
        for (std::size_t node = r; node < r + nodes; ++node) {
            u[node] += v[node];
        }
        v[r - i] = k == 0 ? -1 : 0;
        u[r - i] = 0;
        result.push_back(u[r]);
    }
    return result;
}

TEST_CASE("the kernel is the half line's answer to unit impulses") {
    constexpr std::size_t steps = 100;
    // 1/2 and 0.5000001: at n = 1 the outermost coefficient is 0, and next to it.
    for (const Case& one :
         cases({1, 2, 3, 5}, {0.0, 0.5, 0.5000001, 1.0}, {0.02, 0.3, 0.95, 1.0})) {
        const auto lattice = lattice_of(one.horizon, one.G, one.tau);
        const double courant = courant_of(lattice, one.cfl);
        const Kernel kernel = nmbcrun::transparent_kernel(lattice, courant, steps);
        REQUIRE(kernel.size() == lattice.reach());
        for (std::size_t i = 1; i <= kernel.size(); ++i) {
            const Long expected = response(lattice, courant, i, steps);
            double error = 0;
            for (std::size_t m = 0; m <= steps; ++m) {
                error += std::abs(kernel[i - 1][m] - double(expected[m]));
            }
            CAPTURE(one);
            // To the last bit: 101 entries, a few of them near 1, of up to eps each.
            CHECK(error < 5e-15);
        }
    }
}

TEST_CASE("the kernel of the atom chain solves its quadratic equation") {
    // (1-q)^2 lambda = courant^2 q (1 - lambda)^2, q = 1/z, power by power.
    constexpr std::size_t steps = 2000;
    for (const double courant : {0.1, 0.5, 0.9, 1.0}) {
        std::vector<double> expected(steps + 1);
        for (std::size_t m = 1; m <= steps; ++m) {
            double squares = m == 1 ? 1 : 0;
            for (std::size_t j = 1; j + 1 < m; ++j) {
                squares += expected[j] * expected[m - 1 - j];
            }
            expected[m] = courant * courant * squares +
                          (2 - 2 * courant * courant) * expected[m - 1] -
                          (m > 1 ? expected[m - 2] : 0);
        }
        const Kernel kernel = nmbcrun::transparent_kernel(atoms, courant, steps);
        CAPTURE(courant);
        for (std::size_t m = 0; m <= steps; ++m) {
            // The recurrence's own roundings: sqrt(2000) of values below 1/10 and of sums of those.
            CHECK(std::abs(kernel[0][m] - expected[m]) < 5e-15);
        }
    }
    // courant = 1: every wave moves on by a node a step.
    const Kernel shift = nmbcrun::transparent_kernel(atoms, 1, 100);
    for (std::size_t m = 0; m <= 100; ++m) {
        CHECK(std::abs(shift[0][m] - (m == 1 ? 1 : 0)) < 1e-17);  // in long double
    }
}

TEST_CASE("in short steps the atom chain's kernel is 2 J_2(2t)/t") {
    double before = 0;
    for (const double dt : {0.04, 0.02, 0.01}) {
        const auto steps = std::size_t(std::lround(20 / dt));
        const Kernel kernel = nmbcrun::transparent_kernel(atoms, dt, steps);
        double error = 0;
        for (std::size_t m = 1; m <= steps; ++m) {
            const double t = double(m) * dt;
            error = std::max(error,
                             std::abs(kernel[0][m] / dt - 2 * std::cyl_bessel_j(2.0, 2 * t) / t));
        }
        CHECK(error < 0.2 * dt * dt);  // 0.18 dt^2: leapfrog is of second order
        if (before > 0) {
            CHECK(before / error == doctest::Approx(4).scale(0).epsilon(0.02));
        }
        before = error;
    }
}

TEST_CASE("blocks of a convolution give what plain sums do") {
    std::mt19937_64 random(20180417);
    std::normal_distribution<double> normal;
    for (const std::size_t steps : {1U, 2U, 31U, 32U, 33U, 64U, 65U, 500U, 1024U}) {
        Kernel kernel(3, std::vector<double>(steps + 1));
        for (auto& values : kernel) {
            std::ranges::generate(values, [&] { return normal(random); });
        }
        nmbcrun::OnlineConvolution convolution(kernel);
        std::vector<std::vector<double>> x(5);
        for (std::size_t k = 1; k <= steps; ++k) {
            std::vector<double> given;
            given.reserve(x.size());
            for (auto& values : x) {
                values.push_back(normal(random));
                given.push_back(values.back());
            }
            std::vector<double> y(3);
            convolution.advance(given, y);
            for (std::size_t e = 0; e < 3; ++e) {
                long double expected = 0;
                for (std::size_t i = 1; i <= 3; ++i) {
                    for (std::size_t m = 1; m <= k; ++m) {
                        expected += static_cast<long double>(kernel[i - 1][m]) *
                                    static_cast<long double>(x[e + i - 1][k - m]);
                    }
                }
                // Sums of up to 200, whose last bit is 3e-14, from ten transforms.
                CHECK(std::abs(y[e] - double(expected)) < 3e-13);
            }
        }
        CHECK(convolution.levels() == steps);
    }
}

/// Nothing near the ends, and every wave number in the middle. Of the same interior with any layer.
void start_randomly(nmbc::Chain& chain) {
    std::mt19937_64 random(20180417);
    std::normal_distribution<double> normal;
    std::vector<double> u(chain.nodes());
    std::vector<double> v(chain.nodes());
    const std::size_t nodes = chain.parameters().nodes;
    const double unit = chain.parameters().wave_speed() / chain.parameters().spacing;
    for (std::size_t node = nodes / 3; node < nodes * 2 / 3; ++node) {
        u[chain.first_interior() + node] = normal(random);
        v[chain.first_interior() + node] = normal(random) * unit;
    }
    chain.start(u, v);
}

double largest(std::span<const double> values) {
    const auto [low, high] = std::ranges::minmax(values);
    return std::max(-low, high);
}

std::span<const double> interior(const nmbc::Chain& chain) {
    return chain.displacement().subspan(chain.first_interior(), chain.parameters().nodes);
}

/// The largest difference of the two interiors' u in that many steps, over the largest u.
double difference(nmbc::Chain& one, nmbc::Chain& other, std::size_t steps) {
    start_randomly(one);
    start_randomly(other);
    double error = 0;
    double scale = 0;
    for (std::size_t k = 0; k < steps; ++k) {
        one.step();
        other.step();
        scale = std::max(scale, largest(interior(other)));
        for (std::size_t node = 0; node < one.parameters().nodes; ++node) {
            error = std::max(error, std::abs(interior(one)[node] - interior(other)[node]));
        }
    }
    return error / scale;
}

nmbc::ChainParameters parameters_of(const nmbc::Lattice& lattice, double cfl,
                                    std::size_t nodes = 40) {
    nmbc::ChainParameters p{.nodes = nodes, .spacing = 0.5, .youngs_modulus = 3, .density = 2};
    p.time_step = courant_of(lattice, cfl) * p.spacing / p.wave_speed();
    return p;
}

TEST_CASE("a chain between exact ends is one that nothing returns in") {
    constexpr std::size_t steps = 300;
    const nmbc::ChainEnd exact = nmbcrun::ExactEnd{steps};
    const nmbc::ChainEnd free_end = nmbc::FreeEnd{};
    for (const Case& one : cases({1, 2, 3}, {0.0, 0.3, 1.0}, {0.3, 0.95})) {
        const auto lattice = lattice_of(one.horizon, one.G, one.tau);
        // A step reaches r nodes further: these are out of reach there and back.
        const nmbc::ChainEnd wide = nmbc::FixedEnd{lattice.reach() * steps / 2};
        const auto p = parameters_of(lattice, one.cfl);
        for (const int free_side : {0, 1, 2}) {  // none, left, right
            nmbc::Chain shorter(lattice, free_side == 1 ? free_end : exact,
                                free_side == 2 ? free_end : exact, p);
            nmbc::Chain longer(lattice, free_side == 1 ? free_end : wide,
                               free_side == 2 ? free_end : wide, p);
            CAPTURE(one);
            CAPTURE(free_side);
            // Roundings of 300 steps, of sums of 7 to 15 terms of up to twice the largest u:
            // 300 sqrt(15) eps, if all of them add up.
            CHECK(difference(shorter, longer, steps) < 2e-13);
        }
    }
}

TEST_CASE("opposite a matching boundary, too") {
    constexpr std::size_t steps = 300;
    const auto& table = *nmbc::find_table(nmbc::generated::tables, "nopd1d", 1, 2);
    const auto lattice = nmbc::make_lattice(table, 0.5);
    const nmbc::ChainEnd matching = nmbc::MatchingEnd{nmbc::boundary_coefficients(table, 0.5)};
    const auto p = parameters_of(lattice, 0.5);
    nmbc::Chain one(lattice, matching, nmbcrun::ExactEnd{steps}, p);
    nmbc::Chain other(lattice, matching, nmbc::FixedEnd{lattice.reach() * steps / 2}, p);
    CHECK(difference(one, other, steps) < 2e-13);  // as above
}

TEST_CASE("a stored run goes on bit for bit") {
    constexpr std::size_t steps = 300;
    for (const double tau : {0.0, 0.05}) {
        const auto lattice = lattice_of(2, 0.3, tau);
        const auto p = parameters_of(lattice, 0.5);
        const auto new_chain = [&] { return nmbc::Chain(lattice, nmbcrun::ExactEnd{steps}, p); };
        const auto finish = [](nmbc::Chain& chain) {
            while (chain.steps() < steps) {
                chain.step();
            }
            return chain.state();
        };
        auto straight = new_chain();
        start_randomly(straight);
        std::vector<nmbc::ChainState<double>> stored;
        for (const std::size_t steps_before : {0U, 1U, 100U, 128U, 199U, 300U}) {
            while (straight.steps() < steps_before) {
                straight.step();
            }
            stored.push_back(straight.state());
        }
        const auto expected = finish(straight);
        for (const auto& state : stored) {
            auto resumed = new_chain();
            resumed.resume(state);
            const auto found = finish(resumed);
            CAPTURE(state.steps);
            CHECK(found.displacement == expected.displacement);
            CHECK(found.velocity == expected.velocity);
            CHECK(found.left == expected.left);
            CHECK(found.right == expected.right);
        }
        nmbc::Chain shorter(lattice, nmbcrun::ExactEnd{steps - 1}, p);
        CHECK_THROWS_AS(shorter.resume(stored[2]), std::invalid_argument);
    }
}

TEST_CASE("a second start forgets the first run") {
    constexpr std::size_t steps = 100;
    const auto lattice = lattice_of(1, 1);
    const auto p = parameters_of(lattice, 0.9);
    nmbc::Chain chain(lattice, nmbcrun::ExactEnd{steps}, p);
    const auto run = [&] {
        start_randomly(chain);
        while (chain.steps() < steps) {
            chain.step();
        }
        return std::vector(chain.displacement().begin(), chain.displacement().end());
    };
    const auto first = run();
    CHECK(run() == first);
}

TEST_CASE("what starts near an exact end is refused") {
    const auto lattice = lattice_of(2, 1);  // reaches 4 nodes
    const auto p = parameters_of(lattice, 0.5);
    nmbc::Chain chain(lattice, nmbcrun::ExactEnd{10}, p);
    const auto starts = [&](std::size_t node, double u_there, double v_there) {
        std::vector<double> u(chain.nodes(), 0.0);
        std::vector<double> v(chain.nodes(), 0.0);
        u[chain.nodes() / 2] = 1;
        u[node] = u_there;
        v[node] = v_there;
        chain.start(u, v);
    };
    const std::size_t last = chain.nodes() - 1;
    for (const std::size_t node :
         {std::size_t(0), std::size_t(3), std::size_t(7), last - 7, last}) {
        CHECK_THROWS_WITH_AS(starts(node, 1e-11, 0),
                             doctest::Contains("an exact end starts from rest"),
                             std::invalid_argument);
        CHECK_THROWS_AS(starts(node, 0, 1e-10), std::invalid_argument);
        CHECK_NOTHROW(starts(node, 1e-13, 0));
    }
    CHECK_NOTHROW(starts(12, 1, 1));
    // Written to once waves are at the end.
    start_randomly(chain);
    for (int i = 0; i < 9; ++i) {
        chain.step();
    }
    chain.displacement()[20] = 3;
    CHECK_THROWS_AS(chain.step(), std::invalid_argument);
}

TEST_CASE("an exact end that cannot be") {
    const auto lattice = lattice_of(2, 1);
    const auto p = parameters_of(lattice, 0.5);
    const auto made = [&](std::size_t steps, const nmbc::ChainParameters& parameters) {
        return nmbc::Chain(lattice, nmbcrun::ExactEnd{steps}, parameters);
    };
    CHECK_THROWS_WITH_AS(made(0, p), doctest::Contains("1 to 200000 steps, not 0"),
                         std::invalid_argument);
    CHECK_THROWS_AS(made(nmbcrun::ExactEnd::most_steps + 1, p), std::invalid_argument);
    CHECK_THROWS_WITH_AS(made(10, parameters_of(lattice, 1.01)),
                         doctest::Contains("that the interior is stable in"),
                         std::invalid_argument);
    CHECK_NOTHROW(made(10, parameters_of(lattice, 1)));
    CHECK_THROWS_WITH_AS(made(10, parameters_of(lattice, 0.5, 3)),
                         doctest::Contains("at least 4 interior nodes"), std::invalid_argument);
    CHECK_NOTHROW(made(10, parameters_of(lattice, 0.5, 4)));
    nmbc::Lattice wrong = lattice;
    wrong.damping.assign(lattice.symbol.size() + 1, 0.0);
    CHECK_THROWS_AS(nmbcrun::transparent_kernel(wrong, 0.1, 10), std::invalid_argument);
    CHECK_THROWS_AS(nmbcrun::transparent_kernel(lattice, std::nan(""), 10), std::invalid_argument);

    auto chain = made(3, p);
    for (int i = 0; i < 3; ++i) {
        chain.step();
    }
    CHECK_THROWS_WITH_AS(chain.step(), doctest::Contains("made for 3 steps"), std::length_error);
}

}  // namespace
