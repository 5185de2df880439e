// SPDX-License-Identifier: GPL-2.0-or-later
/// Conditions with random matching points: each is proved as it is derived, or it is said why
/// there is none.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "generator/exact/rational_function.hpp"
#include "generator/pipeline.hpp"

using namespace nmbcgen;

namespace {

Specification random_specification() {
    Specification what{.horizon = *rc::gen::inRange(1U, 4U),
                       .order = *rc::gen::inRange(0U, 2U),
                       .stride = *rc::gen::inRange(1U, 4U),
                       .stabilisation = Rational(*rc::gen::inRange(0, 30), 10),
                       .damping = *rc::gen::element(Rational(0), Rational(1, 20)),
                       .time_step = *rc::gen::element(Rational(0), Rational(1, 10))};
    int sixteenth = 0;
    const auto points = *rc::gen::inRange(1, 4);
    for (int i = 0; i < points; ++i) {
        sixteenth += *rc::gen::inRange(1, 16);
        what.points.push_back({.wave_number = Rational(sixteenth, 16),
                               .of_pi = false,
                               .multiplicity = *rc::gen::inRange(1U, 3U)});
        what.order += what.points.back().multiplicity;
    }
    return what;
}

}  // namespace

TEST_CASE("what is derived is proved, symmetric, and rounds to the same doubles") {
    int tried = 0;
    int derived = 0;
    CHECK(rc::check([&] {
        ++tried;
        const Specification what = random_specification();
        try {
            const Table table = derive(what);  // throws std::logic_error where a proof fails
            ++derived;
            const std::size_t N = what.order;
            for (std::size_t j = 0; j <= N && what.damping == 0; ++j) {
                RC_ASSERT(table.c[j] == table.c[N - j]);
                RC_ASSERT(evaluate(table.b[j], 0) == -evaluate(table.b[N - j], 0));
            }
        } catch (const NoSuchBoundary&) {
            RC_SUCCEED("no such condition");
        }
    }));
    CHECK(2 * derived > tried);
}
