// SPDX-License-Identifier: MIT
/// The designer of passive edges.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "generator/dense/decompositions.hpp"
#include "generator/passive/design.hpp"
#include "generator/passive/edge_residuals.hpp"
#include "generator/passive/plane_side.hpp"
#include "tests/support/nopd2d.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

EdgeTask task_at(double G, const PlaneLattice& lattice) {
    const Rational largest_beta = nopd2d_largest_beta(of_paper(1));
    return {.squares = EdgeSquares(
                [](unsigned layer, const Rational& beta) {
                    return nopd2d_at_edge(of_paper(1), layer, beta);
                },
                EdgeReach{}.node, g_of(G), largest_beta),
            .dimensions = 2,
            .reach = {},
            .has_stabilisation = G != 0,
            .largest_beta = largest_beta,
            .highest_eigenvalue = highest_eigenvalue(lattice, 16)};
}

std::vector<WeightedWave> some_waves(const PlaneLattice& lattice) {
    std::vector<WeightedWave> waves;
    for (const double degrees : {0.0, 25.0, 50.0}) {
        for (const double xi : {0.1, 0.4, 0.8}) {
            for (const bool is_P : {true, false}) {
                waves.push_back({arriving_wave(lattice, is_P, xi, radians(degrees)), 1});
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
            CHECK(symmetric_eigenvalues(dashpots)(0) > -1e-15);
        }
        // At most twice the interior's: the penalty begins at 1.3.
        CHECK(highest_eigenvalue_of_edge(task, edge, 16) < 2 * task.highest_eigenvalue);
        for (const bool is_P : {true, false}) {
            const auto reflected = [&](double degrees) {
                return reflected_by_edge(task, edge,
                                         arriving_wave(lattice, is_P, 0.1, radians(degrees)));
            };
            // The published condition leaves .058 of S head-on.
            CHECK(reflected(0) < 0.02);
            CHECK(reflected(30) < 0.01);
        }
        CHECK(design_edge(task, some_waves(lattice), speeds).mass == design.mass);
    }
}

TEST_CASE("slopes of the residuals are their differences, near the lattice and far from it") {
    for (const double G : {0.0, 0.6}) {
        const PlaneLattice lattice = lattice_of_paper(1, G);
        EdgeTask task = task_at(G, lattice);
        task.light = 1;
        const std::vector<WeightedWave> waves = some_waves(lattice);
        const std::vector<double> speeds{lattice.speed_P, lattice.speed_S};
        const EdgeResiduals residuals(task, waves, speeds);
        Eigen::VectorXd at = residuals.start();
        at.head(2) << 1.3, -1.9;  // more than log 3 = 1.0986 away, on either side
        at.segment(2, 2).array() += 0.4;
        const Linearised here = residuals.at(at);
        for (Eigen::Index i = 0; i < at.size(); ++i) {
            CAPTURE(i);
            constexpr double step = 1e-5;
            Eigen::VectorXd before = at;
            Eigen::VectorXd after = at;
            before(i) -= step;
            after(i) += step;
            const Eigen::VectorXd difference =
                (residuals.at(after).values - residuals.at(before).values) / (2 * step);
            // Third derivatives and roundings leave 1e-10 times numbers up to some 100.
            CHECK((difference - here.slopes.col(i)).cwiseAbs().maxCoeff() < 1e-8);
        }
        // Their squares have no kink where the part beyond log 3 begins.
        const double begins = residuals.start()(1) + std::log(3);
        const auto slope_of_squares = [&](double logarithm) {
            at(1) = logarithm;
            const Linearised there = residuals.at(at);
            return there.slopes.col(1).dot(there.values);
        };
        CHECK(std::abs(slope_of_squares(begins + 1e-7) - slope_of_squares(begins - 1e-7)) < 1e-5);
    }
}

TEST_CASE("more layers reflect less, at wide angles too") {
    // Reflected energies at xi = 0.1 of a second order condition with one scalar more per boundary
    // node, which is not passive: 0/.001 head-on, .012/.012 at 60 degrees, .060/.059 at 70. Of this
    // side .042/.067 at 70, and of 2 layers .050/.065 at 60, .143/.179 at 70.
    const SideTask six{
        .family = "nopd2d", .choice = of_paper(1), .g = 0, .time_step = 0, .layers = 6};
    std::size_t done = 0;
    std::size_t most = 0;
    const DesignedSide side = passive_side(six, [&](std::size_t now, std::size_t all) {
        CHECK(now >= done);
        done = now;
        most = all;
    });
    CHECK(done > 0);
    CHECK(done <= most);
    CHECK_NOTHROW(require_passive(side.design, side.task.largest_beta));
    CHECK(side.design.strain.size() == 6);
    CHECK(side.highest_eigenvalue < 1.4 * side.task.highest_eigenvalue);
    const PlaneLattice lattice = lattice_of_paper(1, 0);
    const auto reflected = [&](bool is_P, double xi, double degrees) {
        return reflected_by_edge(side.task, side.edge, wave_at(lattice, is_P, xi, degrees));
    };
    for (const bool is_P : {true, false}) {
        CHECK(reflected(is_P, 0.1, 0) < 0.0001);
        // Most comes back at 35 degrees: 37.8 is the critical angle of S waves.
        for (const double degrees : {20.0, 30.0, 35.0, 40.0}) {
            CAPTURE(degrees);
            CHECK(reflected(is_P, 0.1, degrees) < 0.0055);
        }
        CHECK(reflected(is_P, 0.1, 60) < 0.012);
        CHECK(reflected(is_P, 0.1, 70) < 0.07);
    }
    CHECK_THROWS_AS(side_layers_checked(of_paper(1), 1), std::invalid_argument);
    CHECK_THROWS_AS(side_layers_checked(of_paper(9), 17), std::invalid_argument);
}

TEST_CASE("no motion beside an edge grows, and leapfrog is stable to its limit") {
    // The edge and 12 layers behind it, the next ones held; motions exp(i k_t y).
    constexpr double G = 0.6;
    const PlaneLattice lattice = lattice_of_paper(1, G);
    EdgeTask task = task_at(G, lattice);
    const std::vector<double> speeds{lattice.speed_P, lattice.speed_S};
    const PassiveEdge edge = edge_of(design_edge(task, some_waves(lattice), speeds), speeds);
    constexpr Eigen::Index layers = 14;
    task.reach.layers = layers;
    PassiveEdge deep{.strain = Eigen::VectorXd::Ones(layers),
                     .stabilisation = Eigen::VectorXd::Ones(layers),
                     .mass = Eigen::MatrixXd::Ones(layers, 2),
                     .dashpots = {},
                     .null_lagrangian = edge.null_lagrangian};
    deep.strain.head(2) = edge.strain;
    deep.stabilisation.head(2) = edge.stabilisation;
    deep.mass.topRows(2) = edge.mass;
    double highest = 0;
    for (const double wave_number : {0.0, 0.4, 1.3, 2.2, 3.1}) {
        constexpr Eigen::Index size = 2 * layers;
        const Eigen::MatrixXd K = task.at(wave_number).stiffness(deep).topLeftCorner(size, size);
        Eigen::VectorXd mass(size);
        Eigen::MatrixXd C = Eigen::MatrixXd::Zero(size, size);
        for (Eigen::Index I = 0; I < layers; ++I) {
            for (Eigen::Index a = 0; a < 2; ++a) {
                mass(2 * I + a) = deep.mass(I, a);
                for (Eigen::Index J = 0; I < 2 && J < 2; ++J) {
                    C(2 * I + a, 2 * J + a) = edge.dashpots[std::size_t(a)](I, J);
                }
            }
        }
        const Eigen::MatrixXd inverse_mass = mass.cwiseInverse().asDiagonal();
        Eigen::MatrixXd rates = Eigen::MatrixXd::Zero(2 * size, 2 * size);
        rates.topRightCorner(size, size).setIdentity();
        rates.bottomLeftCorner(size, size) = -inverse_mass * K;
        rates.bottomRightCorner(size, size) = -inverse_mass * C;
        CHECK(eigenvalues(rates).real().maxCoeff() < 1e-12);

        // u += dt v, and (M + dt C/2) v = (M - dt C/2) v - dt K u, as one map of (u, v).
        const auto radius_at = [&](double dt) {
            const Eigen::MatrixXd M = mass.asDiagonal();
            const Eigen::MatrixXd solve = inverse_of(Eigen::MatrixXd(M + dt / 2 * C));
            Eigen::MatrixXd step(2 * size, 2 * size);
            step.bottomLeftCorner(size, size) = -dt * solve * K;
            step.bottomRightCorner(size, size) = solve * (M - dt / 2 * C);
            step.topRows(size) = dt * step.bottomRows(size);
            step.topLeftCorner(size, size) += Eigen::MatrixXd::Identity(size, size);
            return eigenvalues(step).cwiseAbs().maxCoeff();
        };
        const double largest = eigenvalues(Eigen::MatrixXd(inverse_mass * K)).real().maxCoeff();
        CHECK(radius_at(0.99 * 2 / std::sqrt(largest)) < 1 + 1e-12);
        highest = std::max(highest, largest);
    }
    // As the design says it, for an edge with more behind it.
    task.reach.layers = 2;
    const double said = highest_eigenvalue_of_edge(task, edge, 32);
    CHECK(said > highest - 1e-9);
    CHECK(said < 1.05 * highest);
}

TEST_CASE("what is not passive is refused") {
    PassiveDesign design{.strain = {1, 1},
                         .stabilisation = {1, 1},
                         .mass = {{1, 1}, {1, 1}},
                         .factor = {},
                         .scale = {1, 1},
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
