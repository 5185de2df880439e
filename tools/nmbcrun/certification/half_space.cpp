// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/certification/half_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "generator/exact/exact_table.hpp"
#include "generator/exact/rational_function.hpp"
#include "generator/exact/real_roots.hpp"

namespace nmbcrun {

nmbcgen::HalfSpace half_space_of(const nmbc::MatchingTable& table, double G) {
    return make_half_space(nmbcgen::exact_table(table), nmbcgen::Rational(G));
}

bool has_pole_next_to(const nmbc::MatchingTable& table, double G) {
    const auto half_way_to = [G](double neighbour) {
        const nmbcgen::Rational sum = nmbcgen::Rational(G) + nmbcgen::Rational(neighbour);
        return nmbcgen::Rational(sum / 2);
    };
    const double infinity = std::numeric_limits<double>::infinity();
    const nmbcgen::Rational low = half_way_to(std::nextafter(G, -infinity));
    const nmbcgen::Rational high = half_way_to(std::nextafter(G, infinity));
    const nmbcgen::Table exact = nmbcgen::exact_table(table);
    std::vector<nmbcgen::IntegerPolynomial> denominators;
    for (const auto* functions : {&exact.c, &exact.b}) {
        for (const nmbcgen::ExactFunction& function : *functions) {
            if (std::ranges::find(denominators, function.denominator) == denominators.end()) {
                denominators.push_back(function.denominator);
            }
        }
    }
    return std::ranges::any_of(denominators, [&](const nmbcgen::IntegerPolynomial& denominator) {
        return nmbcgen::count_real_roots(nmbcgen::over_rationals(denominator), low, high) > 0;
    });
}

}  // namespace nmbcrun
