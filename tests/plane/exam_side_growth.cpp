// SPDX-License-Identifier: MIT
/// Modes of one side that grow by themselves, against wide strips, closed forms and a motion that
/// is put together.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "generator/dense/decompositions.hpp"
#include "generator/plane/plane_modes.hpp"
#include "generator/plane/side_growth.hpp"
#include "generator/plane/side_reflection.hpp"
#include "generator/plane/strip.hpp"
#include "tests/support/nopd2d.hpp"

using namespace nmbcgen;
using namespace nmbcgen::test;

namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double found_within = 5e-3;

/// Of these speeds; one below 0 makes what decays inwards grow.
SideCondition factors(double normal, double tangential) {
    return {{absorbs(normal), absorbs(tangential)}};
}

double strip_growth(const LateralChain& chain, const SideCondition& side, std::size_t layers) {
    return growth_in_strip(chain, {.left = side, .right = side, .layers = layers});
}

}  // namespace

TEST_CASE("of a shared condition the determinant is the product over the decaying modes") {
    for (const unsigned radius_squared : {1U, 2U, 4U}) {
        const PlaneLattice lattice = damped_lattice(radius_squared, 0.3, 0.02);
        const LateralChain chain = lateral_chain(lattice, 0.8);
        const SideCondition side = higdon_condition(lattice, 0.002);
        for (const Complex s : {Complex(0.3, 0.7), Complex(0.01, -1.2), Complex(2, 0.1)}) {
            Complex product = 1;
            for (const PlaneMode& mode : decaying_plane_modes(chain, s)) {
                product *= evaluate(side.residual[0], s, mode.z);
            }
            // of up to 12 factors, and a quotient of determinants
            CHECK(std::abs(growth_determinant(chain, side, s) - product) <
                  1e-9 * std::abs(product));
        }
    }
}

TEST_CASE("a chain of atoms: omega^2 = 2 - 2 cos xi, and the mode is known") {
    // s = 2 b (1 - z)/(1 + z) and s^2 = (1 - z)^2/z: 4 b^2 z = (1 + z)^2, so s^2 = 4 (b^2 - 1).
    const LateralChain chain{
        .stiffness = {Eigen::MatrixXd::Constant(1, 1, -1), Eigen::MatrixXd::Constant(1, 1, 2),
                      Eigen::MatrixXd::Constant(1, 1, -1)},
        .damping = std::vector<Eigen::MatrixXd>(3, Eigen::MatrixXd::Zero(1, 1))};
    for (const double b : {1.1, 1.5, 3.0}) {
        const double s = 2 * std::sqrt(b * b - 1);
        CHECK(growth_of_side(chain, factors(-b, -b)).value() ==
              doctest::Approx(s).epsilon(found_within).scale(0));
        CHECK(growing_modes(chain, factors(-b, -b), 0.9 * s) == 1);
        CHECK(growing_modes(chain, factors(-b, -b), 1.1 * s) == 0);
    }
}

TEST_CASE("a side that grows by itself grows as fast as wide strips do") {
    for (const unsigned radius_squared : {1U, 2U, 4U}) {
        for (const double tau : {0.0, 0.05}) {
            const PlaneLattice lattice = damped_lattice(radius_squared, 0, tau);
            for (const SideCondition& side :
                 {factors(-.5, -.5), factors(-.5, .5), factors(.3, -1)}) {
                for (const double wave_number : {0.0, 1.0}) {
                    const LateralChain chain = lateral_chain(lattice, wave_number);
                    const double rate = strip_growth(chain, side, 24);
                    CAPTURE(radius_squared);
                    CAPTURE(tau);
                    CAPTURE(wave_number);
                    // the strips tell it from one of them
                    CHECK(strip_growth(chain, side, 12) ==
                          doctest::Approx(rate).epsilon(2e-3).scale(0));
                    CHECK(growth_of_side(chain, side).value() ==
                          doctest::Approx(rate).epsilon(2 * found_within).scale(0));
                    CHECK(growth_of_side(chain, side, 2 * rate) == 2 * rate);  // none above
                }
            }
        }
    }
}

TEST_CASE("products of factors that absorb have no mode that grows, though their strips grow") {
    for (const unsigned radius_squared : {1U, 2U, 4U}) {
        for (const double G : {0.0, 1.0}) {
            const PlaneLattice lattice = lattice_of_paper(radius_squared, G);
            for (const double wave_number : {0.0, 0.3, 1.0, 2.2, 3.1}) {
                const LateralChain chain = lateral_chain(lattice, wave_number);
                CHECK(growth_of_side(chain, published_condition(lattice)) == 0);
                CHECK(growth_of_side(chain, higdon_condition(lattice, 0.002)) == 0);
            }
        }
    }
}

TEST_CASE("NMBC1 by component has a mode that grows at radius 3, slowly and with long waves") {
    const PlaneLattice lattice = lattice_of_paper(9, 0);
    const SideCondition side = polarisation_wise_condition(lattice);
    const LateralChain chain = lateral_chain(lattice, 1);
    const Complex s(0.000367406553111, 0.246653153542);
    CHECK(growth_of_side(chain, side).value() ==
          doctest::Approx(s.real()).epsilon(found_within).scale(0));
    CHECK(growing_modes(chain, side, 0.9 * s.real()) == 2);  // s and its conjugate

    // The motion itself, on ghosts and so many layers beside them.
    const auto reach = Index(chain.reach());
    const std::vector<PlaneMode> modes = decaying_plane_modes(chain, s);
    const Eigenpairs pairs = eigenpairs(conditions_on(modes, side, chain.reach(), s));
    Index least = 0;
    pairs.values.cwiseAbs().minCoeff(&least);
    const Index layers = 40;
    Eigen::MatrixXcd u = Eigen::MatrixXcd::Zero(2, 2 * reach + layers);  // from the last ghost on
    for (Index o = 0; o < 2 * reach; ++o) {
        const auto& [z, shape, speed] = modes[std::size_t(o)];
        for (Index layer = 0; layer < u.cols(); ++layer) {
            u.col(layer) += pairs.vectors(o, least) * std::pow(z, double(layer)) * shape;
        }
    }
    constexpr double roundings = 1e-10;  // s has 12 digits
    for (Index layer = reach; layer < reach + layers; ++layer) {
        Eigen::Vector2cd residual = s * s * u.col(layer);
        for (Index r = -reach; r <= reach; ++r) {
            residual += chain.stiffness[std::size_t(r + reach)] * u.col(layer + r);
        }
        CHECK(residual.norm() < roundings * u.norm());
    }
    for (Index ghost = 0; ghost < reach; ++ghost) {
        for (const Index a : {0, 1}) {
            Complex residual = 0;
            const ShiftPolynomial& condition = side.residual[std::size_t(a)];
            for (std::size_t p = 0; p < condition.size(); ++p) {
                for (std::size_t j = 0; j < condition[p].size(); ++j) {
                    residual += condition[p][j] * std::pow(s, double(p)) * u(a, ghost + Index(j));
                }
            }
            CHECK(std::abs(residual) < roundings * u.norm());
        }
    }
}
