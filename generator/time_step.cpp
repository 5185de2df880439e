// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/time_step.hpp"

#include <fmt/format.h>

#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/discrete.hpp"

namespace nmbcgen {

double maximum_frequency(const Specification& specification) {
    Specification lattice;  // with a condition that every lattice has
    lattice.family = specification.family;
    lattice.horizon = specification.horizon;
    return maximum_frequency(make_half_space(derive(lattice), specification.stabilisation.value()));
}

Rational time_step_below(double longest) {
    constexpr int parts = 1000;
    constexpr double roundings = 1 + 1e-12;
    return {floor(parts * Rational(longest * roundings)), parts};
}

Rational time_step_at(const Rational& cfl, const Specification& specification) {
    const Rational time_step =
        time_step_below(2 * nearest_double(cfl) / maximum_frequency(specification));
    if (time_step == 0) {
        throw NoSuchBoundary(fmt::format(
            "steps of cfl {} are below 1/1000 dX/c here: give --time-step", to_string(cfl)));
    }
    return time_step;
}

void require_leapfrog(const Specification& specification) {
    if (!specification.stabilisation || specification.time_step == 0) {
        return;
    }
    const double longest = 2 / maximum_frequency(specification);
    if (specification.time_step >= Rational(longest)) {
        throw NoSuchBoundary(fmt::format(
            "leapfrog itself is unstable in steps of {} dX/c at G = {}: they must be below {:.6g}",
            to_string(specification.time_step), to_string(*specification.stabilisation), longest));
    }
}

}  // namespace nmbcgen
