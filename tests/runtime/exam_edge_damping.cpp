// SPDX-License-Identifier: MIT
/// True ends on the outermost node of a damped lattice.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "generator/dense/decompositions.hpp"

namespace {

using nmbc::Closure;
using nmbc::OnSurface;
using nmbc::SurfaceEnd;

/// nopd1d with the damping tau sigma.
nmbc::Lattice damped_nopd(int horizon, double G, double tau) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1, 1);
    const auto at_0 = nmbc::make_lattice(*table, 0).symbol;
    auto lattice = nmbc::make_lattice(*table, G);
    lattice.damping = nmbc::make_lattice(*table, 1).symbol;
    for (std::size_t m = 0; m < at_0.size(); ++m) {
        lattice.damping[m] = tau * (lattice.damping[m] - at_0[m]);
    }
    return lattice;
}

/// The longest steps of a chain with this end [dX/c].
double longest_step(const nmbc::Lattice& lattice, Closure closure, OnSurface given,
                    std::size_t nodes) {
    const double beside = 2 / std::sqrt(nmbc::largest_eigenvalue(lattice, closure, given, nodes));
    const double inside = 2 * nmbc::interior_cfl(lattice) / nmbc::maximum_frequency(lattice);
    return std::min(beside, inside);
}

nmbc::Chain started(const nmbc::Lattice& lattice, const nmbc::ChainEnd& end,
                    const nmbc::ChainParameters& p) {
    nmbc::Chain chain(lattice, end, p);
    std::mt19937 random(7);  // NOLINT(cert-msc32-c, cert-msc51-cpp): the same every time
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<double> u(chain.nodes());
    std::vector<double> v(chain.nodes());
    std::ranges::generate(u, [&] { return any(random); });
    std::ranges::generate(v, [&] { return any(random); });
    chain.start(u, v);
    chain.step();
    return chain;
}

/// What u and v of the nodes that move do to v by a chain's own steps.
class Rates {
  public:
    Rates(const nmbc::Lattice& lattice, const SurfaceEnd& end, std::size_t in_all, double step) {
        nmbc::Chain chain(lattice, end, {.nodes = in_all, .time_step = step});
        const std::size_t held = end.given == OnSurface::displacement ? 1 : 0;
        const std::size_t nodes = in_all - 2 * held;
        const std::size_t first = chain.first_interior() + held;
        const auto column = [&](std::span<double> of, std::size_t node) {
            std::ranges::fill(chain.displacement(), 0.0);
            std::ranges::fill(chain.velocity(), 0.0);
            of[first + node] = 1;
            const bool is_velocity = of.data() == chain.velocity().data();
            chain.step();
            Eigen::VectorXd change(nodes);
            for (std::size_t i = 0; i < nodes; ++i) {
                change[Eigen::Index(i)] =
                    (chain.velocity()[first + i] - (is_velocity && i == node ? 1 : 0)) / step;
            }
            return change;
        };
        by_u_.resize(Eigen::Index(nodes), Eigen::Index(nodes));
        by_v_ = by_u_;
        for (std::size_t node = 0; node < nodes; ++node) {
            by_u_.col(Eigen::Index(node)) = column(chain.displacement(), node);
            by_v_.col(Eigen::Index(node)) = column(chain.velocity(), node);
        }
    }

    /// Of leapfrog in such steps.
    double spectral_radius(double step) const {
        const auto nodes = by_u_.rows();
        const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(nodes, nodes);
        Eigen::MatrixXd whole(2 * nodes, 2 * nodes);
        whole.bottomLeftCorner(nodes, nodes) = step * by_u_;
        whole.bottomRightCorner(nodes, nodes) = one + step * by_v_;
        whole.topRows(nodes) = step * whole.bottomRows(nodes);
        whole.topLeftCorner(nodes, nodes) += one;
        return nmbcgen::eigenvalues(whole).cwiseAbs().maxCoeff();
    }

  private:
    Eigen::MatrixXd by_u_;
    Eigen::MatrixXd by_v_;
};

}  // namespace

TEST_CASE("on true ends, too, the staggered energy loses what the damping takes") {
    for (const Closure closure : {Closure::sbp, Closure::cut, Closure::node_mirror}) {
        for (const OnSurface given : {OnSurface::traction, OnSurface::displacement}) {
            for (int n = 1; n <= 3; ++n) {
                for (const double G : {0.0, 0.8}) {
                    CAPTURE(static_cast<int>(closure));
                    CAPTURE(static_cast<int>(given));
                    CAPTURE(n);
                    CAPTURE(G);
                    const auto lattice = damped_nopd(n, G, 0.2);
                    const double dt = longest_step(lattice, closure, given, 40);
                    auto chain = started(lattice, SurfaceEnd{.closure = closure, .given = given},
                                         {.nodes = 40,
                                          .spacing = 0.5,
                                          .youngs_modulus = 3,
                                          .density = 2,
                                          .time_step = 0.9 * dt * 0.5 / std::sqrt(1.5)});
                    const auto first = nmbc::energies(chain);
                    chain.advance(1000);
                    const auto last = nmbc::energies(chain);
                    CHECK(last.damped > 1e-3 * first.staggered);
                    // 1000 steps of 40 nodes: roundings add up as sqrt(4e5) eps = 1.4e-13, of
                    // forces that shifts of the body have added to by then
                    CHECK(last.staggered + last.damped ==
                          doctest::Approx(first.staggered + first.damped).scale(0).epsilon(2e-12));
                }
            }
        }
    }
}

