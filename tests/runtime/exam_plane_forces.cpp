// SPDX-License-Identifier: MIT
// Forces of a plane lattice against the energy as it is written.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <nmbc/plane.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/runtime/plane_bodies.hpp"

using namespace nmbc;

namespace {

/// The potential energy of a free rectangle of nodes at E = dX = 1, from the definitions: the
/// gradient (62) with the shape tensor (61) of the neighbours that a node has, strain (64), and z,
/// where a bond has this influence by its length.
class LiteralEnergy {
  public:
    using Influence = std::function<double(double)>;
    using Field = std::vector<std::array<double, 2>>;

    LiteralEnergy(unsigned radius_squared, double poisson, double G, int nx, int ny,
                  Influence influence)
        : family_(plane_family(radius_squared)),
          influence_(std::move(influence)),
          nx_(nx),
          ny_(ny) {
        for (const PlaneOffset& R : family_) {
            reach_ = std::max(reach_, R.x);
        }
        mu_ = 1 / (2 * (1 + poisson));
        bulk_ = 1 / (2 * (1 - poisson));
        const double C = 12 * bulk_ / (std::numbers::pi * std::pow(radius_squared, 2));
        double sum = 0;
        for (const PlaneOffset& R : family_) {
            sum += of_bond(R);
        }
        bond_weight_ = G * C / sum;
    }

    std::size_t index(int x, int y) const { return std::size_t(y * nx_ + x); }

    double operator()(const Field& u) const { return of_nodes(u, {0, nx_}, {0, ny_}); }

    /// The part that hangs on u of this node.
    double around(const Field& u, int x, int y) const {
        return of_nodes(u, {std::max(x - reach_, 0), std::min(x + reach_ + 1, nx_)},
                        {std::max(y - reach_, 0), std::min(y + reach_ + 1, ny_)});
    }

  private:
    /// The first node and the one behind the last, along x and y.
    double of_nodes(const Field& u, const std::array<int, 2>& xs,
                    const std::array<int, 2>& ys) const {
        double energy = 0;
        for (int y = ys[0]; y < ys[1]; ++y) {
            for (int x = xs[0]; x < xs[1]; ++x) {
                energy += of_node(u, x, y);
            }
        }
        return energy;
    }

    double of_bond(const PlaneOffset& R) const { return influence_(std::hypot(R.x, R.y)); }

    double of_node(const Field& u, int x, int y) const {
        std::array<std::array<double, 2>, 2> K{};
        std::array<std::array<double, 2>, 2> sum{};  // of (u_J - u_I) R
        std::vector<PlaneOffset> bonds;
        for (const PlaneOffset& R : family_) {
            if (x + R.x < 0 || x + R.x >= nx_ || y + R.y < 0 || y + R.y >= ny_) {
                continue;
            }
            bonds.push_back(R);
            const std::array<double, 2> X{double(R.x), double(R.y)};
            for (std::size_t a = 0; a < 2; ++a) {
                for (std::size_t b = 0; b < 2; ++b) {
                    K[a][b] += of_bond(R) * X[a] * X[b];
                    sum[a][b] +=
                        of_bond(R) * (u[index(x + R.x, y + R.y)][a] - u[index(x, y)][a]) * X[b];
                }
            }
        }
        const double det = K[0][0] * K[1][1] - K[0][1] * K[1][0];
        const std::array<std::array<double, 2>, 2> inverse{
            {{K[1][1] / det, -K[0][1] / det}, {-K[1][0] / det, K[0][0] / det}}};
        std::array<std::array<double, 2>, 2> g{};
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t b = 0; b < 2; ++b) {
                g[a][b] = sum[a][0] * inverse[0][b] + sum[a][1] * inverse[1][b];
            }
        }
        const double shear = (g[0][1] + g[1][0]) / 2;
        const double trace = g[0][0] + g[1][1];
        double energy = bulk_ * trace * trace / 2 +
                        mu_ * (std::pow(g[0][0] - g[1][1], 2) + 4 * shear * shear) / 2;
        for (const PlaneOffset& R : bonds) {
            for (std::size_t a = 0; a < 2; ++a) {
                const double z = u[index(x + R.x, y + R.y)][a] - u[index(x, y)][a] - g[a][0] * R.x -
                                 g[a][1] * R.y;
                energy += bond_weight_ * of_bond(R) / 2 * z * z;
            }
        }
        return energy;
    }

    std::vector<PlaneOffset> family_;
    Influence influence_;
    int nx_;
    int ny_;
    double mu_ = 0;
    double bulk_ = 0;
    double bond_weight_ = 0;
    int reach_ = 0;
};

