// SPDX-License-Identifier: MIT
#include "generator/exact/exact_table.hpp"

#include <sstream>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

std::vector<Integer> integers(std::string_view list) {
    std::istringstream stream{std::string(list)};
    std::vector<Integer> result;
    for (std::string integer; stream >> integer;) {
        result.emplace_back(integer);
    }
    return result;
}

ExactFunction exact(const nmbc::RationalFunction& function) {
    return {IntegerPolynomial(integers(function.numerator)),
            IntegerPolynomial(integers(function.denominator))};
}

std::vector<ExactFunction> exact(std::span<const nmbc::RationalFunction> functions) {
    std::vector<ExactFunction> result;
    for (const nmbc::RationalFunction& function : functions) {
        result.push_back(exact(function));
    }
    return result;
}

Polynomial exact_polynomial(const nmbc::RationalFunction& function) {
    return over_rationals(exact(function).numerator) / Rational(std::string(function.denominator));
}

std::vector<Polynomial> exact_polynomials(std::span<const nmbc::RationalFunction> functions) {
    std::vector<Polynomial> result;
    for (const nmbc::RationalFunction& function : functions) {
        result.push_back(exact_polynomial(function));
    }
    return result;
}

ExactSquare exact(const nmbc::EnergySquare& square) {
    const Integer divisor{std::string(square.divisor)};
    ExactSquare result{square.part, exact_polynomial(square.weight), {}};
    for (const Integer& entry : integers(square.stencil)) {
        result.stencil.emplace_back(entry, divisor);
    }
    return result;
}

std::vector<Rational> weights(std::string_view list) {
    std::istringstream stream{std::string(list)};
    std::vector<Rational> result;
    for (std::string weight; std::getline(stream, weight, ',');) {
        result.push_back(parse_signed_rational(weight));
    }
    return result;
}

}  // namespace

Table exact_table(const nmbc::MatchingTable& table) {
    const nmbc::LatticeTable& lattice = *table.lattice;
    Table result;
    result.specification = {.family = std::string(lattice.family),
                            .horizon = unsigned(lattice.horizon),
                            .order = unsigned(table.order),
                            .stride = unsigned(table.stride),
                            .stabilisation = {},
                            .damping = parse_rational(lattice.tau),
                            .time_step = parse_rational(table.time_step),
                            .weights = weights(lattice.weights)};
    if (!table.fixed_G.empty()) {
        result.specification.stabilisation = parse_rational(table.fixed_G);
    }
    result.model.source = lattice.source;
    result.model.symbol = exact_polynomials(lattice.symbol);
    for (const Polynomial& number : exact_polynomials(lattice.damping)) {
        result.model.damping.push_back(evaluate(number, 0));
    }
    for (const nmbc::EnergySquare& square : lattice.energy) {
        result.model.energy.push_back(exact(square));
    }
    result.taylor = exact_polynomials(table.taylor);
    result.c = exact(table.c);
    result.b = exact(table.b);
    result.source = table.source;
    result.proved = table.proved;
    return result;
}

}  // namespace nmbcgen
