// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/time_step.hpp"

#include <fmt/format.h>

#include "generator/exact/rational.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/damped.hpp"
#include "generator/stability/discrete.hpp"

namespace nmbcgen {

namespace {

/// With a condition that every lattice has.
HalfSpace lattice_of(const Specification& specification) {
    Specification first = specification;
    first.order = 1;
    first.stride = 1;
    first.time_step = 0;
    first.stabilisation.reset();
    first.points.clear();
    return make_half_space(derive(first), specification.stabilisation.value());
}

}  // namespace

double maximum_frequency(const Specification& specification) {
    return maximum_frequency(lattice_of(specification));
}

Rational time_step_below(double longest) {
    constexpr int parts = 1000;
    constexpr double roundings = 1 + 1e-12;
    return {floor(parts * Rational(longest * roundings)), parts};
}

Rational time_step_at(const Rational& cfl, const Specification& specification) {
    Rational time_step =
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
    const HalfSpace lattice =
        stepped(lattice_of(specification), nearest_double(specification.time_step));
    const double cfl = cfl_of(lattice, lattice.time_step);
    if (cfl >= 1 || (lattice.is_damped() && !interior_is_stable(lattice))) {
        throw NoSuchBoundary(fmt::format(
            "leapfrog itself is unstable in steps of {} dX/c at G = {}{}: cfl = {:.6g}, which has "
            "to be below 1{}",
            to_string(specification.time_step), to_string(*specification.stabilisation),
            lattice.is_damped() ? ", tau = " + to_string(specification.damping) : std::string(),
            cfl, lattice.is_damped() ? ", and less with damping" : ""));
    }
}

}  // namespace nmbcgen
