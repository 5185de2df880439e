// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/dispersion.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

Model model_of(const Curves& curves, std::size_t which) {
    const std::vector<Rational> constant_influence;
    return make_model(curves.family, curves.horizons.at(which), 0,
                      curves.weights.empty() ? constant_influence : curves.weights.at(which));
}

struct Wave {
    Real xi;
    Real omega;
    Real group_velocity;
};

/// The symbol at one G: exactly, and rounded.
struct Symbol {
    std::vector<Rational> exact;
    std::vector<Real> rounded;
};

Symbol symbol_at(const std::vector<Polynomial>& symbol, const Rational& G) {
    Symbol at;
    for (const Polynomial& coefficient : symbol) {
        at.exact.push_back(evaluate(coefficient, G));
        at.rounded.emplace_back(at.exact.back());
    }
    return at;
}

Wave wave(const Real& xi, const SquaredFrequency& square) {
    const Real omega = sqrt(square.value);
    return {.xi = xi, .omega = omega, .group_velocity = square.slope / (2 * omega)};
}

/// Where omega vanishes it is |v (xi - xi_0)|, v^2 half the second derivative of omega^2.
Wave wave_from_zero(const Real& xi, const Real& half_curvature) {
    return {.xi = xi, .omega = 0, .group_velocity = -sqrt(half_curvature)};
}

Wave lattice_wave(const std::vector<Real>& symbol, const Real& xi) {
    static const Real zero("1e-60");  // half of the digits; omega^2 has a double zero
    const Real cosine = cos(xi);
    const Real sine = sin(xi);
    Real cosine_m = 1;  // of m xi
    Real sine_m = 0;
    SquaredFrequency sum{.value = symbol[0], .slope = 0};
    Real half_curvature = 0;
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        const Real turned = cosine_m * cosine - sine_m * sine;
        sine_m = sine_m * cosine + cosine_m * sine;
        cosine_m = turned;
        sum.value += 2 * symbol[m] * cosine_m;
        sum.slope -= 2 * symbol[m] * m * sine_m;
        half_curvature -= symbol[m] * m * m * cosine_m;
    }
    return sum.value < zero ? wave_from_zero(xi, half_curvature) : wave(xi, sum);
}

/// At xi = pi, where cos(m xi) = (-1)^m: exactly, since omega may vanish there. omega^2 is even
/// about pi, so its slope is 0 otherwise.
Wave wave_at_pi(const std::vector<Rational>& symbol) {
    Rational square = symbol[0];
    Rational half_curvature = 0;
    for (std::size_t m = 1; m < symbol.size(); ++m) {
        const Rational term = m % 2 == 0 ? symbol[m] : Rational(-symbol[m]);
        square += 2 * term;
        half_curvature -= Rational(m * m) * term;
    }
    return square == 0 ? wave_from_zero(pi(), Real(half_curvature))
                       : Wave{.xi = pi(), .omega = sqrt(Real(square)), .group_velocity = Real(0)};
}

std::string row(const std::string& curve, const Wave& wave) {
    // {} prints the shortest text that is read as the same double again.
    return fmt::format("{},{},{},{},{}\n", curve, double(wave.xi), double(wave.omega),
                       double(Real(wave.omega / wave.xi)), double(wave.group_velocity));
}

}  // namespace

std::string dispersion_rows(const Curves& curves, std::size_t which, const Rational& G) {
    const unsigned horizon = curves.horizons.at(which);
    const auto xi = [&](unsigned i) { return Real(pi() * i / curves.samples); };
    const std::string curve = fmt::format("{},{}", horizon, nearest_double(G));

    const Symbol symbol = symbol_at(model_of(curves, which).symbol, G);
    std::string csv;
    for (unsigned i = 1; i < curves.samples; ++i) {
        csv += row("lattice," + curve, lattice_wave(symbol.rounded, xi(i)));
    }
    csv += row("lattice," + curve, wave_at_pi(symbol.exact));
    if (curves.limit) {
        const auto limit = find_family(curves.family).limit;
        const Real stabilisation = Real(G);
        for (unsigned i = 1; i <= curves.samples; ++i) {
            csv += row("limit," + curve, wave(xi(i), limit(horizon, stabilisation, xi(i))));
        }
    }
    return csv;
}

void require_models(const Curves& curves) {
    for (std::size_t which = 0; which < curves.horizons.size(); ++which) {
        model_of(curves, which);
    }
}

void require_limit(const Family& family) {
    if (family.limit == nullptr) {
        throw std::invalid_argument("the family " + std::string(family.name) +
                                    " states no continuum limit");
    }
}

}  // namespace nmbcgen
