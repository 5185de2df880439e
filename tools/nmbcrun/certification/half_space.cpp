// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/certification/half_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nmbc/coefficients.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"

namespace nmbcrun {
namespace {

nmbcgen::IntegerPolynomial exact(std::string_view list) {
    std::vector<nmbcgen::Integer> coefficients;
    nmbc::detail::for_each_integer(list, [&](std::size_t, std::string_view integer) {
        coefficients.emplace_back(std::string(integer));
    });
    return nmbcgen::IntegerPolynomial(std::move(coefficients));
}

std::vector<nmbcgen::ExactFunction> exact(std::span<const nmbc::RationalFunction> functions) {
    std::vector<nmbcgen::ExactFunction> result;
    for (const nmbc::RationalFunction& function : functions) {
        result.push_back({exact(function.numerator), exact(function.denominator)});
    }
    return result;
}

/// Family, horizon, order, stride, tau, time step, symbol, damping, c and b of the table; the rest
/// stays empty.
nmbcgen::Table exact_table(const nmbc::MatchingTable& table) {
    nmbcgen::Table result;
    result.specification = {.family = std::string(table.family),
                            .horizon = unsigned(table.horizon),
                            .order = unsigned(table.order),
                            .stride = unsigned(table.stride),
                            .stabilisation = {},
                            .damping = nmbcgen::parse_rational(table.tau),
                            .time_step = nmbcgen::parse_rational(table.time_step)};
    for (const nmbcgen::ExactFunction& function : exact(table.symbol)) {
        const nmbcgen::Rational divisor(function.denominator[0]);  // of a polynomial: a number
        result.model.symbol.push_back(nmbcgen::over_rationals(function.numerator) / divisor);
    }
    for (const nmbcgen::ExactFunction& number : exact(table.damping)) {
        result.model.damping.push_back(nmbcgen::evaluate(number, 0));
    }
    result.c = exact(table.c);
    result.b = exact(table.b);
    return result;
}

}  // namespace

nmbcgen::HalfSpace half_space_of(const nmbc::MatchingTable& table, double G) {
    return make_half_space(exact_table(table), nmbcgen::Rational(G));
}

bool has_pole_next_to(const nmbc::MatchingTable& table, double G) {
    const auto half_way_to = [G](double neighbour) {
        const nmbcgen::Rational sum = nmbcgen::Rational(G) + nmbcgen::Rational(neighbour);
        return nmbcgen::Rational(sum / 2);
    };
    const double infinity = std::numeric_limits<double>::infinity();
    const nmbcgen::Rational low = half_way_to(std::nextafter(G, -infinity));
    const nmbcgen::Rational high = half_way_to(std::nextafter(G, infinity));
    std::set<std::string_view> denominators;
    for (const auto functions : {table.c, table.b}) {
        for (const nmbc::RationalFunction& function : functions) {
            denominators.insert(function.denominator);
        }
    }
    return std::ranges::any_of(denominators, [&](std::string_view denominator) {
        return nmbcgen::count_real_roots(nmbcgen::over_rationals(exact(denominator)), low, high) >
               0;
    });
}

}  // namespace nmbcrun
