// SPDX-License-Identifier: GPL-2.0-or-later
/// One boundary as both sides see it: derived for the stability room, committed for the runtime.
#pragma once

#include <doctest/doctest.h>

#include <nmbc/tables/tables.hpp>

#include "generator/pipeline.hpp"
#include "generator/stability/half_space.hpp"

namespace nmbcgen::test {

/// NMBC of the 1D NOPD at a value of G.
struct Boundary {
    unsigned horizon, order, stride;
    double G;
};

inline HalfSpace half_space(const Boundary& boundary) {
    return make_half_space(
        derive({"nopd1d", boundary.horizon, boundary.order, boundary.stride, std::nullopt}),
        Rational(boundary.G));
}

inline const nmbc::MatchingTable& committed_table(const Boundary& boundary) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", int(boundary.horizon),
                                         int(boundary.order), int(boundary.stride));
    REQUIRE(table != nullptr);
    return *table;
}

/// Equal to within epsilon times the larger one: doctest's own scale would add epsilon itself.
inline doctest::Approx relative(double value, double epsilon) {
    return doctest::Approx(value).epsilon(epsilon).scale(0);
}

}  // namespace nmbcgen::test
