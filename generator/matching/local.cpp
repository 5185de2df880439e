// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/local.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "generator/exact/rational_function.hpp"
#include "generator/lattice/symbol.hpp"

namespace nmbcgen {
namespace {

template <class T>
T number(const Rational& value) {
    if constexpr (std::is_same_v<T, PreciseComplex>) {
        return PreciseComplex(Real(value));
    } else {
        return T(value);
    }
}

/// symbol[0] + 2 sum symbol[m] T_m(x), its coefficients at the table's G.
template <class T, class Coefficient>
Jet<T> even_sum(const std::vector<Coefficient>& symbol, const std::vector<Jet<T>>& chebyshev_of_x) {
    const std::size_t size = chebyshev_of_x.front().size();
    Jet<T> total = constant_jet(T(0), size);
    for (std::size_t m = 0; m < symbol.size(); ++m) {
        const Rational coefficient = evaluate(Polynomial(symbol[m]), 0);
        total = sum(total, chebyshev_of_x[m],
                    number<T>(m == 0 ? coefficient : Rational(2 * coefficient)));
    }
    return total;
}

/// What both kinds of lattices have at x_p + epsilon.
template <class T>
struct Lattice {
    Lattice(const Table& table, const T& x, unsigned size) {
        Jet<T> local = constant_jet(x, size);
        if (size > 1) {
            local[1] = T(1);
        }
        const unsigned stride = table.specification.stride;
        const auto polynomials =
            chebyshev(local, std::max<std::size_t>(table.model.symbol.size(), stride));
        one = constant_jet(T(1), size);
        omega_squared = even_sum(symbol_of(table), polynomials);
        tau_sigma = even_sum(table.model.damping, polynomials);
        y_squared =
            quotient(sum(polynomials[stride], one, T(-1)), sum(polynomials[stride], one, T(1)));
        half_step = number<T>(table.specification.time_step / 2);
    }
    Jet<T> one;
    Jet<T> omega_squared;
    Jet<T> tau_sigma;
    Jet<T> y_squared;  // -tan^2(h xi/2)
    T half_step;
};

}  // namespace

IncidentWave incident_wave(const Table& table, const MatchingPoint& point) {
    const Real xi = wave_number(point);
    const Real phase = sin(table.specification.stride * xi);
    if (abs(phase) < Real("1e-6")) {  // beyond, digits would be lost
        throw NotMatched(fmt::format(
            "with stride {} a wave of xi = {} looks like one of xi = 0 or pi to the condition, to "
            "1e-6",
            table.specification.stride, xi.str(6)));
    }
    const Lattice<Real> lattice(table, cos(xi), 2);
    const Real slope = -lattice.omega_squared[1];  // of omega^2, over sin xi
    if (abs(slope) < negligible) {
        throw NotMatched(fmt::format(
            "no wave comes in at xi = {}: its group velocity is zero there", xi.str(6)));
    }
    return {xi, point.multiplicity, slope > 0 ? 1 : -1, phase > 0 ? 1 : -1};
}

Local<Rational> expand_at_zero(const Table& table, std::size_t size) {
    Jet<Rational> cosh(size, Rational(0));  // of h X/2, X = i xi, and sinh/X
    Jet<Rational> sinh(size, Rational(0));
    Jet<Rational> s(size, Rational(0));  // over X
    Rational power = 1;                  // (h/2)^k / k!
    for (std::size_t k = 0; k < size; ++k) {
        const Rational next = power * table.specification.stride / (2 * (k + 1));
        if (k % 2 == 0) {
            cosh[k] = power;
            sinh[k] = next;
        }
        power = next;
        s[k] = evaluate(table.taylor[k], 0);
    }
    const Jet<Rational> y_over_X = quotient(sinh, cosh);
    Jet<Rational> y(size, Rational(0));
    std::copy(y_over_X.begin(), y_over_X.end() - 1, y.begin() + 1);
    return {quotient(s, y_over_X), table.model.damping.empty() ? product(y, y) : y};
}

// s^2 = -omega^2 / (1 - omega^2 dt^2/4), v = y^2.
Local<Real> expand(const Table& table, const IncidentWave& wave) {
    const Lattice<Real> lattice(table, cos(wave.xi), wave.multiplicity);
    const Jet<Real> in_steps =
        sum(lattice.one, lattice.omega_squared, Real(-lattice.half_step * lattice.half_step));
    const Jet<Real> minus_square =
        quotient(quotient(lattice.omega_squared, in_steps), lattice.y_squared);
    const Jet<Real> square = sum(constant_jet(Real(0), wave.multiplicity), minus_square, Real(-1));
    return {square_root(square, Real(wave.direction * wave.side * sqrt(square[0]))),
            lattice.y_squared};
}

// (1 - tau sigma dt/2 - omega^2 dt^2/4) s^2 + tau sigma s + omega^2 = 0, v = y.
Local<PreciseComplex> expand_damped(const Table& table, const IncidentWave& wave) {
    const Lattice<PreciseComplex> lattice(table, PreciseComplex(cos(wave.xi)), wave.multiplicity);
    const PreciseComplex half = lattice.half_step;
    const Jet<PreciseComplex> leading =
        sum(sum(lattice.one, lattice.tau_sigma, PreciseComplex(-half)), lattice.omega_squared,
            PreciseComplex(-half * half));
    const Jet<PreciseComplex> discriminant =
        sum(product(lattice.tau_sigma, lattice.tau_sigma), product(leading, lattice.omega_squared),
            PreciseComplex(-4));
    const PreciseComplex root = sqrt(discriminant[0]);
    if (abs(root.imag()) < negligible) {
        throw NotMatched(
            fmt::format("damped as much as here, no wave travels at xi = {}", wave.xi.str(6)));
    }
    const PreciseComplex first =
        (root.imag() > 0) == (wave.direction > 0) ? root : PreciseComplex(-root);
    const Jet<PreciseComplex> s =
        quotient(sum(square_root(discriminant, first), lattice.tau_sigma, PreciseComplex(-1)),
                 sum(leading, leading, PreciseComplex(1)));
    const Real h = table.specification.stride;
    const Jet<PreciseComplex> y =
        square_root(lattice.y_squared, PreciseComplex(0, tan(h * wave.xi / 2)));
    return {quotient(s, y), y};
}

}  // namespace nmbcgen
