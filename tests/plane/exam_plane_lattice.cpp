// SPDX-License-Identifier: MIT
/// A plane lattice in doubles, and the chain that waves along a side see.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "generator/dense/decompositions.hpp"
#include "generator/lattice/projection.hpp"
#include "tests/support/nopd2d.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

TEST_CASE("long waves have the speeds of plane stress") {
    const PlaneLattice lattice = lattice_of_paper(4, 1);
    CHECK(lattice.speed_P == doctest::Approx(std::sqrt(16.0 / 15)));
    CHECK(lattice.speed_S == doctest::Approx(std::sqrt(2.0 / 5)));
    constexpr double xi = 1e-3;  // the next term is xi^2 smaller
    const Eigen::VectorXd squares = symmetric_eigenvalues(
        dynamical_matrix(lattice.bonds, {xi * std::cos(0.4), xi * std::sin(0.4)}).value);
    CHECK(std::sqrt(squares(1)) / xi == doctest::Approx(lattice.speed_P));
    CHECK(std::sqrt(squares(0)) / xi == doctest::Approx(lattice.speed_S));
}

TEST_CASE("a wave of the plane is one of the chain of layers") {
    for (const unsigned radius_squared : {1U, 2U, 5U, 9U}) {
        const PlaneLattice lattice = lattice_of_paper(radius_squared, 0.7);
        const Eigen::Vector2d wave_vector(0.8, 1.9);
        const LateralChain chain = lateral_chain(lattice, wave_vector.y());
        Eigen::Matrix2cd matrix = Eigen::Matrix2cd::Zero();
        const auto reach = int(chain.reach());
        for (int r = -reach; r <= reach; ++r) {
            const auto layer = std::size_t(r + reach);
            matrix += std::polar(1.0, r * wave_vector.x()) * chain.stiffness[layer];
            CHECK((chain.stiffness[layer] - chain.stiffness[std::size_t(reach - r)].transpose())
                      .norm() < 1e-14);
        }
        Eigen::VectorXd of_chain = eigenvalues(Eigen::MatrixXcd(matrix)).real();
        std::ranges::sort(of_chain);
        const Eigen::VectorXd of_plane =
            symmetric_eigenvalues(dynamical_matrix(lattice.bonds, wave_vector).value);
        CHECK((of_chain - of_plane).norm() < 1e-13);
    }
}

TEST_CASE("damping is tau times the stabilisation at g = 1") {
    const VectorModel model = nopd2d(of_paper(2));
    const PlaneLattice damped = plane_lattice(model, 0, Rational(3, 2));
    const PlaneLattice stiff = plane_lattice(model, 1, 0);
    const PlaneLattice plain = plane_lattice(model, 0, 0);
    for (std::size_t i = 0; i < damped.bonds.size(); ++i) {
        const Eigen::Matrix2d stabilisation = stiff.bonds[i].stiffness - plain.bonds[i].stiffness;
        CHECK((damped.bonds[i].damping - 1.5 * stabilisation).norm() < 1e-14);
    }
}

TEST_CASE("a model whose S waves do not travel has no speeds") {
    const VectorModel bonds = bond2d({.radius_squared = 1, .weights = {1}});
    CHECK_THROWS_AS(plane_lattice(bonds, 0, 0), NoProjection);
}
