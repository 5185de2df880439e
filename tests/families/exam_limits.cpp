// SPDX-License-Identifier: GPL-2.0-or-later
/// The limits of many neighbours, n -> infinity with dX = delta/n, and of a small horizon,
/// delta -> 0: (27) to (29) and (42) to (44) of Nicely 2018 against the dispersion relation of the
/// lattice, (41). c = 1.
#include <doctest/doctest.h>

#include "generator/families/family.hpp"

namespace {

using Float = nmbcgen::Real;

/// omega^2 by (41); families/exam_equations_of_motion.cpp shows that it holds.
Float lattice(int n, const Float& delta, const Float& xi, const Float& G) {
    const Float dX = delta / n;
    Float S = 0;
    Float C = 0;
    for (int m = 1; m <= n; ++m) {
        S += m * sin(xi * m * dX);
        C += cos(xi * m * dX) - 1;
    }
    const Float shape = Float(n) * (n + 1) * (2 * n + 1) / 3;
    return 4 *
           (pow(S / (shape * dX), 2) - G / (pow(Float(n), 4) * pow(dX, 3)) * (C + S * S / shape));
}

/// The limit n -> infinity. The sums are Riemann sums of smooth functions, with an error
/// p/n + q/n^2 + r/n^3 + ..; two steps of Richardson's extrapolation remove p and q.
Float limit(const Float& delta, const Float& xi, const Float& G) {
    constexpr int n = 400;
    const auto once = [&](int k) {
        return 2 * lattice(2 * k, delta, xi, G) - lattice(k, delta, xi, G);
    };
    return (4 * once(2 * n) - once(n)) / 3;
}

/// r/n^3 with n = 400 and r of a few times the value: 1e-7 of it at most.
bool agree(const Float& left, const Float& right) {
    return abs(left - right) < Float("1e-6") * abs(left);
}

/// Not a matter of accuracy.
bool differ(const Float& left, const Float& right) {
    return abs(left - right) > Float("1e-2") * abs(left);
}

struct Point {
    Float delta, xi, G;
};
const Point points[]{{1, Float("0.5"), 1}, {1, 2, Float("0.5")}, {2, 1, 3}, {Float("0.5"), 3, 1}};

/// (27) squared: 9 (sin(d) - d cos(d))^2 / (delta^6 xi^4) with d = delta xi.
Float standard_limit(const Point& at) {
    const Float d = at.delta * at.xi;
    return 9 * pow(sin(d) - d * cos(d), 2) / (pow(at.delta, 6) * pow(at.xi, 4));
}

/// F(delta, xi) below (42).
Float printed_F(const Point& at) {
    const Float d = at.delta * at.xi;
    return -2 * pow(d, 4) + 3 * pow(d * cos(d), 2) + 2 * pow(d, 3) * sin(d) + 3 * pow(sin(d), 2) -
           3 * d * sin(2 * d);
}

Float F_term(const Point& at) {
    return 2 * at.G * printed_F(at) / (pow(at.delta, 7) * pow(at.xi, 4));
}

}  // namespace

TEST_CASE("(27): the limit of the standard model holds as printed") {
    for (const Point& at : points) {
        CHECK(agree(limit(at.delta, at.xi, 0), standard_limit(at)));
    }
}

TEST_CASE("(42): the F term has the wrong sign") {
    for (const Point& at : points) {
        const Float omega_squared = limit(at.delta, at.xi, at.G);
        CHECK(agree(omega_squared, standard_limit(at) - F_term(at)));
        CHECK(differ(omega_squared, standard_limit(at) + F_term(at)));
        // F < 0, so that the printed sign would let the stabilisation soften the lattice.
        CHECK(printed_F(at) < 0);
        CHECK(omega_squared > limit(at.delta, at.xi, 0));
    }
}

TEST_CASE("(42): the square belongs on the bracket, not on the cosine") {
    for (const Point& at : points) {
        const Float d = at.delta * at.xi;
        const Float printed =
            9 * (sin(d) - d * pow(cos(d), 2)) / (pow(at.delta, 6) * pow(at.xi, 4));
        CHECK(differ(limit(at.delta, at.xi, 0), printed));
        CHECK(differ(limit(at.delta, at.xi, at.G), printed - F_term(at)));
        CHECK(differ(limit(at.delta, at.xi, at.G), printed + F_term(at)));
    }
}

