// SPDX-License-Identifier: MIT
/// A code over a plane lattice of your own with perfectly matched layers: the loop, the arrays and
/// the forces are yours; the library only changes velocities in the layers.
///
/// Here: stabilised NOPD of the nearest neighbours in plane stress, a pulse, E = density = dX = 1.
#include <array>
#include <cmath>
#include <cstdio>
#include <nmbc/plane_pml.hpp>
#include <vector>

using Field = std::array<std::vector<double>, 2>;   // components along x and y
using Stress = std::array<std::vector<double>, 4>;  // xx, xy, yx, yy

/// v += dt times the forces of nodes two away from the edge of the arrays and further.
void kick(const nmbc::CorrespondenceModel& model, const nmbc::Grid& grid, double dt, const Field& u,
          Stress& stress, Field& v) {
    const std::size_t row = grid.nx;
    for (std::size_t i = row + 1; i + row + 1 < u[0].size(); ++i) {
        const double xx = (u[0][i + 1] - u[0][i - 1]) / 2;
        const double xy = (u[0][i + row] - u[0][i - row]) / 2;
        const double yx = (u[1][i + 1] - u[1][i - 1]) / 2;
        const double yy = (u[1][i + row] - u[1][i - row]) / 2;
        stress[0][i] = (model.bulk + model.shear) * xx + (model.bulk - model.shear) * yy;
        stress[1][i] = stress[2][i] = model.shear * (xy + yx);
        stress[3][i] = (model.bulk + model.shear) * yy + (model.bulk - model.shear) * xx;
    }
    for (std::size_t y = 2; y + 2 < grid.ny; ++y) {
        for (std::size_t x = 2; x + 2 < grid.nx; ++x) {
            const std::size_t i = y * row + x;
            for (std::size_t a = 0; a < 2; ++a) {
                const auto& w = u[a];
                const double near = w[i + 1] + w[i - 1] + w[i + row] + w[i - row] - 4 * w[i];
                const double far = w[i + 2] + w[i - 2] + w[i + 2 * row] + w[i - 2 * row] - 4 * w[i];
                v[a][i] += dt * ((stress[2 * a][i + 1] - stress[2 * a][i - 1]) / 2 +
                                 (stress[2 * a + 1][i + row] - stress[2 * a + 1][i - row]) / 2 +
                                 model.stabilisation * (2 * near - far / 2));
            }
        }
    }
}

double kinetic_energy(const Field& v) {
    double sum = 0;
    for (const auto& component : v) {
        for (const double one : component) {
            sum += one * one / 2;
        }
    }
    return sum;
}

int main() {
    const nmbc::CorrespondenceModel model = nmbc::nopd2d(1, 0.3, 1);
    const nmbc::LossLayer layer{.nodes = 20, .profile = 2, .target = 1e-4};
    constexpr std::size_t interior = 80;
    const std::size_t all = interior + 2 * (layer.nodes + model.reach());  // with ghosts, held at 0
    const nmbc::Grid grid{.nx = all, .ny = all};
    const nmbc::PlaneParameters parameters{.time_step = 0.5};
    nmbc::PlanePml pml(model, {layer, layer, layer, layer}, grid, parameters);

    Field u;  // displacement at t
    Field v;  // velocity at t - dt/2
    Stress stress;
    const std::vector<double> zeros(all * all, 0);
    u.fill(zeros);
    v.fill(zeros);
    stress.fill(zeros);
    for (std::size_t y = 2; y + 2 < all; ++y) {
        for (std::size_t x = 2; x + 2 < all; ++x) {
            const double half = static_cast<double>(all) / 2;
            const double r =
                std::hypot(static_cast<double>(x) - half, static_cast<double>(y) - half);
            u[1][y * all + x] = std::exp(-r * r / 50);
        }
    }

    double most = 0;
    for (int step = 0; step <= 2000; ++step) {
        const double now = kinetic_energy(v);
        most = std::max(most, now);
        if (step % 200 == 0) {
            std::printf("t = %4.0f: kinetic energy %.1e of the largest\n",
                        step * parameters.time_step, most > 0 ? now / most : 0);
        }
        kick(model, grid, parameters.time_step, u, stress, v);
        pml.kick({u[0], u[1]}, {v[0], v[1]});
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t i = 0; i < u[a].size(); ++i) {
                u[a][i] += parameters.time_step * v[a][i];
            }
        }
    }
    return kinetic_energy(v) < 1e-6 * most ? 0 : 1;
}
