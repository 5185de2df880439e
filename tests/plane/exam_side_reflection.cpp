// SPDX-License-Identifier: MIT
/// What a side sends back, against the angle, and how it amplifies.
#include <doctest/doctest.h>

#include <array>
#include <complex>
#include <numbers>
#include <random>

#include "generator/dense/decompositions.hpp"
#include "generator/plane/sampled_growth.hpp"
#include "generator/plane/side_reflection.hpp"
#include "tests/support/nopd2d.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

constexpr double shift = 0.002;

double reflected(const PlaneLattice& lattice, const SideCondition& condition, bool is_P, double xi,
                 double degrees) {
    return reflected_in_plane(arriving_wave(lattice, is_P, xi, radians(degrees)), condition,
                              lateral_chain(lattice, 0).reach());
}

}  // namespace

TEST_CASE("reflected energy against the angle, delta = 1, G = 0, xi = .1") {
    struct Row {
        double angle;
        std::array<double, 2> printed, by_component, higdon;  // P, S
    };
    const PlaneLattice lattice = lattice_of_paper(1, 0);
    for (const Row& row :
         {Row{0, {0, .058}, {0, 0}, {0, 0}}, Row{20, {.001, .071}, {.004, .014}, {0, 0}},
          Row{40, {.011, .013}, {.026, .013}, {.001, 0}},
          Row{60, {.044, .010}, {.101, .036}, {.006, .001}},
          Row{70, {.095, .080}, {.196, .128}, {.024, .019}},
          Row{80, {.27, .31}, {.41, .37}, {.14, .15}}}) {
        CAPTURE(row.angle);
        for (const std::size_t wave : {0U, 1U}) {
            const auto check = [&](const SideCondition& condition, double expected) {
                // two or three digits are given
                CHECK(reflected(lattice, condition, wave == 0, .1, row.angle) ==
                      doctest::Approx(expected).scale(0.02).epsilon(0.03));
            };
            check(published_condition(lattice), row.printed[wave]);
            check(polarisation_wise_condition(lattice), row.by_component[wave]);
            check(higdon_condition(lattice, shift), row.higdon[wave]);
        }
    }
}

TEST_CASE("(81) has the speed of P for both components: long S waves come back head-on") {
    const PlaneLattice lattice = lattice_of_paper(1, 0.5);
    const double difference =
        (lattice.speed_P - lattice.speed_S) / (lattice.speed_P + lattice.speed_S);
    CHECK(difference == doctest::Approx(0.2405).epsilon(2e-4));
    constexpr double xi = 0.01;  // the next term is xi^2 smaller
    CHECK(reflected(lattice, published_condition(lattice), false, xi, 0) ==
          doctest::Approx(difference * difference).epsilon(1e-3));
    CHECK(reflected(lattice, polarisation_wise_condition(lattice), false, xi, 0) < 1e-9);
}

TEST_CASE("NMBC1 does depend on the angle it is matched at: (85) with cos alpha in place of 1") {
    // Of a scalar lattice |R| = |cos a - cos b|/(cos a + cos b), matched at b, a wave at a; here S
    // and P mix, so that at its own angle only one of both is let out: the P wave keeps its x
    // component, whose equation alone is matched.
    const PlaneLattice lattice = lattice_of_paper(1, 0.5);
    for (const double degrees : {30.0, 60.0}) {
        const double cosine = std::cos(radians(degrees));
        const SideCondition P_at_angle{
            {absorbs(lattice.speed_P / cosine), absorbs(lattice.speed_P / cosine)}};
        const SideCondition S_at_angle{
            {absorbs(lattice.speed_S / cosine), absorbs(lattice.speed_S / cosine)}};
        constexpr double xi = 0.02;
        CHECK(reflected(lattice, P_at_angle, true, xi, degrees) < 1e-6);
        CHECK(reflected(lattice, S_at_angle, false, xi, degrees) < 1e-6);
        CHECK(reflected(lattice, published_condition(lattice), true, xi, degrees) >
              1e3 * reflected(lattice, P_at_angle, true, xi, degrees));
    }
}

TEST_CASE("a product of two factors lets out a P wave at one angle and an S wave at another") {
    const PlaneLattice lattice = lattice_of_paper(4, 1);
    const ShiftPolynomial both = product(absorbs(lattice.speed_P / std::cos(radians(50))),
                                         absorbs(lattice.speed_S / std::cos(radians(25))));
    const SideCondition condition{{both, both}};
    CHECK(reflected(lattice, condition, true, 0.02, 50) < 1e-6);
    CHECK(reflected(lattice, condition, false, 0.02, 25) < 1e-6);
}

