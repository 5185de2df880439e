// SPDX-License-Identifier: MIT
/// A lattice code of your own with a matching boundary: the loop, the arrays and the forces are
/// yours; the library only fills in the velocities of the ghost nodes.
///
/// Here: stabilised NOPD with horizon dX written out as (39), a Gaussian pulse, NMBC2.
#include <cmath>
#include <cstdio>
#include <nmbc/boundary.hpp>
#include <nmbc/tables/nopd1d_n1_order2.hpp>
#include <vector>

int main() {
    constexpr double G = 0.5;         // stabilisation
    constexpr double wave_speed = 1;  // sqrt(E/rho)
    constexpr double spacing = 1;     // dX
    constexpr double time_step = 0.5;
    constexpr int ghosts = 2;   // nodes the stencil reaches: 2n
    constexpr int nodes = 300;  // interior

    const nmbc::MatchingBoundary boundary(
        nmbc::boundary_coefficients(nmbc::generated::nopd1d_n1_order2, G),
        {.ghost_layers = ghosts,
         .wave_speed = wave_speed,
         .spacing = spacing,
         .time_step = time_step});

    std::vector<double> u(nodes + 2 * ghosts);  // displacement at t
    std::vector<double> v(u.size(), 0.0);       // velocity at t - dt/2
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double x = (double(i) - double(u.size()) / 2) / 10;
        u[i] = std::exp(-x * x);
    }

    for (int step = 0; step <= 1200; ++step) {
        if (step % 200 == 0) {
            double kinetic = 0;
            for (int i = ghosts; i < nodes + ghosts; ++i) {
                kinetic += v[i] * v[i] / 2;
            }
            std::printf("t = %5.1f   kinetic energy %.3e\n", step * time_step, kinetic);
        }
        for (int i = ghosts; i < nodes + ghosts; ++i) {  // forces (39), E = rho = dX = 1
            const double second = u[i - 2] - 2 * u[i] + u[i + 2];
            const double fourth = u[i - 2] - 4 * u[i - 1] + 6 * u[i] - 4 * u[i + 1] + u[i + 2];
            v[i] += time_step * (second / 2 - G * fourth) / 2;
        }
        boundary.update(u, v, nmbc::End::left);
        boundary.update(u, v, nmbc::End::right);
        for (std::size_t i = 0; i < u.size(); ++i) {
            u[i] += time_step * v[i];
        }
    }
}
