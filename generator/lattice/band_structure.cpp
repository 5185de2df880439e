// SPDX-License-Identifier: MIT
#include "generator/lattice/band_structure.hpp"

#include <algorithm>
#include <stdexcept>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/polynomial_gcd.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "generator/exact/resultant.hpp"
#include "generator/exact/sturm.hpp"
#include "generator/lattice/band.hpp"

namespace nmbcgen {
namespace {

/// The parameter itself, G or W.
Polynomial parameter() {
    return Polynomial(std::vector<Rational>{0, 1});
}

void require(bool holds, const char* statement) {
    if (!holds) {
        throw std::domain_error(statement);
    }
}

/// The coefficient of G^power in a polynomial in x.
Polynomial part(const InX& polynomial, std::size_t power) {
    std::vector<Rational> coefficients;
    for (const Polynomial& coefficient : polynomial) {
        coefficients.push_back(power < coefficient.size() ? coefficient[power] : Rational(0));
    }
    return Polynomial(std::move(coefficients));
}

std::size_t zeros_in_band(const Polynomial& in_x) {
    return count_real_roots(in_x, -1, 1, Ends::open);
}

/// 0 and the G > 0 at which the number of zeros of H in the band can change, ascending.
std::vector<AlgebraicNumber> critical_values(const InX& H) {
    Polynomial product = at(H, 1) * at(H, -1) * parameter();
    if (H.size() > 2) {
        product *= discriminant(H);
    }
    return real_roots(product, 0);
}

/// The number of zeros of H in the band above each critical value, up to the next.
std::vector<std::size_t> zeros_above(const std::vector<AlgebraicNumber>& critical, const InX& H) {
    std::vector<std::size_t> zeros;
    for (std::size_t i = 0; i < critical.size(); ++i) {
        const Rational G = i + 1 < critical.size() ? rational_between(critical[i], critical[i + 1])
                                                   : rational_above(critical[i]);
        zeros.push_back(zeros_in_band(at_parameter(H, G)));
    }
    return zeros;
}

/// The largest value of w(x) at the zeros of a polynomial in x.
AlgebraicNumber largest_value(const Polynomial& w, const Polynomial& zeros) {
    InX level = free_of_parameter(-w);  // W - w(x), the parameter being W
    level.front() += parameter();
    return real_roots(resultant(free_of_parameter(zeros), level), 0).back();
}

/// The polynomial without the common factor of its coefficients, which are integer then, as is
/// usual with the leading one of the last positive.
std::vector<Polynomial> primitive_part(const std::vector<Polynomial>& polynomial) {
    IntegerPolynomial common;
    for (const Polynomial& coefficient : polynomial) {
        if (!coefficient.is_zero()) {
            common = primitive_gcd(common, primitive(coefficient));
        }
    }
    std::vector<Polynomial> result;
    std::vector<Rational> all;
    for (const Polynomial& coefficient : polynomial) {
        result.push_back(coefficient / over_rationals(common));
        all.insert(all.end(), result.back().data().begin(), result.back().data().end());
    }
    const Polynomial together(all);  // its leading coefficient is that of the last
    const Rational scale = over_rationals(primitive(together)).data().back() / all.back();
    return plus({}, result, constant(scale));
}

/// The polynomial in W, coefficients in Q[G], whose roots are the values of omega^2 at the zeros
/// of H: the resultant of H and W - omega^2, interpolated in W, without its content.
std::vector<Polynomial> values_at_zeros(const InX& omega_squared, const InX& H) {
    const std::size_t degree = H.size() - 1;
    std::vector<Polynomial> differences;  // divided ones, at W = 0, 1, ..
    for (std::size_t W = 0; W <= degree; ++W) {
        differences.push_back(
            resultant(H, plus({constant(Rational(W))}, omega_squared, constant(-1))));
    }
    for (std::size_t order = 1; order <= degree; ++order) {
        for (std::size_t i = degree; i >= order; --i) {
            differences[i] = (differences[i] - differences[i - 1]) / constant(Rational(order));
        }
    }
    InX in_W;
    for (std::size_t i = degree + 1; i-- > 0;) {
        in_W = plus(times_x(in_W), in_W, constant(-Rational(i)));
        in_W.front() += differences[i];
    }
    trim(in_W);
    return primitive_part(in_W);
}

}  // namespace

BandStructure band_structure(const Model& model, unsigned horizon) {
    const InX omega_squared = band(model.symbol);
    const InX slope = derivative(omega_squared);
    require(!part(slope, 0).is_zero() && !part(slope, 1).is_zero() &&
                std::ranges::all_of(slope, [](const Polynomial& p) { return p.size() <= 2; }),
            "omega^2 is not linear in G with both parts");
    const Polynomial F =
        over_rationals(primitive_gcd(primitive(part(slope, 0)), primitive(part(slope, 1))));
    const Polynomial still = F * Polynomial(std::vector<Rational>{1, 1});  // and xi = pi
    require(zeros_in_band(F) + 1 == F.size(), "an extremum that does not move is no wave");
    require((part(omega_squared, 0) % still).is_zero(),
            "at an extremum that does not move, omega^2 is not a multiple of G");

    const InX H = plus(free_of_parameter(part(slope, 0) / F), free_of_parameter(part(slope, 1) / F),
                       parameter());
    const std::vector<AlgebraicNumber> critical = critical_values(H);
    std::vector<std::size_t> moving = zeros_above(critical, H);
    require(moving.back() == 0, "some extrema move at every large G");
    while (!moving.empty() && moving.back() == 0) {
        moving.pop_back();
    }
    const bool all_move =
        std::ranges::all_of(moving, [&H](std::size_t zeros) { return zeros + 1 == H.size(); });
    return {.horizon = horizon,
            .threshold = critical.at(moving.size()),
            .slope = largest_value(part(omega_squared, 1), still),
            .below = all_move ? values_at_zeros(omega_squared, H) : std::vector<Polynomial>()};
}

}  // namespace nmbcgen
