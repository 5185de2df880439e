// SPDX-License-Identifier: MIT
/// Edges that are passive by construction.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "generator/dense/decompositions.hpp"
#include "generator/exact/rational.hpp"
#include "generator/passive/design.hpp"
#include "generator/passive/edge.hpp"
#include "tests/support/nopd2d.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

const Rational largest_beta(4, 5);  // 2 mu

NodeEnergy at_edge(unsigned radius_squared) {
    return [radius_squared](unsigned layer, const Rational& beta) {
        return nopd2d_at_edge(of_paper(radius_squared), layer, beta);
    };
}

EdgeReach reach_of(unsigned radius_squared) {
    const auto node = Eigen::Index(std::sqrt(double(radius_squared)));
    return {.node = node, .forces = 2 * node, .layers = 2 * node};
}

/// As the lattice, without dashpots.
PassiveEdge plain(Eigen::Index layers) {
    return {.strain = Eigen::VectorXd::Ones(layers),
            .stabilisation = Eigen::VectorXd::Ones(layers),
            .mass = Eigen::MatrixXd::Ones(layers, 2),
            .dashpots = {2, Eigen::MatrixXd::Zero(layers, layers)},
            .null_lagrangian = 0};
}

}  // namespace

TEST_CASE("the layers behind an edge have the forces of the interior, whatever beta is") {
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 9U}) {
        const EdgeReach reach = reach_of(radius_squared);
        const EdgeEnergies energies =
            EdgeSquares(at_edge(radius_squared), reach.node, g_of(0.3), largest_beta)
                .energies(2, reach, 1.1);
        PassiveEdge edge = plain(reach.layers);
        edge.strain.setConstant(0.7);
        edge.null_lagrangian = 0.31;
        const Eigen::MatrixXd stiffness = energies.stiffness(edge);
        const LateralChain chain = lateral_chain(lattice_of_paper(radius_squared, 0.3), 1.1);
        // Nodes beyond the last ones are not there: forces from the left of them alone.
        const auto differs_at = [&](Eigen::Index layer) {
            Eigen::MatrixXd row = Eigen::MatrixXd::Zero(2, stiffness.cols() + 4 * reach.forces);
            for (Eigen::Index r = -reach.forces; r <= reach.forces; ++r) {
                row.middleCols(2 * (layer + r), 2) = chain.stiffness[std::size_t(r + reach.forces)];
            }
            const Eigen::Index whole = 2 * (reach.interior() - reach.node + 1);
            return (stiffness.middleRows(2 * layer, 2) - row.leftCols(stiffness.cols()))
                .leftCols(whole)
                .norm();
        };
        CHECK(differs_at(reach.interior()) < 1e-13);
        CHECK(differs_at(reach.interior() - 1) > 1e-3);
    }
}

TEST_CASE("energy of an edge is not negative for 0 <= beta <= 2 mu, and can be beyond") {
    for (const double wave_number : {0.0, 0.9, 2.4}) {
        const EdgeEnergies energies =
            EdgeSquares(at_edge(1), 1, g_of(0), largest_beta).energies(2, reach_of(1), wave_number);
        const auto lowest = [&](double beta) {
            PassiveEdge edge = plain(2);
            edge.strain << 0.3, 1.9;
            edge.null_lagrangian = beta;
            return symmetric_eigenvalues(energies.stiffness(edge)).minCoeff();
        };
        CHECK(lowest(0) > -1e-14);
        CHECK(lowest(0.8) > -1e-14);
        if (wave_number > 0) {
            CHECK(lowest(1.2) < -1e-3);
        }
    }
}

