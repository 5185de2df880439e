// SPDX-License-Identifier: GPL-2.0-or-later
/// The gate out of the algebra system.
#include <doctest/doctest.h>

#include <stdexcept>

#include "generator/matching/freeze.hpp"

using namespace nmbcgen;

TEST_CASE("freeze takes only polynomials over Q in its parameter") {
    const GiNaC::symbol G("G");
    const GiNaC::symbol other("G");  // same name, another symbol
    CHECK(thaw(freeze(3 * G * G - GiNaC::numeric(1, 2), G), G)
              .is_equal(3 * G * G - GiNaC::numeric(1, 2)));
    CHECK(freeze(0, G).is_zero());
    CHECK_THROWS_AS(freeze(other, G), std::logic_error);
    CHECK_THROWS_AS(freeze(1 / G, G), std::logic_error);
    CHECK_THROWS_AS(freeze(G * GiNaC::sqrt(GiNaC::numeric(2)), G), std::logic_error);
    CHECK_THROWS_AS(freeze(GiNaC::numeric(0.5), G), std::logic_error);
    CHECK_THROWS_AS(freeze(GiNaC::I * G, G), std::logic_error);
}
