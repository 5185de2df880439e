// SPDX-License-Identifier: MIT
#include "generator/families/moduli.hpp"

#include <fmt/format.h>

#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"

namespace nmbcgen {
namespace {

Rational poisson_below(const Rational& highest, const VectorChoice& choice, const char* where) {
    Rational nu = choice.poisson.value_or(0);
    if (nu <= -1 || nu >= highest) {
        throw NoSuchModel(fmt::format("Poisson's ratio {}: {} needs -1 < nu < {}", to_string(nu),
                                      where, to_string(highest)));
    }
    return nu;
}

}  // namespace

Moduli plane_moduli(const VectorChoice& choice) {
    const bool strain = choice.plane_strain;
    const Rational nu = poisson_below(strain ? Rational(1, 2) : Rational(1), choice,
                                      strain ? "plane strain" : "plane stress");
    return {.bulk = strain ? 1 / (2 * (1 + nu) * (1 - 2 * nu)) : 1 / (2 * (1 - nu)),
            .shear = 1 / (2 * (1 + nu))};
}

Moduli solid_moduli(const VectorChoice& choice) {
    const Rational nu = poisson_below(Rational(1, 2), choice, "a solid");
    return {.bulk = 1 / (3 * (1 - 2 * nu)), .shear = 1 / (2 * (1 + nu))};
}

}  // namespace nmbcgen