/// The largest difference, of random displacements.
double away_from_gradient(const CorrespondenceModel& model, double G,
                          const LiteralEnergy::Influence& influence) {
    constexpr int nx = 25;  // with nodes in its middle that the fast sweeps take
    constexpr int ny = 14;
    PlaneParameters p{.nx = nx, .ny = ny};
    p.time_step = 2;  // v is minus the acceleration then, after start()
    Plane plane(model, PlaneSides::all(FreeSide{}), p);
    fill_at_random(plane, model.radius_squared);
    for (const std::size_t a : {0U, 1U}) {
        std::ranges::fill(plane.velocity(a), 0.0);
    }
    const LiteralEnergy energy(model.radius_squared, 0.25, G, nx, ny, influence);
    LiteralEnergy::Field u(std::size_t(nx * ny));
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            const std::size_t entry = plane.entry(std::size_t(x), std::size_t(y));
            u[energy.index(x, y)] = {plane.displacement(0)[entry], plane.displacement(1)[entry]};
        }
    }
    plane.start();
    double largest = 0;
    LiteralEnergy::Field mean = u;  // half a step before, whose energies a plane has
    for (int y = 0; y < ny; ++y) {
        for (int x = 0; x < nx; ++x) {
            for (const std::size_t a : {0U, 1U}) {
                double& moved = u[energy.index(x, y)][a];
                const double stays = moved;
                moved = stays + 1;  // quadratic: a central difference is exact
                const double above = energy.around(u, x, y);
                moved = stays - 1;
                const double slope = (above - energy.around(u, x, y)) / 2;
                moved = stays;
                const std::size_t entry = plane.entry(std::size_t(x), std::size_t(y));
                largest = std::max(largest, std::abs(plane.velocity(a)[entry] - slope));
                mean[energy.index(x, y)][a] -= plane.velocity(a)[entry];
            }
        }
    }
    const PlaneEnergies energies = plane.energies();
    CHECK(energies.strain + energies.stabilisation ==
          doctest::Approx(energy(mean)).epsilon(1000 * eps).scale(0));
    return largest;
}

TEST_CASE("forces of a free rectangle are the gradient of the energy as it is defined") {
    constexpr double G = 0.7;
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U, 10U}) {
        CAPTURE(radius_squared);
        const CorrespondenceModel model = nopd2d(radius_squared, 0.25, G);
        // The energies are about 100, and so are their roundings in units of eps.
        CHECK(away_from_gradient(model, G, [](double) { return 1.0; }) < 1000 * eps);
        const auto gaussian = [](double length) { return std::exp(-length * length / 4); };
        std::vector<double> influence;
        for (const unsigned square : squared_lengths(radius_squared)) {
            influence.push_back(gaussian(std::sqrt(square)));
        }
        CHECK(away_from_gradient(with_influence(model, influence), G, gaussian) < 1000 * eps);
    }
}

TEST_CASE("of an influence a factor says nothing, and an even one is none") {
    const CorrespondenceModel model = nopd2d(4, 0.25, 1);
    CHECK(with_influence(model, {3, 3, 3}).influence.empty());
    const auto once = with_influence(model, {4, 2, 1}).influence;
    REQUIRE(once.size() == 3);
    CHECK(4 * once[0] + 4 * once[1] + 4 * once[2] == doctest::Approx(12).epsilon(4 * eps));
    CHECK(once[0] == 4 * once[2]);
    CHECK(with_influence(model, {8, 4, 2}).influence == once);
}

}  // namespace
