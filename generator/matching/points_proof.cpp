// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/points_proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "generator/exact/rational_function.hpp"
#include "generator/lattice/symbol.hpp"
#include "generator/matching/jet.hpp"
#include "generator/matching/real.hpp"

namespace nmbcgen {
namespace {

const Real tolerance("1e-30");  // c and b are rounded to 1e-31 of themselves

void require(bool holds, const MatchingPoint& point, const char* statement) {
    if (!holds) {
        throw std::logic_error(fmt::format("not proved at the matching point {}: {}",
                                           wave_number(point).str(6), statement));
    }
}

/// z^power in powers of i(xi - xi_p).
Jet<PreciseComplex> power_of_z(const Real& xi, const Real& power, std::size_t size) {
    Jet<PreciseComplex> jet(size);
    jet[0] = PreciseComplex(cos(power * xi), sin(power * xi));
    for (std::size_t k = 1; k < size; ++k) {
        jet[k] = jet[k - 1] * PreciseComplex(power / k);
    }
    return jet;
}

/// symbol[0] + sum symbol[m] (z^m + z^-m)
Jet<PreciseComplex> laurent_sum(const std::vector<Rational>& symbol, const Real& xi,
                                std::size_t size) {
    Jet<PreciseComplex> total(size, PreciseComplex(0));
    for (std::size_t m = 0; m < symbol.size(); ++m) {
        const PreciseComplex factor(m == 0 ? Real(symbol[0]) / 2 : Real(symbol[m]));
        for (const int sign : {-1, 1}) {
            total = sum(total, power_of_z(xi, Real(sign * int(m)), size), factor);
        }
    }
    return total;
}

std::vector<Rational> values_at_zero(const std::vector<Polynomial>& coefficients) {
    std::vector<Rational> result;
    result.reserve(coefficients.size());
    for (const Polynomial& coefficient : coefficients) {
        result.push_back(evaluate(coefficient, 0));
    }
    return result;
}

/// s of the wave that comes in.
Jet<PreciseComplex> incoming(const Table& table, const MatchingPoint& point) {
    const Real xi = wave_number(point);
    const std::size_t size = std::max(2U, point.multiplicity);
    const Jet<PreciseComplex> omega_squared =
        laurent_sum(values_at_zero(symbol_of(table)), xi, size);
    const Jet<PreciseComplex> tau_sigma = laurent_sum(table.model.damping, xi, size);
    const PreciseComplex half_step(Real(table.specification.time_step) / 2);
    // a s^2 + tau sigma s + omega^2 = 0
    const Jet<PreciseComplex> a =
        sum(sum(constant_jet(PreciseComplex(1), size), tau_sigma, PreciseComplex(-half_step)),
            omega_squared, PreciseComplex(-half_step * half_step));
    const Jet<PreciseComplex> discriminant =
        sum(product(tau_sigma, tau_sigma), product(a, omega_squared), PreciseComplex(-4));
    // d(omega^2)/d(xi) has the sign of the group velocity.
    const bool forwards = (PreciseComplex(0, 1) * omega_squared[1]).real() > 0;
    PreciseComplex root = sqrt(discriminant[0]);
    if ((root.imag() > 0) != forwards) {
        root = -root;
    }
    Jet<PreciseComplex> s =
        quotient(sum(square_root(discriminant, root), tau_sigma, PreciseComplex(-1)),
                 sum(a, a, PreciseComplex(1)));
    const PreciseComplex left = a[0] * s[0] * s[0] + tau_sigma[0] * s[0] + omega_squared[0];
    require(abs(left) < negligible, point, "s solves its equation");
    return s;
}

void prove_residual(const Table& table, const MatchingPoint& point) {
    const Jet<PreciseComplex> s = incoming(table, point);
    const Real xi = wave_number(point);
    Jet<PreciseComplex> residual(s.size(), PreciseComplex(0));
    std::vector<Real> size(s.size(), Real(0));
    for (std::size_t j = 0; j < table.c.size(); ++j) {
        const Jet<PreciseComplex> power =
            power_of_z(xi, Real(j * std::size_t(table.specification.stride)), s.size());
        const Jet<PreciseComplex> from_c = product(s, power);
        const Real c(evaluate(table.c[j], 0));
        const Real b(evaluate(table.b[j], 0));
        for (std::size_t r = 0; r < s.size(); ++r) {
            residual[r] += PreciseComplex(c) * from_c[r] - PreciseComplex(b) * power[r];
            size[r] += abs(PreciseComplex(c) * from_c[r]) + abs(PreciseComplex(b) * power[r]);
        }
    }
    PreciseComplex C_there = 0;
    Real size_of_C = 0;
    for (std::size_t j = 0; j < table.c.size(); ++j) {
        const Real c(evaluate(table.c[j], 0));
        C_there += PreciseComplex(c) *
                   power_of_z(xi, Real(j * std::size_t(table.specification.stride)), 1).front();
        size_of_C += abs(c);
    }
    require(abs(C_there) > tolerance * size_of_C, point, "C(z) is not zero");
    for (std::size_t r = 0; r < point.multiplicity; ++r) {
        require(abs(residual[r]) < tolerance * size[r], point, "the residual vanishes");
    }
}

}  // namespace

void prove_points(const Table& table) {
    for (const MatchingPoint& point : table.specification.points) {
        prove_residual(table, point);
    }
}

}  // namespace nmbcgen
