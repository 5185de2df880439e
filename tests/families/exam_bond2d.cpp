// SPDX-License-Identifier: GPL-2.0-or-later
/// 2D bond-based models: classes of bonds, long waves, projections.
#include <doctest/doctest.h>

#include "generator/exact/rational_function.hpp"
#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/lattice/force_constants.hpp"
#include "generator/lattice/projection.hpp"
#include "generator/lattice/symbol.hpp"

using namespace nmbcgen;

TEST_CASE("bonds of equal length are in classes of their own where no symmetry relates them") {
    using Classes = std::vector<Offset>;
    CHECK(bond_classes_in_plane(2) == Classes{{1, 0, 0}, {1, 1, 0}});
    CHECK(bond_classes_in_plane(9) ==
          Classes{{1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {3, 0, 0}});
    const Classes wide = bond_classes_in_plane(25);
    CHECK(Classes(wide.end() - 2, wide.end()) == Classes{{5, 0, 0}, {4, 3, 0}});
}

TEST_CASE("nearest and next-nearest bonds: long waves by hand") {
    // (1/2) sum over bonds of w (R . du)^2. Along x: w_1 of (1, 0), and (1, +-1) with R_x = 1:
    // c_P^2 = w_1 + 2 w_2; along y only the diagonals: c_S^2 = 2 w_2, as Cauchy's relation has it.
    const Rational w1(2, 3);
    const Rational w2(1, 5);
    const VectorModel model = bond2d({.radius_squared = 2, .weights = {w1, w2}});
    CHECK(model.energy.size() == 4);
    CHECK(speed_squared(model, 0) == constant(w1 + 2 * w2));
    CHECK(speed_squared(model, 1) == constant(2 * w2));
    // Each node of a chain is moved by its neighbours alone.
    const auto symbol = symbol_of(project(model, 1).energy);
    CHECK(symbol == std::vector<Polynomial>{constant(2), constant(-1)});
}

TEST_CASE("a rigid motion, small rotations among them, has no energy") {
    const VectorModel model = bond2d({.radius_squared = 5, .weights = {1, 2, 3, 4}});
    for (const VectorSquare& square : model.energy) {
        Rational along_x = 0;
        Rational along_y = 0;
        Rational turn = 0;
        for (const VectorTerm& term : square.terms) {
            along_x += term.factors[0];
            along_y += term.factors[1];
            turn += term.factors[1] * term.offset[0] - term.factors[0] * term.offset[1];
        }
        CHECK(along_x == 0);
        CHECK(along_y == 0);
        CHECK(turn == 0);
    }
}

TEST_CASE("models and projections that there are not") {
    CHECK_THROWS_WITH_AS(bond2d({.radius_squared = 2, .weights = {1}}),
                         "2 weights are needed, none of them 0: of the bonds (1, 0), (1, 1)",
                         NoSuchModel);
    CHECK_THROWS_AS(bond2d({.radius_squared = 2, .weights = {1, -1}}), NoSuchModel);
    const VectorModel axes = bond2d({.radius_squared = 1, .weights = {1}});
    CHECK_NOTHROW(project(axes, 0));
    CHECK_THROWS_AS(project(axes, 1), NoProjection);
}
