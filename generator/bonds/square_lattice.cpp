// SPDX-License-Identifier: MIT
#include "generator/bonds/square_lattice.hpp"

#include "generator/families/bond_lattice.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
namespace {

/// alpha of a unit weight, over pi.
Quadratic alpha_over_weight(unsigned horizon, const BondClass& bond) {
    const int square = bond[0] * bond[0] + bond[1] * bond[1];
    Quadratic factor = square_root(unsigned(square));
    factor *= Rational(5 * square * int(horizon * horizon * horizon), 48);
    return factor;
}

}  // namespace

std::vector<BondClass> square_bond_classes(unsigned horizon) {
    if (horizon < 2 || horizon > most_square_bonds) {
        throw std::invalid_argument("no such number of bonds");
    }
    std::vector<BondClass> classes;
    for (const Offset& bond : bond_classes_in_plane(horizon * horizon)) {
        classes.push_back({bond[0], bond[1]});
    }
    return classes;
}

std::vector<BondClass> members(const BondClass& bonds) {
    std::vector<BondClass> all;
    for (const Offset& bond : members_of_class({bonds[0], bonds[1], 0})) {
        all.push_back({bond[0], bond[1]});
    }
    return all;
}

std::array<Rational, 2> speeds_of_unit_weight(const BondClass& bonds) {
    std::array<Rational, 2> speeds{0, 0};
    for (const auto& [i, j] : members(bonds)) {
        speeds[0] += Rational(i * i * i * i, 2);
        speeds[1] += Rational(i * i * j * j, 2);
    }
    return speeds;
}

std::array<Rational, 2> mean_of_square_times_cosine(int m) {
    return m == 0 ? std::array<Rational, 2>{0, Rational(1, 3)}
                  : std::array<Rational, 2>{Rational(m % 2 == 0 ? 2 : -2) / (m * m), 0};
}

Real alpha_of_unit_weight(unsigned horizon, const BondClass& bond) {
    return value_of({Quadratic(0), alpha_over_weight(horizon, bond)});
}

BondCoefficient coefficient_of_weight(unsigned horizon, const BondClass& bond,
                                      const std::array<Quadratic, 2>& factors) {
    const Quadratic scale = alpha_over_weight(horizon, bond);
    for (const Quadratic& factor : factors) {
        if (scale.radicand() != 1 && factor.radicand() != 1 &&
            scale.radicand() != factor.radicand()) {
            return {double(weight_of(factors) * alpha_of_unit_weight(horizon, bond)), {}};
        }
    }
    const PiPolynomial alpha{Quadratic(0), scale * factors[0], Quadratic(0), scale * factors[1]};
    return {double(value_of(alpha)), alpha};
}

Real weight_of(const std::array<Quadratic, 2>& factors) {
    return value_of({factors[0], Quadratic(0), factors[1]});
}

}  // namespace nmbcgen
