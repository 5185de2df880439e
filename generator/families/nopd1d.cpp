// SPDX-License-Identifier: MIT
/// One-dimensional non-ordinary peridynamics (NOPD), correspondence material, stabilised after
/// Silling (Nicely 2018, sections 2 and 3, where the influence function is constant).
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"

namespace nmbcgen {
namespace {

/// P_k = sum_{m=1}^n m^k, k = 0 .. highest, as polynomials in n of degree k + 1 (Faulhaber), from
/// (n+1)^(k+1) - 1 = sum_{j=0}^k binomial(k+1, j) P_j, which is sum (m+1)^(k+1) - m^(k+1).
std::vector<Polynomial> power_sums(unsigned highest) {
    const Polynomial next(std::vector<Rational>{1, 1});  // n + 1
    std::vector<Polynomial> sums;
    Polynomial power = next;
    for (unsigned k = 0; k <= highest; ++k) {
        Polynomial sum = power - constant(1);
        Integer binomial = 1;
        for (unsigned j = 0; j < k; ++j) {
            sum -= sums[j] * constant(Rational(binomial));
            binomial = binomial * (k + 1 - j) / (j + 1);
        }
        sums.push_back(sum / constant(Rational(k + 1)));
        power *= next;
    }
    return sums;
}

/// The energy of a node whose neighbours are the bonds from `first` to n, of n in the body.
///
/// Nodal strain (16): eps_I = sum_j w_j j (u_{I+j} - u_I) / A_n, A_n of the neighbours there are.
///
/// Stabilisation state (34): z_IJ = u_{I+j} - u_I - j eps_I on every bond. Its factor
/// G C_BB w_j / (sum of the w_j), in (38) G C_BB/(2n), is G (2/n^3) w_j / (sum of the w_j) in
/// the project's units, with C_BB = 2E/(h_1 delta^3) (10): G/n^4 at constant influence. Printed,
/// (41) mixes 1/dX^2 with G/dX^3; the dimensionless G here is the printed G over dX.
std::vector<ExactSquare> node_energy(int n, int first, std::span<const Rational> weights) {
    const auto weight_of = [&](int bond) { return weights[std::size_t(std::abs(bond) - 1)]; };
    Rational shape = 0;      // A_n of (16), n(n+1)(2n+1)/3 at constant influence in the body
    Rational influence = 0;  // of all bonds in the body, 2n at constant influence
    for (int j = -n; j <= n; ++j) {
        if (j != 0) {
            shape += j < first ? Rational(0) : Rational(j * j * weight_of(j));
            influence += weight_of(j);
        }
    }
    const auto is_there = [&](int bond) { return bond != 0 && bond >= first; };
    std::vector<Rational> strain(std::size_t(2 * n + 1));
    for (int j = first; j <= n; ++j) {
        if (is_there(j)) {
            strain[std::size_t(j + n)] = j * weight_of(j) / shape;
            strain[std::size_t(n)] -= strain[std::size_t(j + n)];
        }
    }
    std::vector<ExactSquare> energy{{EnergyPart::strain, constant(1), strain}};
    const Rational bond_constant(Integer(2), pow(Integer(n), 3));
    for (int bond = first; bond <= n; ++bond) {
        if (!is_there(bond)) {
            continue;
        }
        std::vector<Rational> state;
        for (int j = -n; j <= n; ++j) {
            state.push_back(int(j == bond) - int(j == 0) - bond * strain[std::size_t(j + n)]);
        }
        const Rational weight = bond_constant * weight_of(bond) / influence;
        energy.push_back({EnergyPart::stabilisation, Polynomial(std::vector<Rational>{0, weight}),
                          std::move(state)});
    }
    return energy;
}

}  // namespace

/// With x = i xi, (41) is  -omega^2 = 4 [(T/A)^2 + (G/n^4) (C - T^2/A)],
///     T = i S = sum_m m sinh(m x),   C = sum_m (cosh(m x) - 1),   A = A_n = 2 P_2.
/// It is the energy below: the strain is e(x) = 2T/A, its square -e^2, and the bonds' are
///     sum_b (exp(b x) - 1 - b e) (exp(-b x) - 1 + b e) = -4C + 4T e - A e^2 = -4 (C - T^2/A).
///
/// n(n+1)(2n+1) divides every P_{2k}, k >= 1 (Faulhaber), so that the coefficient of x^(2k+1) in
/// T/A is a polynomial in n of degree 2k, and those of x^(2k) in C and T^2/A are n times one of
/// degree 2k. This gives the pole 3 and the degrees that family.hpp asks for.
ClosedForms nopd1d_moments(unsigned count) {
    const std::vector<Polynomial> sums = power_sums(2 * count);
    const Polynomial shape = sums.at(2) * constant(2);
    const Polynomial n(std::vector<Rational>{0, 1});
    ClosedForms moments{.pole = 3, .functions = {}};
    std::vector<Polynomial> strain;  // of x, x^3, .. in T/A
    Rational factorial = 1;
    for (std::size_t k = 1; k <= count; ++k) {
        factorial *= 2 * k - 1;
        strain.push_back(sums[2 * k] / (shape * constant(factorial)));
        factorial *= 2 * k;
        Polynomial square;  // of x^(2k) in (T/A)^2
        for (std::size_t i = 0; i < k; ++i) {
            square += strain[i] * strain[k - 1 - i];
        }
        const Polynomial state = sums[2 * k] / constant(factorial) - shape * square;
        moments.functions.push_back({square * constant(4)});
        if (!state.is_zero()) {
            moments.functions.back().push_back(state * constant(4) / n);
        }
    }
    return moments;
}

Model nopd1d(unsigned horizon, std::span<const Rational> weights) {
    const int n = int(horizon);
    const bool constant_influence = std::ranges::count(weights, weights[0]) == n;
    return {
        .description = fmt::format("1D non-ordinary peridynamics, {}horizon {} dX, stabilisation G",
                                   constant_influence ? "constant influence, " : "", horizon),
        .source = "Nicely 2018: strain (16), stabilisation (34), symbol (41)",
        .energy = node_energy(n, -n, weights),
        .symbol = {},
        .damping = {}};
}

std::vector<ExactSquare> nopd1d_at_edge(unsigned horizon, unsigned layer) {
    const std::vector<Rational> constant_influence(horizon, Rational(1));
    return node_energy(int(horizon), -int(std::min(horizon, layer)), constant_influence);
}

SquaredFrequency nopd1d_limit(unsigned horizon, const Real& G, const Real& xi) {
    // (42) with both of its misprints corrected (docs/evidence/errata.md), d = delta xi:
    //     omega^2 = xi^2 p^2 - (4 G/delta^3) h,
    //     p = 3 (sin d - d cos d)/d^3,   h = sin d/d - 1 + d^2 p^2/6 = F/(2 d^4).
    // At dX = 1 the printed G, which the limit holds fixed, is G and delta is n.
    const Real delta = horizon;
    const Real d = delta * xi;
    const Real sine = sin(d);
    const Real p = 3 * (sine - d * cos(d)) / pow(d, 3);
    const Real p_slope = 3 * (sine / (d * d) - p / d);
    const Real h = sine / d - 1 + d * d * p * p / 6;
    const Real h_slope = d * (p * p + d * p * p_slope - p) / 3;  // (sin d/d)' = -d p/3
    const Real stiffness = 4 * G / pow(delta, 3);
    return {.value = xi * xi * p * p - stiffness * h,
            .slope = 2 * xi * p * (p + d * p_slope) - stiffness * delta * h_slope};
}

}  // namespace nmbcgen
