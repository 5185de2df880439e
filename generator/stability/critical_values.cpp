// SPDX-License-Identifier: MIT
#include "generator/stability/critical_values.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/algebraic_number.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"
#include "generator/exact/resultant.hpp"
#include "generator/lattice/band.hpp"

namespace nmbcgen {
namespace {

/// A polynomial in w = (x-1)/(x+1), times (x+1)^degree.
InX from_w(const std::vector<Polynomial>& in_w) {
    return at_quotient(in_w, in_w.size() - 1, {constant(-1), constant(1)},
                       {constant(1), constant(1)});
}

/// The polynomial without its zeros at x = 1, by Horner's division.
InX without_zeros_at_one(InX polynomial) {
    while (at(polynomial, 1).is_zero()) {
        for (std::size_t i = polynomial.size() - 1; i-- > 1;) {
            polynomial[i] += polynomial[i + 1];
        }
        polynomial.erase(polynomial.begin());
    }
    return polynomial;
}

std::vector<Polynomial> scalar_polynomials(const EvenAndOddParts& parts) {
    std::vector<Polynomial> polynomials{parts.denominator};
    for (const auto* f : {&parts.E, &parts.O}) {
        polynomials.push_back(f->back());
        polynomials.push_back(
            *std::ranges::find_if(*f, [](const Polynomial& p) { return !p.is_zero(); }));
        if (f->size() > 2) {
            polynomials.push_back(discriminant(*f));
        }
    }
    if (parts.E.size() > 1 && parts.O.size() > 1) {
        polynomials.push_back(resultant(parts.E, parts.O));
    }
    return polynomials;
}

}  // namespace

std::vector<AlgebraicNumber> positive_roots(std::vector<Polynomial> polynomials) {
    // What vanishes everywhere says nothing of any number.
    std::erase_if(polynomials, [](const Polynomial& polynomial) { return polynomial.is_zero(); });
    std::vector<AlgebraicNumber> roots;
    // One after the other: the polynomial of their product would be much longer.
    for (const Polynomial& polynomial : polynomials) {
        for (AlgebraicNumber& root : real_roots(square_free(polynomial), 0)) {
            if (compare(root, 0) != 0) {
                roots.push_back(std::move(root));
            }
        }
    }
    std::ranges::sort(roots, [](const AlgebraicNumber& left, const AlgebraicNumber& right) {
        return compare(left, right) < 0;
    });
    const auto same = [](const AlgebraicNumber& left, const AlgebraicNumber& right) {
        return compare(left, right) == 0;
    };
    roots.erase(std::unique(roots.begin(), roots.end(), same), roots.end());
    return roots;
}

std::vector<AlgebraicNumber> scalar_critical_values(const EvenAndOddParts& parts) {
    return positive_roots(scalar_polynomials(parts));
}

std::vector<AlgebraicNumber> modal_critical_values(const Table& table,
                                                   const EvenAndOddParts& parts) {
    std::vector<Polynomial> polynomials = scalar_polynomials(parts);
    const InX omega_squared = band(table.model.symbol);
    const InX slope = derivative(omega_squared);
    polynomials.push_back(slope.back());
    polynomials.push_back(at(slope, -1));
    if (slope.size() > 2) {
        polynomials.push_back(discriminant(slope));
    }
    // Where an evanescent wave at rest, omega(k) = 0, gets B(k) = 0, its s = B/C changes sign.
    const InX still = without_zeros_at_one(omega_squared);
    if (parts.O.size() > 1) {
        polynomials.push_back(resultant(still, from_w(parts.O)));
    }
    for (const auto* part : {&parts.E, &parts.O}) {
        const InX in_x = from_w(*part);
        if (in_x.size() > 1 && slope.size() > 1) {
            polynomials.push_back(resultant(in_x, slope));
        }
    }
    return positive_roots(std::move(polynomials));
}

std::vector<AlgebraicNumber> poles(const EvenAndOddParts& parts) {
    return real_roots(square_free(parts.denominator), 0);
}

std::vector<AlgebraicNumber> jordan_values(const EvenAndOddParts& parts) {
    // C(1) is E at w = 0. At a pole both may vanish.
    auto values = real_roots(square_free(parts.E.front()), 0);
    std::erase_if(values, [&](const AlgebraicNumber& value) {
        return sign_at(parts.denominator, value) == 0;
    });
    return values;
}

}  // namespace nmbcgen
