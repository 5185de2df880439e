// SPDX-License-Identifier: MIT
/// Cases 1 to 4 of Seleson 2011, and what each form keeps.
#include <doctest/doctest.h>

#include <Eigen/Core>
#include <stdexcept>

#include "generator/coupling/assembly.hpp"
#include "generator/coupling/equilibrium.hpp"
#include "generator/dense/decompositions.hpp"
#include "generator/exact/rational.hpp"

using namespace nmbcgen;
using enum CouplingForm;

namespace {

const Rational wide(3, 2);

Halves two_horizons(const Rational& left, const Rational& right) {
    return {1, 1, {1, left}, {1, right}};
}

Halves coarsened(int length) {
    return {1, length, {1, wide}, {1, wide}};
}

doctest::Approx digits(double value, double last) {
    return doctest::Approx(value).scale(0).epsilon(last / value);
}

}  // namespace

TEST_CASE("case 1: the displacement under a point load falls to that of the local bar, 1/4") {
    CHECK(displacement_at_load(Rational(1, 5)) == digits(.611094, 1e-6));
    CHECK(displacement_at_load(Rational(1, 10)) == digits(.354450, 1e-6));
    CHECK(displacement_at_load(Rational(1, 20)) == digits(.279721, 1e-6));
    CHECK(displacement_at_load(Rational(1, 40)) == digits(.258095, 1e-6));
    // A horizon of 1/1000 h is the local bar but for some 1e-4.
    CHECK(displacement_at_load(Rational(1, 80000)) == digits(.25, 1e-4));
}

TEST_CASE("case 2: at a material interface pairs tend to the local bar, and rows do not") {
    CHECK(material_interface_error(Rational(1, 5), pairs) == digits(.014745, 1e-6));
    CHECK(material_interface_error(Rational(1, 10), pairs) == digits(.007255, 1e-6));
    CHECK(material_interface_error(Rational(1, 20), pairs) == digits(.003511, 1e-6));
    // Rows have u'' = 0 there, a straight line from 0 to 1, which is 1/6 off.
    CHECK(material_interface_error(Rational(1, 5), rows) == digits(.181, 1e-3));
    CHECK(material_interface_error(Rational(1, 20), rows) == digits(.170, 1e-3));
}

TEST_CASE("case 3: two horizons fail the patch test in pairs and pass it in rows, exactly") {
    CHECK(patch_error(two_horizons(wide, wide / 2), pairs) == digits(.178056, 1e-6));
    CHECK(patch_error(two_horizons(wide, 0), pairs) > .3);
    CHECK(patch_error(two_horizons(wide, wide / 2), rows) == 0);
    CHECK(patch_error(two_horizons(wide, 0), rows) == 0);
    CHECK(patch_error(two_horizons(3, 0), rows) == 0);
}

TEST_CASE("case 4: one horizon on elements of two lengths passes it in both forms, exactly") {
    for (const int length : {1, 2, 4}) {
        CAPTURE(length);
        CHECK(patch_error(coarsened(length), pairs) == 0);
        CHECK(patch_error(coarsened(length), rows) == 0);
    }
}

TEST_CASE("in doubles it is passed but for roundings of the solution") {
    const Halves halves = coarsened(4);
    const Mesh mesh = mesh_of(halves, 12, 11);
    Eigen::VectorXd x(Eigen::Index(mesh.nodes.size()));
    std::vector<bool> held;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        x[i] = nearest_double(mesh.nodes[std::size_t(i)]);
        held.push_back(x[i] <= -10 || x[i] >= 40);
    }
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(x.size());
    const Eigen::VectorXd forces = stiffness_of(mesh, pairs) * x;
    CHECK(forces.segment(3, 19).lpNorm<Eigen::Infinity>() < 2e-14);
    const Eigen::VectorXd u = equilibrium(mesh, pairs, held, x, zero);
    CHECK((u - x).lpNorm<Eigen::Infinity>() < 1e-12);
}

TEST_CASE("pairs keep momentum and have an energy; rows do not, and sum up to nothing") {
    const Mesh mesh = mesh_of(two_horizons(3, 0), 30, 30);
    const Eigen::MatrixXd of_pairs = stiffness_of(mesh, pairs);
    const Eigen::MatrixXd of_rows = stiffness_of(mesh, rows);
    constexpr double roundings = 2e-15;
    CHECK(of_pairs.colwise().sum().lpNorm<Eigen::Infinity>() < roundings);
    CHECK((of_pairs - of_pairs.transpose()).lpNorm<Eigen::Infinity>() < roundings);
    CHECK(symmetric_eigenvalues(of_pairs).minCoeff() > -roundings);
    CHECK(of_rows.colwise().sum().lpNorm<Eigen::Infinity>() == digits(.2306, 1e-4));
    CHECK((of_rows - of_rows.transpose()).lpNorm<Eigen::Infinity>() == digits(.3997, 1e-4));
    // Rigid motions make no force in either form.
    CHECK(of_pairs.rowwise().sum().lpNorm<Eigen::Infinity>() < roundings);
    CHECK(of_rows.rowwise().sum().lpNorm<Eigen::Infinity>() < roundings);
}

TEST_CASE("a bar that nothing holds has no one equilibrium") {
    const Mesh mesh = mesh_of(two_horizons(0, 0), 2, 2);
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(5);
    CHECK_THROWS_AS(equilibrium(mesh, pairs, std::vector<bool>(5, false), zero, zero),
                    std::domain_error);
}
