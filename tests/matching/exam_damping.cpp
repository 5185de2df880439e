// SPDX-License-Identifier: GPL-2.0-or-later
/// Damped lattices: the series of s, the limit tau -> 0, and where there is no condition. (That
/// derive() solves (49): check_literal_system.cpp; the order of the residual: check_residual.cpp.)
#include <doctest/doctest.h>
#include <ginac/ginac.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <string>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/matching/matching.hpp"
#include "generator/pipeline.hpp"
#include "tests/support/contains.hpp"
#include "tests/support/literal_system.hpp"
#include "tests/support/printed.hpp"
#include "tests/support/taylor.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;
using Float = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                            boost::multiprecision::et_off>;

namespace {

Float in_digits(const Rational& value) {
    return Float(numerator(value).str()) / Float(denominator(value).str());
}

/// |s - (a_1 x + .. + a_highest x^highest)|, x = i xi, with s = -decay + i omega by the closed
/// forms of (41): omega_0^2 = 4 (S/A)^2 + G sigma, sigma = -(4/n^4)(C + S^2/A).
Float truncation(const std::vector<Rational>& a, int n, const Rational& G, const Rational& tau,
                 unsigned highest, const Float& xi) {
    Float S = 0;
    Float C = 0;
    for (int m = 1; m <= n; ++m) {
        S += m * sin(m * xi);
        C += cos(m * xi) - 1;
    }
    const Float A = Float(n * (n + 1) * (2 * n + 1)) / 3;
    const Float sigma = -4 / pow(Float(n), 4) * (C + S * S / A);
    const Float decay = in_digits(tau) * sigma / 2;
    const Float omega = sqrt(4 * S * S / (A * A) + in_digits(G) * sigma - decay * decay);
    Float real = -decay;
    Float imaginary = omega;
    Float power = 1;
    for (unsigned k = 1; k <= highest; ++k) {
        power *= xi;
        const Float term = in_digits(a[k]) * power * (k % 4 < 2 ? 1 : -1);
        (k % 2 == 0 ? real : imaginary) -= term;
    }
    return sqrt(real * real + imaginary * imaginary);
}

/// The reason derive() gives for refusing nopd1d of horizon 1, stride 1; empty where it does not.
std::string refusal(unsigned order, const Rational& G, const Rational& tau) {
    try {
        derive({.family = "nopd1d",
                .horizon = 1,
                .order = order,
                .stride = 1,
                .stabilisation = G,
                .damping = tau});
    } catch (const NoSuchBoundary& reason) {
        return reason.what();
    }
    return "";
}

std::optional<std::vector<Rational>> literal(unsigned order, const Rational& G,
                                             const Rational& tau) {
    return solve_literally(to_rationals(nopd1d_taylor(1, to_ginac(G), 2 * order, to_ginac(tau))), 1,
                           order);
}

}  // namespace

TEST_CASE("the series of s agrees with the root of the quadratic, in 100 digits") {
    const Float xi("1e-8");  // xi^10 is far above 1e-100
    constexpr unsigned highest = 9;
    for (int n = 1; n <= 4; ++n) {
        for (const Rational& G : {Rational(0), Rational(5, 7), Rational(3)}) {
            for (const Rational& tau : {Rational(1, 50), Rational(3, 10), Rational(2)}) {
                const auto a = to_rationals(
                    nopd1d_taylor(unsigned(n), to_ginac(G), highest + 1, to_ginac(tau)));
                CAPTURE(n);
                CAPTURE(to_string(G));
                CAPTURE(to_string(tau));
                for (unsigned k = 1; k <= highest; ++k) {
                    CAPTURE(k);
                    // What the series up to x^k leaves is a_{k+1} x^{k+1} + .., where |a_{k+2}| and
                    // later ones stay below 1e6. An error of 1e-6 in a_k leaves 1e-14 xi^k already.
                    const Float next = in_digits(abs(a[k + 1])) + 1000000 * xi;
                    CHECK(truncation(a, n, G, tau, k, xi) < next * pow(xi, int(k) + 1));
                    CHECK(abs(a[k + 1]) < 1000000);
                }
            }
        }
    }
}

TEST_CASE("as tau goes to 0 the condition becomes the one without damping, identically in G") {
    const GiNaC::symbol G("G");
    const GiNaC::symbol tau("tau");
    for (const unsigned horizon : {1U, 2U}) {
        for (const unsigned order : {1U, 2U, 3U}) {
            CAPTURE(horizon);
            CAPTURE(order);
            const auto plain = match(nopd1d_taylor(horizon, G, 2 * order), 1, order);
            const auto damped = match(nopd1d_taylor(horizon, G, 2 * order, tau), 1, order);
            for (unsigned j = 0; j <= order; ++j) {
                const auto limit = [&](const GiNaC::ex& numerator) {
                    return (numerator / damped.C[0]).normal().subs(tau == 0);
                };
                CHECK(identical(limit(damped.C[j]), plain.C[j] / plain.C[0]));
                CHECK(identical(limit(damped.B[j]), plain.B[j] / plain.C[0]));
            }
            // NMBC1 sees a_1 and a_2 only, which damping leaves alone.
            CHECK((damped.C[order] - damped.C[0]).expand().is_zero() == (order == 1));
        }
    }
}