TEST_CASE("the family's limit is the corrected (42), with G and delta in units of dX") {
    for (const Point& at : points) {
        for (const unsigned n : {1U, 2U, 3U, 20U}) {
            // The printed G is a length, too: it is G dX, and delta = n dX.
            const Point in_spacings{n, at.xi, at.G};
            const Float corrected = standard_limit(in_spacings) - F_term(in_spacings);
            // 50 digits less those that cancel in F.
            CHECK(abs(nmbcgen::nopd1d_limit(n, at.G, at.xi).value / corrected - 1) <
                  Float("1e-40"));
        }
    }
    CHECK(agree(limit(2, Float("0.7"), Float("0.5")),
                nmbcgen::nopd1d_limit(2, Float("0.5"), Float("0.7")).value));
}

TEST_CASE("(28): c xi is the limit delta -> 0, not n -> infinity as the middle has it") {
    for (const Point& at : points) {
        CHECK(differ(limit(at.delta, at.xi, 0), at.xi * at.xi));
        // omega^2 = xi^2 - delta^2 xi^4 M4/(3 M2 n^2) + O(delta^4) with M_k = sum m^k.
        const Float delta("1e-8");
        const Float M4_over_M2[]{1, Float(17) / 5, 7};  // 1/1, 17/5, 98/14
        for (const int n : {1, 2, 3}) {
            const Float approach = (lattice(n, delta, at.xi, 0) - at.xi * at.xi) / pow(delta, 2);
            const Float expected = -pow(at.xi, 4) * M4_over_M2[n - 1] / (3 * n * n);
            CHECK(abs(approach / expected - 1) < Float("1e-14"));  // (delta xi)^2 = 9e-16 at most
        }
    }
}

TEST_CASE("(43): c xi, as printed") {
    // omega^2 = xi^2 + delta G xi^4 M4/(2 n^5) + O(delta^2): C + S^2/A_n = -M4 (xi dX)^4/8 + ...
    const Float delta("1e-8");
    const Float M4[]{1, 17, 98};
    for (const Point& at : points) {
        for (const int n : {1, 2, 3}) {
            const Float omega_squared = lattice(n, delta, at.xi, at.G);
            const Float first = at.G * pow(at.xi, 4) * M4[n - 1] / (2 * pow(Float(n), 5));
            // The next term, that of (28), is 2 delta n^3/(3 M2 G) of it, 3e-8 at most.
            CHECK(abs((omega_squared - at.xi * at.xi) / (delta * first) - 1) < Float("1e-7"));
            CHECK(abs(sqrt(omega_squared) / at.xi - 1) < Float("3e-8"));  // delta first/(2 xi^2)
        }
    }
}

TEST_CASE("(44): c xi, of the corrected (42); the printed (42) grows beyond all bounds") {
    const Float delta("1e-5");  // F keeps 50 - 6 * 5 digits
    for (const Point& point : points) {
        const Point at{delta, point.xi, point.G};
        // As for (43), with M4/n^5 -> 1/5; the next term is 2 delta/G of it, 4e-5 at most.
        const Float first = delta * at.G * pow(at.xi, 4) / 10;
        const Float corrected = standard_limit(at) - F_term(at);
        CHECK(abs((corrected - at.xi * at.xi) / first - 1) < Float("1e-4"));
        // The sign of F alone does not matter to the limit, only to the side it comes from.
        const Float other_sign = standard_limit(at) + F_term(at);
        CHECK(abs((at.xi * at.xi - other_sign) / first - 1) < Float("1e-4"));
        // sin(d) - d cos^2(d) = 5 d^3/6 + O(d^5).
        const Float d = delta * at.xi;
        const Float printed = 9 * (sin(d) - d * pow(cos(d), 2)) / (pow(delta, 6) * pow(at.xi, 4));
        CHECK(abs(printed * pow(delta, 3) * at.xi / Float("7.5") - 1) < Float("1e-9"));
        CHECK(printed > Float("1e14"));
    }
}

TEST_CASE("(29): n stands for delta in the expression before the limit") {
    // (27) tends to c xi as delta -> 0, with a relative error of delta^2 xi^2/10; the printed
    // expression, 3 |sin(n xi) - delta xi cos(n xi)| / (n^3 xi^2), tends to something else.
    const Float xi = 1;
    const Float delta("1e-5");
    CHECK(abs(sqrt(standard_limit({delta, xi, 0})) - xi) < Float("1.1e-11"));
    for (const int n : {1, 2, 3}) {
        const Float printed =
            3 * abs(sin(n * xi) - delta * xi * cos(n * xi)) / (pow(Float(n), 3) * xi * xi);
        CHECK(abs(printed - xi) > Float("0.1"));
    }
}
