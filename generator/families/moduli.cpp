// SPDX-License-Identifier: MIT
#include "generator/families/moduli.hpp"

#include <fmt/format.h>

#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"

namespace nmbcgen {
namespace {

Rational poisson_of(const VectorChoice& choice) {
    Rational nu = choice.poisson.value_or(0);
    if (nu <= -1 || nu >= Rational(1, 2)) {
        throw NoSuchModel(fmt::format("Poisson's ratio {}: an isotropic solid needs -1 < nu < 1/2",
                                      to_string(nu)));
    }
    return nu;
}

}  // namespace

Moduli plane_moduli(const VectorChoice& choice) {
    const bool strain = choice.plane_strain;
    const Rational nu = poisson_of(choice);
    return {.bulk = strain ? 1 / (2 * (1 + nu) * (1 - 2 * nu)) : 1 / (2 * (1 - nu)),
            .shear = 1 / (2 * (1 + nu))};
}

Moduli solid_moduli(const VectorChoice& choice) {
    const Rational nu = poisson_of(choice);
    return {.bulk = 1 / (3 * (1 - 2 * nu)), .shear = 1 / (2 * (1 + nu))};
}

}  // namespace nmbcgen