TEST_CASE("without dashpots an edge keeps the energy") {
    const PlaneLattice lattice = lattice_of_paper(4, 0.5);
    for (const double degrees : {0.0, 50.0}) {
        const ArrivingWave wave = arriving_wave(lattice, true, 0.6, radians(degrees));
        const Eigen::MatrixXcd matrix =
            edge_reflection(EdgeSquares(at_edge(4), 2, g_of(0.5), largest_beta)
                                .energies(2, reach_of(4), wave.wave_number),
                            plain(4), wave.outgoing, wave.omega);
        CHECK((matrix.adjoint() * matrix - Eigen::MatrixXcd::Identity(matrix.rows(), matrix.cols()))
                  .norm() < 1e-9);
    }
}

TEST_CASE("a design for waves up to 60 degrees, delta = 1, G = 0") {
    // Found by another program with E = 100, a_n = .953, a_t = .816, beta = .37 mu.
    const PlaneLattice lattice = lattice_of_paper(1, 0);
    PassiveEdge edge = plain(2);
    edge.strain << .437217, .953764;
    edge.mass << .530312, .461705, .870170, .956384;
    edge.dashpots[0] << 9.214847, .308659, .308659, .010377;
    edge.dashpots[1] << 4.343520, .391055, .391055, .035207;
    for (Eigen::MatrixXd& dashpots : edge.dashpots) {
        dashpots /= 10;  // sqrt(E)
    }
    edge.null_lagrangian = .37 * 2 / 5;
    CHECK(edge.dashpots[0].sum() == doctest::Approx(.953 * lattice.speed_P).epsilon(1e-3));
    CHECK(edge.dashpots[1].sum() == doctest::Approx(.816 * lattice.speed_S).epsilon(1e-3));
    struct Row {
        double angle, P, S;
    };
    const EdgeSquares squares(at_edge(1), 1, 0, largest_beta);
    for (const Row& row : {Row{0, 0, .010}, Row{20, 0, 0}, Row{40, .001, .001}, Row{60, .031, .064},
                           Row{70, .111, .177}, Row{80, .34, .43}}) {
        CAPTURE(row.angle);
        for (const bool is_P : {true, false}) {
            const ArrivingWave wave = arriving_wave(lattice, is_P, .1, radians(row.angle));
            const double reflected =
                edge_reflection(squares.energies(2, reach_of(1), wave.wave_number), edge,
                                wave.outgoing, wave.omega)
                    .col(wave.column)
                    .squaredNorm();
            // A tenth of it, or .002. Head-on, .010 of S is ((1 - a_t)/(1 + a_t))^2.
            CHECK(std::abs(reflected - (is_P ? row.P : row.S)) <
                  std::max(.002, .1 * (is_P ? row.P : row.S)));
        }
    }
}

namespace {

/// What the lattice, cut off, sends back of long waves, with dashpots on its outermost layer alone:
/// the sums of dashpots and beta decide.
class LongWaves {
  public:
    /// gamma = 2 mu - beta.
    LongWaves(double normal, double tangential, double gamma) : edge_(plain(2)) {
        edge_.dashpots[0](0, 0) = normal;
        edge_.dashpots[1](0, 0) = tangential;
        edge_.null_lagrangian = nearest_double(largest_beta) - gamma;
    }

    double reflected(bool is_P, double degrees) const {
        constexpr double xi = 1e-4;  // amplitudes differ by as much from those of xi = 0
        const ArrivingWave wave = arriving_wave(lattice_, is_P, xi, radians(degrees));
        return edge_reflection(squares_.energies(2, reach_of(1), wave.wave_number), edge_,
                               wave.outgoing, wave.omega)
            .col(wave.column)
            .squaredNorm();
    }

  private:
    PlaneLattice lattice_ = lattice_of_paper(1, 0.5);
    EdgeSquares squares_{at_edge(1), 1, g_of(0.5), largest_beta};
    PassiveEdge edge_;
};

}  // namespace

