// SPDX-License-Identifier: GPL-2.0-or-later
/// The symbol of nopd1d against the equations of motion of Nicely 2018, assembled as printed with
/// u_{I+k} = z^k (24), and against the printed dispersion relations.
///
/// rho = E = 1 throughout. The printed equations keep dX and their own G; the model has dX = 1.
#include <doctest/doctest.h>
#include <ginac/ginac.h>

#include <functional>

#include "generator/families/family.hpp"
#include "generator/matching/freeze.hpp"
#include "tests/support/printed.hpp"

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::pow;
using namespace nmbcgen::test;

namespace {

const GiNaC::symbol z("z");    // exp(i xi dX)
const GiNaC::symbol G("G");    // as the paper prints it
const GiNaC::symbol dX("dX");  // node spacing

/// The sum over i = -n .. n without i = 0 that every equation has.
ex over_bonds(int n, const std::function<ex(int)>& term) {
    ex sum = 0;
    for (int i = -n; i <= n; ++i) {
        if (i != 0) {
            sum += term(i);
        }
    }
    return sum;
}

/// u_{I+a, I+b} = u_{I+b} - u_{I+a}, as defined below (14).
ex difference(int a, int b) {
    return pow(z, b) - pow(z, a);
}

/// A_n of (16), summed as in (15) rather than by the printed closed form.
ex shape(int n) {
    return over_bonds(n, [](int i) { return numeric(i) * i; });
}

/// sum_i i u_{J,J+i}, the sum in (16) to (19), at node J.
ex weighted_differences(int n, int J) {
    return over_bonds(n, [J](int i) { return i * difference(J, J + i); });
}

/// (10), one dimension, h_1 = 1: C_BB = 2E/delta^3 with delta = n dX.
ex micromodulus(int n) {
    return 2 / pow(n * dX, 3);
}

/// Right side of (20).
ex standard_acceleration(int n) {
    const ex sum = over_bonds(n, [n](int i) {
        return over_bonds(n, [i](int j) { return i * j * difference(i, i + j); });
    });
    return sum / pow(shape(n), 2) / pow(dX, 2);
}

/// Right side of (38).
ex stabilised_acceleration(int n) {
    const ex sum = over_bonds(
        n, [n](int i) { return 2 * difference(0, i) - i * weighted_differences(n, i) / shape(n); });
    return standard_acceleration(n) + G * micromodulus(n) / (2 * n) * sum;
}

/// The model's omega^2 at the given value of the project's G, in z.
ex model_symbol(int n, const ex& stabilisation) {
    const nmbcgen::Model model = nmbcgen::make_model("nopd1d", unsigned(n));
    const GiNaC::symbol parameter("G");
    ex sum = nmbcgen::thaw(model.symbol[0], parameter);
    for (std::size_t m = 1; m < model.symbol.size(); ++m) {
        sum += nmbcgen::thaw(model.symbol[m], parameter) * (pow(z, int(m)) + pow(z, -int(m)));
    }
    return sum.subs(parameter == stabilisation);
}

/// The model's tau sigma, in z.
ex model_damping(int n, const nmbcgen::Rational& tau) {
    const nmbcgen::Model model = nmbcgen::make_model("nopd1d", unsigned(n), tau);
    ex sum = to_ginac(model.damping.at(0));
    for (std::size_t m = 1; m < model.damping.size(); ++m) {
        sum += to_ginac(model.damping[m]) * (pow(z, int(m)) + pow(z, -int(m)));
    }
    return sum;
}

ex sine(int m) {  // sin(m xi dX)
    return (pow(z, m) - pow(z, -m)) / (2 * GiNaC::I);
}

ex cosine(int m) {
    return (pow(z, m) + pow(z, -m)) / 2;
}

/// S = sum m sin(m xi dX) and C = sum (cos(m xi dX) - 1) of (26) and (41), m = 1 .. n.
ex sine_sum(int n) {
    ex sum = 0;
    for (int m = 1; m <= n; ++m) {
        sum += m * sine(m);
    }
    return sum;
}

ex cosine_sum(int n) {
    ex sum = 0;
    for (int m = 1; m <= n; ++m) {
        sum += cosine(m) - 1;
    }
    return sum;
}

}  // namespace

TEST_CASE("A_n of (16) in closed form") {
    for (int n = 1; n <= 6; ++n) {
        CHECK(shape(n) == numeric(long(n) * (n + 1) * (2 * n + 1), 3));
    }
}

TEST_CASE("(20) is (2) with the force states (18) and (19)") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        // T_I<i'> = i' sum i u_{I,I+i} / (A_n^2 dX^3), and j' = -i' at the other end; V_J = dX.
        const auto state = [n](int J, int bond) {
            return bond * weighted_differences(n, J) / pow(shape(n), 2) / pow(dX, 3);
        };
        const ex assembled = dX * over_bonds(n, [&](int i) { return state(0, i) - state(i, -i); });
        CHECK(identical(assembled, standard_acceleration(n)));
    }
}

TEST_CASE("(36) is (2) with the stabilisation state (34), and (38) is (36) with (37)") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        // w/w_0 dV = 1/(2n) by (37); z_I<i'> = u_{I,I+i'} - (sum i u_{I,I+i} / A_n) i'.
        const auto state = [n](int J, int bond) {
            return G * micromodulus(n) / (2 * n) *
                   (difference(J, J + bond) - weighted_differences(n, J) / shape(n) * bond);
        };
        const ex assembled = over_bonds(n, [&](int i) { return state(0, i) - state(i, -i); });
        CHECK(identical(standard_acceleration(n) + assembled, stabilised_acceleration(n)));
    }
}