TEST_CASE("n = 1, G = 0: no longer a block of the Pade table") {
    // Without damping i omega = (z - 1/z)/2 = (z^2 - 1)/(2z) is exact at N = 2, with c_0 = 0. With
    // it c_0 is of order tau: c = (1, -2/tau, -1), b = (1/tau - 2, 4, -1/tau - 2).
    CHECK(contains(refusal(2, 0, 0), "block of the Pade table"));
    CHECK(refusal(2, 0, Rational(1, 50)).empty());
    CHECK(*literal(2, 0, Rational(1, 50)) == std::vector<Rational>{1, -100, -1, 48, 4, -52});
    CHECK(*literal(2, 0, Rational(2, 3)) ==
          std::vector<Rational>{1, -3, -1, Rational(-1, 2), 4, Rational(-7, 2)});
    for (unsigned order = 1; order <= 6; ++order) {
        CAPTURE(order);
        CHECK(refusal(order, 0, Rational(1, 50)).empty());
    }
}

TEST_CASE("n = 1, G = 2, tau = 1: the damped symbol is rational, and NMBC2 exact") {
    // With u = 1 - cos: sigma = 2u^2, omega^2 = u(2 - u) + 4u^2 = u(2 + 3u), and the discriminant
    // (sigma/2)^2 - omega^2 = u^4 - 3u^2 - 2u = u (u - 2)(u + 1)^2, where
    // u (u - 2) = (i sin)^2. So s = -u^2 + i (1 + u) sin = -3/2 + 2z - z^2/2, the one-sided
    // difference of second order.
    const Table table = derive({.family = "nopd1d",
                                .horizon = 1,
                                .order = 2,
                                .stride = 1,
                                .stabilisation = Rational(2),
                                .damping = Rational(1)});
    const auto number = [](const Rational& value) { return to_rational_function(constant(value)); };
    CHECK(table.c == std::vector{number(1), number(0), number(0)});
    CHECK(table.b == std::vector{number(Rational(-3, 2)), number(2), number(Rational(-1, 2))});
    for (const unsigned order : {3U, 4U}) {
        const std::string reason = refusal(order, 2, 1);
        CHECK(contains(reason, "s is itself a rational function of z"));
        CHECK(contains(reason, "every order N >= 3"));
        CHECK(contains(reason, "Use an order below 3"));
        CHECK_FALSE(literal(order, 2, 1));
    }
    CHECK(refusal(3, 2, Rational(1, 2)).empty());
}

TEST_CASE("n = 1, G = 1: NMBC1 gains one order, not two, and NMBC2 is (z - 1) times it") {
    const Rational tau(1, 10);
    const std::string reason = refusal(2, 1, tau);
    CHECK(contains(reason, "damping 1/10 at G = 1"));
    CHECK(contains(reason, "it would be (z-1) times NMBC1"));
    CHECK(contains(reason, "growth like t)"));
    CHECK(contains(reason, "Use order 1"));
    // (z - 1)(z + 1) and (z - 1)(2z - 2), with c_0 = 1.
    CHECK(*literal(2, 1, tau) == std::vector<Rational>{1, 0, -1, -2, 4, -2});
    CHECK(refusal(3, 1, tau).empty());
}

TEST_CASE("a rational s of type [1/1]: the order above has every multiple of it") {
    // s = 1 - exp(-x) = (z - 1)/z: c_0 = 0 at N = 1, and at N = 2 every minor vanishes. With h =
    // 1/2 in place of 1, (z^2 - 1)/z^2 is of type [2/2].
    const std::vector<GiNaC::ex> a{0, 1, GiNaC::numeric(-1, 2), GiNaC::numeric(1, 6),
                                   GiNaC::numeric(-1, 24)};
    CHECK(degeneracy(match(a, 1, 1)) == Degeneracy::pole);
    CHECK(degeneracy(match(a, 1, 2)) == Degeneracy::pade_block);
    CHECK(degeneracy(match(a, GiNaC::numeric(1, 2), 2)) == Degeneracy::pole);
    // s = exp(x) - 1 = z - 1 is NMBC1 itself.
    const std::vector<GiNaC::ex> b{0, 1, GiNaC::numeric(1, 2), GiNaC::numeric(1, 6),
                                   GiNaC::numeric(1, 24)};
    CHECK(degeneracy(match(b, 1, 1)) == Degeneracy::none);
    CHECK(degeneracy(match(b, 1, 2)) == Degeneracy::pade_block);
}
