// SPDX-License-Identifier: GPL-2.0-or-later
/// Where there is no matching boundary condition, and why; each case against the determinant of
/// (49) as printed.
#include <doctest/doctest.h>

#include <string>

#include "generator/exact/rational.hpp"
#include "generator/matching/matching.hpp"
#include "generator/pipeline.hpp"
#include "tests/support/contains.hpp"
#include "tests/support/literal_system.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/taylor.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

struct Case {
    unsigned horizon;
    unsigned order;
    unsigned stride;
    Rational G;
};

Specification specification(const Case& what) {
    return {.family = "nopd1d",
            .horizon = what.horizon,
            .order = what.order,
            .stride = what.stride,
            .stabilisation = what.G};
}

/// The reason derive() gives for refusing; empty where it derives a table.
std::string refusal(const Case& what) {
    try {
        derive(specification(what));
    } catch (const NoSuchBoundary& reason) {
        return reason.what();
    }
    return "";
}

std::vector<Rational> taylor_of(const Case& what) {
    return to_rationals(nopd1d_taylor(what.horizon, to_ginac(what.G), 2 * what.order));
}

Rational literal_determinant(const Case& what) {
    const auto matrix = literal_matrix(taylor_of(what), Rational(int(what.stride)), what.order);
    return eliminate(matrix).determinant;
}

Degeneracy degeneracy_of(const Case& what) {
    const auto taylor = nopd1d_taylor(what.horizon, to_ginac(what.G), 2 * what.order);
    return degeneracy(match(taylor, int(what.stride), what.order));
}

/// The G at which NMBC1 gains an order: a_1 dX^2 + 12 a_3 = 0, for n = 1, 2, 3.
const Rational gains_an_order[]{1, Rational(208, 85), Rational(405, 98)};

}  // namespace

TEST_CASE("G = 0, stride 1: singular exactly for N >= 2n, the paper's admissible condition") {
    for (unsigned n = 1; n <= 4; ++n) {
        for (unsigned order = 1; order <= 2 * n + 2; ++order) {
            const Case what{n, order, 1, 0};
            CAPTURE(n);
            CAPTURE(order);
            const std::string reason = refusal(what);
            if (order < 2 * n) {
                CHECK(reason.empty());
                CHECK(literal_determinant(what) != 0);
            } else {
                CHECK(contains(reason, "block of the Pade table"));
                CHECK(contains(reason, "every order N >= " + std::to_string(2 * n)));
                CHECK(contains(reason, "order below " + std::to_string(2 * n)));
                CHECK(contains(reason, "NMBC" + std::to_string(order) + " does not exist"));
                CHECK(literal_determinant(what) == 0);
            }
        }
    }
}

TEST_CASE("G = 0, strides 2 and 3: not singular") {
    for (unsigned n = 1; n <= 3; ++n) {
        for (unsigned order = 1; order <= 5; ++order) {
            for (const unsigned stride : {2U, 3U}) {
                const Case what{n, order, stride, 0};
                CAPTURE(n);
                CAPTURE(order);
                CAPTURE(stride);
                CHECK(literal_determinant(what) != 0);
                CHECK(refusal(what).empty());
            }
        }
    }
}

TEST_CASE("G = 1, 208/85, 405/98: NMBC1 gains an order, and takes NMBC2 and NMBC3 with it") {
    for (unsigned n = 1; n <= 3; ++n) {
        const Rational G = gains_an_order[n - 1];
        CAPTURE(n);
        // Residual of NMBC1, c = (1, 1), b = (-2, 2), at x^3: sum c_j (a_1 j^2/2 + a_3) - 2/6.
        CHECK(taylor_of({n, 2, 1, G})[3] == Rational(-1, 12));

        const std::string second = refusal({n, 2, 1, G});
        CHECK(contains(second, "NMBC1 meets its conditions already"));
        CHECK(contains(second, "singular"));
        CHECK(contains(second, "Use order 1"));
        CHECK(literal_determinant({n, 2, 1, G}) == 0);

        const std::string third = refusal({n, 3, 1, G});
        CHECK(contains(third, "(z-1)^2 times NMBC1"));
        CHECK(contains(third, "C(1) = 0"));
        CHECK(contains(third, "Use order 1"));
        CHECK(refusal({n, 4, 1, G}).empty());
        CHECK(literal_determinant({n, 4, 1, G}) != 0);
    }
}