TEST_CASE("fixed ghost layers keep the energy, and their reflection is symmetric") {
    const PlaneLattice lattice = lattice_of_paper(4, 0.3);
    for (const double degrees : {0.0, 35.0, 70.0}) {
        const ArrivingWave wave = arriving_wave(lattice, false, 0.7, radians(degrees));
        const LateralChain chain = lateral_chain(lattice, wave.wave_number);
        const Eigen::MatrixXcd matrix =
            side_reflection(wave.outgoing, fixed_condition(), chain.reach(), wave.omega);
        const Eigen::Index size = matrix.rows();
        CHECK((matrix.adjoint() * matrix - Eigen::MatrixXcd::Identity(size, size)).norm() < 1e-9);
        // Shapes have phases of their own, so sizes alone are compared.
        CHECK((matrix.cwiseAbs() - matrix.transpose().cwiseAbs()).norm() < 1e-9);
    }
}

TEST_CASE("round trips between sides of (81), delta = 1") {
    // paired: at least what another program found on coarser samples, and no more than this
    // search finds on finer ones.
    struct Case {
        double G, least, most, alone;
    };
    constexpr std::size_t samples = 16;
    for (const Case& one : {Case{0, 1.745, 1.783, 1.991}, Case{.1, 1.569, 1.571, 1.575},
                            Case{.18, 1.010, 1.013, 1.250}, Case{.22, .9999, 1, 1.209},
                            Case{.25, .9999, 1, 1.176}, Case{.5, .997, 1, 1}}) {
        CAPTURE(one.G);
        const PlaneLattice lattice = lattice_of_paper(1, one.G);
        const LargestAmplification seen =
            largest_amplification(lattice, published_condition(lattice), samples);
        CHECK(seen.examined > seen.samples * 9 / 10);
        const Amplification found = seen.value;
        CHECK(found.paired >= one.least);
        CHECK(found.paired <= one.most + 1e-6);  // 1 is reached where waves stand
        // Next to waves that stand, where 1 is reached, the search ends a little early.
        CHECK(found.alone == doctest::Approx(one.alone).epsilon(5e-3));
        CHECK((found.paired > 1 + 1e-6) == (one.most > 1));
    }
}

TEST_CASE("no phases make a round trip larger than Takagi's, and some as large") {
    const PlaneLattice lattice = lattice_of_paper(1, 0.1);
    const SideCondition condition = published_condition(lattice);
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi);
    int examined = 0;
    for (const double wave_number : {0.5, 1.2, 2.0}) {
        for (const double time_step : {0.0, 0.7 * longest_step(lattice)}) {
            const LateralChain chain = lateral_chain(lattice, wave_number);
            for (const double omega : {0.6, 0.9, 1.1}) {
                const auto waves = outgoing_plane_modes(chain, omega);
                const auto found = amplification(chain, condition, omega, time_step);
                if (!found) {  // nothing travels
                    continue;
                }
                ++examined;
                const Eigen::MatrixXcd R =
                    side_reflection(waves, condition, chain.reach(), omega, time_step);
                double largest = 0;
                constexpr int tries = 4000;
                for (int i = 0; i < tries; ++i) {
                    Eigen::VectorXcd phases(R.cols());
                    for (std::complex<double>& phase : phases) {
                        phase = std::polar(1.0, angle(engine));
                    }
                    largest =
                        std::max(largest, eigenvalues(Eigen::MatrixXcd(R * phases.asDiagonal()))
                                              .cwiseAbs()
                                              .maxCoeff());
                }
                CAPTURE(wave_number);
                CAPTURE(omega);
                CHECK(largest < found->paired * (1 + 1e-9));
                CHECK(largest > 0.99 * found->paired);  // of two or four phases, so many tries
            }
        }
    }
    REQUIRE(examined == 14);  // of 18; nothing travels at the others
}

TEST_CASE("of long scalar waves NMBC1 sends back (1 - cos)/(1 + cos)") {
    for (const double degrees : {20.0, 40.0, 60.0, 80.0}) {
        CAPTURE(degrees);
        constexpr double xi = 0.02;
        const double across = 2 * std::sin(xi * std::cos(radians(degrees)) / 2);
        const double along = 2 * std::sin(xi * std::sin(radians(degrees)) / 2);
        const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
        const LateralChain chain{.stiffness = {-one, (2 + along * along) * one, -one},
                                 .damping = {}};
        const double omega = std::hypot(across, along);
        const auto R = side_reflection(outgoing_plane_modes(chain, omega),
                                       SideCondition{{absorbs(1), absorbs(1)}}, 1, omega);
        const double cosine = std::cos(radians(degrees));
        CHECK(std::abs(R(0, 0)) ==
              doctest::Approx((1 - cosine) / (1 + cosine)).epsilon(2 * xi * xi));  // of xi = 0
    }
}
