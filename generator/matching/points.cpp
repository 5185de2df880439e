// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/matching/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/matching/local.hpp"
#include "generator/matching/moebius.hpp"
#include "generator/matching/points_equations.hpp"

namespace nmbcgen {
namespace {

/// The unknowns are p_1 .. p_m of P(v), q_0 .. q_l of Q(v), v = y^power.
struct Shape {
    explicit Shape(const Table& table)
        : order(table.specification.order), power(table.model.damping.empty() ? 2 : 1) {}

    unsigned order;
    unsigned power;
    unsigned m = order / power;
    unsigned l = (order - 1) / power;
};

/// A row for every step-th power of the local variable in g P - Q.
template <class T>
void append_rows(Rows<T>& rows, const Local<T>& at, const Shape& shape, std::size_t step) {
    std::vector<Jet<T>> columns;
    Jet<T> term = at.g;
    for (unsigned k = 0; k < shape.m; ++k) {
        term = product(term, at.v);
        columns.push_back(term);
    }
    term = constant_jet(T(-1), at.g.size());
    for (unsigned k = 0; k <= shape.l; ++k) {
        columns.push_back(term);
        term = product(term, at.v);
    }
    for (std::size_t r = 0; r < at.g.size(); r += step) {
        std::vector<T> row;
        row.reserve(columns.size() + 1);
        for (const Jet<T>& column : columns) {
            row.push_back(column[r]);
        }
        row.push_back(T(0) - at.g[r]);
        rows.push_back(std::move(row));
    }
}

template <class T>
struct Polynomials {
    std::vector<T> C;
    std::vector<T> B;
};

/// Adds weight * (z - 1)^a (z + 1)^b to the polynomial.
template <class T>
void add_factors(std::vector<T>& polynomial, const T& weight, unsigned a, unsigned b) {
    const std::vector<T> factors = moebius_factors<T>(a, b);
    for (std::size_t j = 0; j < factors.size(); ++j) {
        polynomial[j] += weight * factors[j];
    }
}

/// C and B in z from p_1 .. p_m, q_0 .. q_l.
template <class T>
Polynomials<T> in_z(const std::vector<T>& unknowns, const Shape& shape) {
    Polynomials<T> result{std::vector<T>(shape.order + 1, T(0)),
                          std::vector<T>(shape.order + 1, T(0))};
    add_factors(result.C, T(1), 0, shape.order);
    for (unsigned k = 1; k <= shape.m; ++k) {
        add_factors(result.C, unknowns[k - 1], shape.power * k, shape.order - shape.power * k);
    }
    for (unsigned k = 0; k <= shape.l; ++k) {
        add_factors(result.B, unknowns[shape.m + k], shape.power * k + 1,
                    shape.order - shape.power * k - 1);
    }
    return result;
}

/// Over c_0.
void normalise(Polynomials<Real>& polynomials) {
    const Real first = polynomials.C.front();
    for (auto* const list : {&polynomials.C, &polynomials.B}) {
        for (Real& coefficient : *list) {
            coefficient /= first;
        }
    }
}

Rows<Rational> rows_at_zero(const Table& table, const Shape& shape) {
    const unsigned multiplicity = rows_at_zero(table.specification);
    Rows<Rational> rows;
    if (multiplicity > 1) {  // the residual has a factor y, for a row
        append_rows(rows, expand_at_zero(table, multiplicity - 1), shape, shape.power);
    }
    return rows;
}

Rows<Real> rows_at_points(const Table& table, const Shape& shape,
                          const std::vector<IncidentWave>& waves) {
    Rows<Real> rows;
    for (const IncidentWave& wave : waves) {
        if (shape.power == 2) {
            append_rows(rows, expand(table, wave), shape, 1);
            continue;
        }
        Rows<PreciseComplex> complex_rows;
        append_rows(complex_rows, expand_damped(table, wave), shape, 1);
        for (const auto& row : complex_rows) {
            std::vector<Real> real;
            std::vector<Real> imaginary;
            for (const PreciseComplex& entry : row) {
                real.push_back(entry.real());
                imaginary.push_back(entry.imag());
            }
            rows.push_back(std::move(real));
            rows.push_back(std::move(imaginary));
        }
    }
    return rows;
}

Real size_of(const Polynomials<Real>& matching) {
    Real size = 0;
    for (std::size_t j = 0; j < matching.C.size(); ++j) {
        size = std::max({size, Real(abs(matching.C[j])), Real(abs(matching.B[j]))});
    }
    return size;
}

/// P and Q may share a zero at a matching point: g P - Q = 0 then says nothing of g there.
void require_attained(const Polynomials<Real>& matching, const IncidentWave& wave,
                      unsigned stride) {
    PreciseComplex C_there = 0;
    for (std::size_t j = 0; j < matching.C.size(); ++j) {
        const Real phase = wave.xi * Real(j * std::size_t(stride));
        C_there += PreciseComplex(matching.C[j]) * PreciseComplex(cos(phase), sin(phase));
    }
    if (abs(C_there) < sqrt(negligible) * size_of(matching)) {
        throw NotMatched(fmt::format(
            "the only condition that meets all equations has C = B = 0 at xi = {}, and does not "
            "absorb that wave: without it, a lower order meets the others. Use other points, or "
            "another G.",
            wave.xi.str(6)));
    }
}

/// As degeneracy() of matching.hpp, of what is known to many digits; C(1) = 2^N.
void require_regular(const Polynomials<Real>& matching) {
    const Real size = size_of(matching);
    Real C_at_minus_one = 0;
    Real B_at_minus_one = 0;
    for (std::size_t j = 0; j < matching.C.size(); ++j) {
        C_at_minus_one += j % 2 == 0 ? matching.C[j] : Real(-matching.C[j]);
        B_at_minus_one += j % 2 == 0 ? matching.B[j] : Real(-matching.B[j]);
    }
    if (abs(matching.C.front()) < negligible * size) {
        throw NotMatched(
            "its coefficients have a pole there (c_0 = 1 is impossible). Use other points, or "
            "another G.");
    }
    if (abs(C_at_minus_one) < negligible * size && abs(B_at_minus_one) < negligible * size) {
        throw NotMatched("a condition of one order less meets all its equations. Use that.");
    }
}

/// Whether the doubles are those of the numbers that were rounded, which are right to 45 digits:
/// equations that are solved have pivots of 1e-60 at least, and entries of 105 digits.
bool same_doubles(const std::vector<ExactFunction>& rounded, const std::vector<Real>& full,
                  const Real& size) {
    const Rational margin(1, pow(Integer(10), 31));
    for (std::size_t j = 0; j < full.size(); ++j) {
        if (abs(full[j]) < sqrt(negligible) * size) {
            continue;  // zero but for roundings
        }
        const Rational value = evaluate(rounded[j], 0);
        const Rational error = margin * abs(value);
        if (abs(Real(value) - full[j]) > Real(error) ||
            nearest_double(value - error) != nearest_double(value + error)) {
            return false;
        }
    }
    return true;
}

std::vector<ExactFunction> over(const std::vector<Rational>& numerators,
                                const Rational& denominator) {
    std::vector<ExactFunction> result;
    result.reserve(numerators.size());
    for (const Rational& numerator : numerators) {
        result.push_back(reduce(constant(numerator), constant(denominator)));
    }
    return result;
}

}  // namespace

void match_at_points(Table& table) {
    const Shape shape(table);
    std::vector<IncidentWave> waves;
    for (const MatchingPoint& point : table.specification.points) {
        waves.push_back(incident_wave(table, point));
    }
    const Rows<Rational> at_zero = rows_at_zero(table, shape);
    const Rows<Real> at_points = rows_at_points(table, shape, waves);
    for (const unsigned digits : {40U, 80U}) {
        const Solution solution = solve(at_zero, at_points, digits);
        if (solution.full.empty()) {
            throw NotMatched(
                "its equations are singular, or next to it: several conditions, or none, meet "
                "them. Use other points, another order, stride or G.");
        }
        Polynomials<Real> full = in_z(solution.full, shape);
        require_regular(full);
        for (const IncidentWave& wave : waves) {
            require_attained(full, wave, table.specification.stride);
        }
        normalise(full);
        const Real size = size_of(full);
        const Polynomials<Rational> rounded = in_z(solution.rounded, shape);
        table.digits = digits;
        table.c = over(rounded.C, rounded.C.front());
        table.b = over(rounded.B, rounded.C.front());
        if (same_doubles(table.c, full.C, size) && same_doubles(table.b, full.B, size)) {
            return;
        }
    }
    throw NotMatched("80 digits do not do for its coefficients. Use fewer rows at fewer points.");
}

}  // namespace nmbcgen