TEST_CASE("in floats, too, and beside convex kernels") {
    const auto lattice = damped_nopd(1, 0.8, 0.2);  // n = 1: its influence is a spline's
    const SurfaceEnd end{.closure = Closure::kernel};
    const double dt = 0.9 * longest_step(lattice, end.closure, end.given, 40);
    nmbc::BasicChain<float> chain(lattice, end, {.nodes = 40, .time_step = dt});
    chain.displacement()[10] = 1;
    chain.step();
    const auto first = nmbc::energies(chain);
    chain.advance(1000);
    const auto last = nmbc::energies(chain);
    CHECK(last.damped > 0.1 * first.staggered);
    // as above, with the roundings of floats
    CHECK(last.staggered + last.damped ==
          doctest::Approx(first.staggered + first.damped).scale(0).epsilon(1e-3));
}

TEST_CASE("an even rate of strain is not damped, at a true end as inside") {
    for (const Closure closure : {Closure::sbp, Closure::cut}) {
        for (int n = 1; n <= 4; ++n) {
            auto damped = damped_nopd(n, 0.5, 0.3);
            auto undamped = damped;
            undamped.damping.clear();
            const SurfaceEnd end{.closure = closure};
            const nmbc::ChainParameters p{.nodes = 40, .time_step = 0.1};
            nmbc::Chain one(damped, end, p);
            nmbc::Chain other(undamped, end, p);
            std::vector<double> v(one.nodes());
            for (std::size_t i = 0; i < v.size(); ++i) {
                v[i] = 1 + 0.1 * double(i);
            }
            one.start(std::vector<double>(v.size()), v);
            other.start(std::vector<double>(v.size()), v);
            double difference = 0;
            for (std::size_t i = one.ghosts(); i + one.ghosts() < one.nodes(); ++i) {
                difference =
                    std::max(difference, std::abs(one.velocity()[i] - other.velocity()[i]));
            }
            CAPTURE(n);
            // cut: its strain is exact where u is linear, sbp's by its patch test; v is up to 6
            CHECK(difference <= 1e-14);
        }
    }
}

TEST_CASE(
    "steps beside a true end of a damped lattice are stable up to its limit, and no further") {
    for (const SurfaceEnd& end :
         {SurfaceEnd{.closure = Closure::sbp}, SurfaceEnd{.closure = Closure::cut},
          SurfaceEnd{.closure = Closure::sbp, .given = OnSurface::displacement},
          SurfaceEnd{.closure = Closure::cut, .given = OnSurface::displacement}}) {
        for (int n = 1; n <= 3; ++n) {
            for (const double tau : {0.1, 1.0, 4.0}) {
                for (const std::size_t nodes : {13U, 30U}) {  // both edges reach one node, or none
                    const auto lattice = damped_nopd(n, 0.5, tau);
                    const double dt = longest_step(lattice, end.closure, end.given, nodes);
                    const Rates rates(lattice, end, nodes, dt);
                    CAPTURE(static_cast<int>(end.closure));
                    CAPTURE(static_cast<int>(end.given));
                    CAPTURE(n);
                    CAPTURE(tau);
                    CAPTURE(nodes);
                    // a shift's double eigenvalue of 1 splits by the root of roundings
                    CHECK(rates.spectral_radius(dt) <= 1 + 1e-6);
                    // Of an edge the limit may leave 2 % of the eigenvalue, 1 % of the step. That
                    // of the interior counts, too, whose fastest wave is some 2 % slower in 30
                    // nodes, and more in 13.
                    CHECK((nodes == 13 || rates.spectral_radius(1.03 * dt) > 1.001));
                    CHECK_THROWS_AS(
                        nmbc::Chain(lattice, end, {.nodes = nodes, .time_step = 1.01 * dt}),
                        nmbc::NotCertified);
                }
            }
        }
    }
}

TEST_CASE("what is damped at a true end has to be known") {
    auto by_hand = damped_nopd(2, 0.5, 0.3);
    by_hand.table = nullptr;
    const SurfaceEnd end{.closure = Closure::sbp};
    const nmbc::ChainParameters p{.nodes = 40, .time_step = 0.1};
    CHECK_THROWS_WITH_AS(nmbc::Chain(by_hand, end, p),
                         "this end of a damped lattice needs the squares that are damped, and a "
                         "lattice made by hand has none",
                         std::invalid_argument);
    auto other = damped_nopd(2, 0.5, 0.3);
    other.damping[1] *= 1.01;
    CHECK_THROWS_WITH_AS(nmbc::Chain(other, end, p),
                         "this end knows a damping that is tau > 0 times the symbol of the "
                         "stabilisation at G = 1, no other",
                         std::invalid_argument);
    auto shorter = damped_nopd(2, 0.5, 0.3);
    shorter.damping.pop_back();
    CHECK_THROWS_AS(nmbc::Chain(shorter, end, p), std::invalid_argument);
    CHECK_THROWS_AS(nmbc::Chain(damped_nopd(2, 0.5, -0.3), end, p), std::invalid_argument);
    CHECK_THROWS_WITH_AS(
        nmbc::Chain(damped_nopd(2, 0.5, 0.3), SurfaceEnd{.closure = Closure::surface_node}, p),
        "a surface node needs a lattice without damping", std::invalid_argument);
}