TEST_CASE("there (49) for N = 3 is not singular: it has (z-1)^2 (NMBC1) for its one solution") {
    for (unsigned n = 1; n <= 3; ++n) {
        const Case what{n, 3, 1, gains_an_order[n - 1]};
        CAPTURE(n);
        const auto solution = solve_literally(taylor_of(what), 1, 3);
        REQUIRE(solution);
        // (z-1)^2 (z+1) = z^3 - z^2 - z + 1 and 2 (z-1)^2 (z-1) = 2z^3 - 6z^2 + 6z - 2.
        CHECK(*solution == std::vector<Rational>{1, -1, -1, 1, -2, 6, -6, 2});
    }
}

TEST_CASE("n = 2, N = 2 has a pole at G = 128/85") {
    const Case what{2, 2, 1, Rational(128, 85)};
    CHECK(contains(refusal(what), "pole"));
    CHECK(contains(refusal(what), "G = 128/85"));
    CHECK(contains(refusal(what), "Use order 1"));
    CHECK(literal_determinant(what) == 0);
}

TEST_CASE("N = 2: the determinant of (49) vanishes there and nowhere else") {
    // det = k (G - p)(G - q), a polynomial of degree 2 in G, as three more values confirm: p the
    // pole (n = 1: G = 0, where the Pade block begins), q where NMBC1 gains an order.
    const Rational pole[]{0, Rational(128, 85), Rational(162, 49)};
    for (unsigned n = 1; n <= 3; ++n) {
        CAPTURE(n);
        const auto shape = [&](const Rational& G) {
            return (G - pole[n - 1]) * (G - gains_an_order[n - 1]);
        };
        const Rational k = literal_determinant({n, 2, 1, 7}) / shape(7);
        CHECK(k != 0);
        for (const Rational& G : {pole[n - 1], gains_an_order[n - 1], Rational(5), Rational(1, 3),
                                  Rational(-2), Rational(11)}) {
            CHECK(literal_determinant({n, 2, 1, G}) == k * shape(G));
        }
        CHECK_FALSE(refusal({n, 2, 1, pole[n - 1]}).empty());
    }
}

TEST_CASE("n = 1: NMBC2 gains an order at G = 2/3, with the same consequences one order up") {
    // The printed bound of (55). det of (49) for N = 3 is proportional to (3G - 2) G^3.
    const Rational G(2, 3);
    CHECK(refusal({1, 2, 1, G}).empty());
    CHECK(contains(refusal({1, 3, 1, G}), "NMBC2 meets its conditions already"));
    CHECK(literal_determinant({1, 3, 1, G}) == 0);
    CHECK(contains(refusal({1, 4, 1, G}), "(z-1)^2 times NMBC2"));
    CHECK(refusal({1, 5, 1, G}).empty());
    for (const Rational& other : {Rational(1, 3), Rational(5, 7), Rational(4)}) {
        const auto shape = [](const Rational& g) { return (3 * g - 2) * g * g * g; };
        CHECK(literal_determinant({1, 3, 1, other}) * shape(2) ==
              literal_determinant({1, 3, 1, 2}) * shape(other));
    }
}

TEST_CASE("refused as singular exactly where the determinant of (49) is zero") {
    std::vector<Rational> values{0,
                                 1,
                                 Rational(2, 3),
                                 Rational(128, 85),
                                 Rational(208, 85),
                                 Rational(405, 98),
                                 Rational(162, 49),
                                 Rational(288, 85)};
    for (int twelfth = 1; twelfth <= 60; ++twelfth) {
        values.emplace_back(twelfth, 12);
    }
    int singular = 0;
    for (unsigned n = 1; n <= 3; ++n) {
        for (unsigned order = 1; order <= 5; ++order) {
            for (const unsigned stride : {1U, 2U}) {
                for (const Rational& G : values) {
                    const Case what{n, order, stride, G};
                    CAPTURE(n);
                    CAPTURE(order);
                    CAPTURE(stride);
                    CAPTURE(to_string(G));
                    const Degeneracy found = degeneracy_of(what);
                    const bool has_solution =
                        found == Degeneracy::none || found == Degeneracy::vanishing_at_one;
                    REQUIRE((literal_determinant(what) != 0) == has_solution);
                    singular += int(!has_solution);
                }
            }
        }
    }
    CHECK(singular > 15);  // the named cases alone; the grid adds those at a twelfth
}
