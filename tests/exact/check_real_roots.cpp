// SPDX-License-Identifier: GPL-2.0-or-later
/// Real roots of polynomials made of known factors.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <optional>

#include "tests/support/known_roots.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

TEST_CASE("the roots of random products are found again") {
    CHECK(rc::check("all of them, each with its own polynomial", [] {
        const Construction made = construct();
        const auto found = real_roots(made.polynomial, everywhere);
        RC_ASSERT(all_well_formed(found));
        RC_ASSERT(found.size() == made.roots.size());
        for (const AlgebraicNumber& number : found) {
            const KnownRoot& known = identify(number, made.roots);
            const Polynomial own = over_rationals(number.polynomial);
            RC_ASSERT((own % known.factor()).is_zero());
            RC_ASSERT((known.degree == 3 ? own.degree() >= 3 : own.degree() == known.degree));
            for (const KnownRoot& other : made.roots) {
                // No factor is left in the polynomial of a root it does not belong to.
                RC_ASSERT((other.degree == 3 || other.factor() == known.factor() ||
                           !(own % other.factor()).is_zero()));
            }
            RC_ASSERT(rounded_correctly(number));
            RC_ASSERT(to_text(number).empty() == (known.degree == 3));
        }
    }));
    CHECK(rc::check("counts, and roots between two limits", [] {
        const Construction made = construct();
        Rational low = *small_rational();
        Rational high = *small_rational();
        if (!made.roots.empty() && *rc::gen::arbitrary<bool>()) {
            low = made.roots.front().centre;  // often a root
        }
        const auto count = [&made](const auto& counted) {
            return std::size_t(std::ranges::count_if(made.roots, counted));
        };
        const auto closed =
            count([&](const KnownRoot& r) { return r.minus(low) >= 0 && r.minus(high) <= 0; });
        const auto open =
            count([&](const KnownRoot& r) { return r.minus(low) > 0 && r.minus(high) < 0; });
        const auto above = count([&](const KnownRoot& r) { return r.minus(low) >= 0; });
        RC_ASSERT(count_real_roots(made.polynomial, low, high) == closed);
        RC_ASSERT(count_real_roots(made.polynomial, low, high, Ends::open) == open);
        RC_ASSERT(count_real_roots(made.polynomial, low, std::nullopt) == above);
        const auto between = real_roots(made.polynomial, low, high);
        RC_ASSERT(between.size() == closed);
        RC_ASSERT(real_roots(made.polynomial, low).size() == above);
        for (const AlgebraicNumber& number : between) {
            RC_ASSERT(low <= number.low && number.high <= high);
        }
    }));
}