TEST_CASE("the symbol follows from the equations of motion (20) and (38)") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        // u_tt = -omega^2 u (24); the model's omega is in units of c/dX.
        const ex at_unit_spacing = model_symbol(n, G);
        CHECK(identical(model_symbol(n, 0), -standard_acceleration(n) * pow(dX, 2)));
        CHECK(identical(at_unit_spacing, -stabilised_acceleration(n).subs(dX == 1)));
    }
}

TEST_CASE("the printed G has the dimension of dX: the model's G is the printed one over dX") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        const ex printed = -stabilised_acceleration(n) * pow(dX, 2);
        CHECK(identical(model_symbol(n, G / dX), printed));
        // As they stand, 1/dX^2 and G/dX^3 agree for no other dX than 1.
        CHECK_FALSE(identical(model_symbol(n, G), printed));
        CHECK_FALSE(identical(model_symbol(n, G * dX), printed));
    }
}

TEST_CASE("(22) and (39): the nearest-neighbour equations of motion") {
    const ex second = (pow(z, -2) - 2 + pow(z, 2)) / (4 * pow(dX, 2));
    CHECK(identical(standard_acceleration(1), second));
    const ex printed = ((pow(z, -2) - 2 + pow(z, 2)) / (2 * pow(dX, 2)) +
                        G * (-pow(z, -2) + 4 * pow(z, -1) - 6 + 4 * z - pow(z, 2)) / pow(dX, 3)) /
                       2;
    CHECK(identical(stabilised_acceleration(1), printed));
}

TEST_CASE("(25), (26) and (30): standard dispersion relation") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        const ex sum = over_bonds(n, [](int i) { return i * pow(z, i); });
        CHECK(identical(-model_symbol(n, 0), pow(sum / shape(n), 2)));
        // (26) squared: 36 S^2 / (n(n+1)(2n+1))^2.
        const numeric product = n * (n + 1) * (2 * n + 1);
        CHECK(identical(model_symbol(n, 0), 36 * pow(sine_sum(n) / product, 2)));
    }
    CHECK(identical(model_symbol(1, 0), pow(sine(1), 2)));  // (30) squared
}

TEST_CASE("(40) and (41): stabilised dispersion relation") {
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        const ex S = sine_sum(n);
        const ex bracket = cosine_sum(n) + pow(S, 2) / shape(n);
        const ex with_micromodulus =  // (40) squared
            4 / pow(shape(n) * dX, 2) * pow(S, 2) - 4 * G * micromodulus(n) / (2 * n) * bracket;
        CHECK(identical(with_micromodulus, -stabilised_acceleration(n)));
        const ex printed =  // (41) squared
            4 * (pow(S / (shape(n) * dX), 2) - G / (pow(numeric(n), 4) * pow(dX, 3)) * bracket);
        CHECK(identical(printed, with_micromodulus));
        CHECK(identical(printed.subs(dX == 1), model_symbol(n, G)));
    }
}

TEST_CASE("damping is tau times what G is multiplied with in (41)") {
    const nmbcgen::Rational tau(3, 7);
    for (int n = 1; n <= 6; ++n) {
        CAPTURE(n);
        const ex sigma = -4 / pow(numeric(n), 4) * (cosine_sum(n) + pow(sine_sum(n), 2) / shape(n));
        CHECK(identical(model_damping(n, tau), to_ginac(tau) * sigma));
    }
    CHECK(identical(model_damping(1, 1), 2 * pow(1 - cosine(1), 2)));
}

TEST_CASE("n = 1: omega^2 = sin^2 + 2G(1 - cos)^2, and at G = 1/2 the atom chain (56)") {
    CHECK(identical(model_symbol(1, G), pow(sine(1), 2) + 2 * G * pow(1 - cosine(1), 2)));
    // (2 sin(xi/2))^2 = 2 - 2 cos(xi) = -z + 2 - 1/z: (56) with k = m = 1.
    CHECK(identical(model_symbol(1, numeric(1, 2)), 2 - z - 1 / z));
}

TEST_CASE("(59): an edge node whose outer neighbour has one neighbour only") {
    // Node 0 sees node 1 alone, so that its shape (13) is 1 and not A_1 = 2: the states (3) are
    // T_J<j> = j eps_J / (shape_J dX^2), eps_J = sum j (u_{J+j} - u_J) / (shape_J dX), V = dX.
    const GiNaC::symbol u0("u_0");
    const GiNaC::symbol u1("u_1");
    const GiNaC::symbol u2("u_2");
    const GiNaC::symbol u3("u_3");
    const ex strain_0 = (u1 - u0) / dX;
    const ex strain_1 = (u2 - u0) / (2 * dX);
    const ex strain_2 = (u3 - u1) / (2 * dX);
    const auto state = [](const ex& strain, int bond, int own_shape) {
        return bond * strain / (own_shape * pow(dX, 2));
    };
    const ex acceleration = dX * (state(strain_1, -1, 2) - state(strain_0, 1, 1) +  // J = 0
                                  state(strain_1, 1, 2) - state(strain_2, -1, 2));  // J = 2
    CHECK(identical(acceleration, (4 * u0 - 5 * u1 + u3) / (4 * pow(dX, 2))));
    CHECK_FALSE(identical(acceleration, (3 * u0 - 4 * u2 + u3) / (4 * pow(dX, 2))));  // printed
    // No u_2: node 1's own states cancel, and no other strain has it.
    CHECK(acceleration.expand().coeff(u2, 1).is_zero());
}