TEST_CASE(
    "a null Lagrangian couples P and S as Engquist and Majda do: amplitudes fall as angle^2") {
    const PlaneLattice lattice = lattice_of_paper(1, 0.5);
    const double P = lattice.speed_P;
    const double S = lattice.speed_S;
    const LongWaves side(P, S, P * S);  // beta = mu (2 - c_P/c_S)
    const LongWaves uncoupled(P, S, S * S);
    for (const bool is_P : {true, false}) {
        CAPTURE(is_P);
        CHECK(side.reflected(is_P, 0) < 1e-5);
        // The next order of the angle is 11 % of P's energy here, and 48 % from 8 to 16 degrees.
        CHECK(side.reflected(is_P, 8) / side.reflected(is_P, 4) ==
              doctest::Approx(16).epsilon(0.12).scale(0));
        CHECK(uncoupled.reflected(is_P, 8) > 10 * side.reflected(is_P, 8));
    }
}

TEST_CASE("one slowness along a side is let out of both P and S waves") {
    const PlaneLattice lattice = lattice_of_paper(1, 0.5);
    const double P = lattice.speed_P;
    const double S = lattice.speed_S;
    for (const double degrees : {20.0, 50.0}) {
        const double sine_P = std::sin(radians(degrees));
        const double cosine_P = std::cos(radians(degrees));
        const double sine_S = sine_P * S / P;
        const double cosine_S = std::sqrt(1 - sine_S * sine_S);
        const double gamma = P * P / (sine_P * sine_P + P / S * cosine_P * cosine_S);
        const LongWaves side(gamma * cosine_S / S, gamma * cosine_P / P, gamma);
        CHECK(side.reflected(true, degrees) < 1e-5);
        CHECK(side.reflected(false, std::asin(sine_S) / radians(1)) < 1e-5);
        CHECK(side.reflected(true, degrees + 15) > 1e-4);
    }
}

TEST_CASE("the chain of atoms has a passive end of fourth order in closed form") {
    // A spring and two masses: with x = (3 - sqrt 5)/2, kappa = sqrt(8 (sqrt 5 - 2)),
    // m_0 = x/kappa, m_1 = 1/2 + (1 - x)/kappa, c_0 = 1. One-dimensional, a bond belongs to the
    // node that is nearer to the end.
    const NodeEnergy bond = [](unsigned, const Rational&) {
        return std::vector<VectorSquare>{
            {EnergyPart::strain,
             Polynomial(std::vector<Rational>{1}),
             {{Offset{0, 0, 0}, {-1, 0, 0}}, {Offset{1, 0, 0}, {1, 0, 0}}}}};
    };
    const EdgeReach reach{.node = 1, .forces = 1, .layers = 2};
    const EdgeEnergies energies = EdgeSquares(bond, 1, 0, 0).energies(1, reach, 0);
    const double root = std::sqrt(5.0);
    const double x = (3 - root) / 2;
    const double spring = std::sqrt(8 * (root - 2));
    PassiveEdge edge{.strain = Eigen::Vector2d(spring, 1),
                     .stabilisation = Eigen::Vector2d::Ones(),
                     .mass = Eigen::Vector2d(x / spring, 0.5 + (1 - x) / spring),
                     .dashpots = {Eigen::Matrix2d::Zero()},
                     .null_lagrangian = 0};
    edge.dashpots[0](0, 0) = 1;
    const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
    const LateralChain chain{.stiffness = {-one, 2 * one, -one}, .damping = {}};
    struct Row {
        double xi, amplitude;
    };
    double before = 0;
    for (const auto& [xi, amplitude] :
         {Row{.05, 5.5e-8}, Row{.1, 8.7e-7}, Row{.2, 1.4e-5}, Row{.5, 5.4e-4}, Row{1, 8.6e-3}}) {
        const double omega = 2 * std::sin(xi / 2);
        const double found = std::abs(
            edge_reflection(energies, edge, outgoing_plane_modes(chain, omega), omega)(0, 0));
        CHECK(found == doctest::Approx(amplitude).scale(0).epsilon(0.02));
        if (xi == .1) {
            CHECK(std::log2(found / before) == doctest::Approx(4).epsilon(0.01));
        }
        before = found;
    }
}
