// SPDX-License-Identifier: MIT
/// The designer of passive edges.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <stdexcept>

#include "generator/passive/design.hpp"
#include "tests/support/nopd2d.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

EdgeTask task_at(double G, const PlaneLattice& lattice) {
    return {.node_energy =
                [](unsigned layer, const Rational& beta) {
                    return nopd2d_at_edge(of_paper(1), layer, beta);
                },
            .dimensions = 2,
            .reach = {},
            .g = g_of(G),
            .largest_beta = nopd2d_largest_beta(of_paper(1)),
            .highest_eigenvalue = highest_eigenvalue(lattice, 16)};
}

std::vector<WeightedWave> some_waves(const PlaneLattice& lattice) {
    std::vector<WeightedWave> waves;
    for (const double degrees : {0.0, 25.0, 50.0}) {
        for (const double xi : {0.1, 0.4, 0.8}) {
            for (const bool is_P : {true, false}) {
                waves.push_back({incident_wave(lattice, is_P, xi, radians(degrees)), 1});
            }
        }
    }
    return waves;
}

}  // namespace

TEST_CASE("a design is passive, reflects little, and keeps steps long") {
    for (const double G : {0.0, 0.6}) {
        const PlaneLattice lattice = lattice_of_paper(1, G);
        const EdgeTask task = task_at(G, lattice);
        const std::vector<double> speeds{lattice.speed_P, lattice.speed_S};
        const PassiveDesign design = design_edge(task, some_waves(lattice), speeds);
        CHECK_NOTHROW(require_passive(design, task.largest_beta));
        const PassiveEdge edge = edge_of(design, speeds);
        for (const Eigen::MatrixXd& dashpots : edge.dashpots) {
            CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dashpots).eigenvalues()(0) >
                  -1e-15);
        }
        // At most twice the interior's: the penalty begins at 1.3.
        CHECK(highest_eigenvalue_of_edge(task, edge, 16) < 2 * task.highest_eigenvalue);
        for (const bool is_P : {true, false}) {
            const auto reflected = [&](double degrees) {
                return reflected_by_edge(task, edge,
                                         incident_wave(lattice, is_P, 0.1, radians(degrees)));
            };
            // The published condition leaves .058 of S head-on.
            CHECK(reflected(0) < 0.02);
            CHECK(reflected(30) < 0.01);
        }
        CHECK(design_edge(task, some_waves(lattice), speeds).mass == design.mass);
    }
}

TEST_CASE("what is not passive is refused") {
    PassiveDesign design{.strain = {1, 1},
                         .stabilisation = {1, 1},
                         .mass = {{1, 1}, {1, 1}},
                         .factor = {},
                         .null_lagrangian = Rational(4, 5)};
    CHECK_NOTHROW(require_passive(design, Rational(4, 5)));
    CHECK_THROWS_AS(require_passive(design, Rational(3, 4)), std::logic_error);
    design.null_lagrangian = 0;
    design.mass[1][0] = 0;
    CHECK_THROWS_AS(require_passive(design, Rational(4, 5)), std::logic_error);
    design.mass[1][0] = 1;
    design.strain[1] = -1;
    CHECK_THROWS_AS(require_passive(design, Rational(4, 5)), std::logic_error);
}
