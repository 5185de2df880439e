// SPDX-License-Identifier: MIT
/// A steel bar in metres and seconds, in a loop of your own: a piece of a long bar, in the middle
/// of which a pulse starts. The pulse runs both ways and is to leave.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nmbc/boundary.hpp>
#include <nmbc/tables/nopd1d_n1_order1.hpp>
#include <nmbc/tables/nopd1d_n1_order2_dt1o2.hpp>
#include <vector>

// 1. The material gives the wave speed c = sqrt(E/rho). Young's modulus is in Pa, the density in
// kg/m^3, the speed in m/s.
const double wave_speed = std::sqrt(210e9 / 7850);

// 2. The pulse gives the spacing. It is half a metre wide, 5 sigma. A matching boundary is
// exact for long waves, and reflects the more of a wave the fewer nodes it has: example tables.py
// prints how much. With dX = 10 mm the pulse is 50 nodes wide.
const double sigma = 0.1;     // [m]
const double spacing = 0.01;  // [m]
constexpr int nodes = 400;    // of 4 m of the bar

// 3. The horizon is dX here, n = 1, and the stencil reaches 2n nodes: as many ghosts at each end.
constexpr int ghosts = 2;

// 4. The stabilisation G gives energy to the modes that have none at G = 0. With G = 2/3 the speed
// of long waves is right to fourth order (docs/how-to/choose-G.md), and orders 1 and 2 are
// certified.
constexpr double G = 2.0 / 3;

/// The part of the energy that is still there when the pulse should be gone.
double energy_that_came_back(const nmbc::MatchingTable& table) {
    // 5. The time step, in seconds: the longest that is certified with the same boundary at both
    // ends. A longer one is refused by the boundary.
    const double dt = nmbc::stable_time_step(table, G, wave_speed, spacing);
    const nmbc::MatchingBoundary boundary(
        nmbc::boundary_coefficients(table, G),
        {.ghost_layers = ghosts, .wave_speed = wave_speed, .spacing = spacing, .time_step = dt});
    std::vector<double> u(nodes + 2 * ghosts);  // displacement at t [m]
    std::vector<double> v(u.size());            // velocity at t - dt/2 [m/s]
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double x = spacing * (double(i) - double(u.size() - 1) / 2);
        u[i] = 1e-3 * std::exp(-x * x / (2 * sigma * sigma));
    }
    const double stiffness = std::pow(wave_speed / spacing, 2);  // E/(rho dX^2) [1/s^2]
    double most = 0;
    double now = 0;
    for (double t = 0; t < 0.6e-3; t += dt) {            // the pulse meets the ends at 0.4 ms
        for (int i = ghosts; i < nodes + ghosts; ++i) {  // your forces: (39) of Nicely 2018
            const double second = u[i - 2] - 2 * u[i] + u[i + 2];
            const double fourth = u[i - 2] - 4 * u[i - 1] + 6 * u[i] - 4 * u[i + 1] + u[i + 2];
            v[i] += dt * stiffness * (second / 2 - G * fourth) / 2;
        }
        boundary.update(u, v, nmbc::End::left);  // the ghosts' velocities, and nothing else
        boundary.update(u, v, nmbc::End::right);
        now = 0;
        for (std::size_t i = 0; i < u.size(); ++i) {
            u[i] += dt * v[i];
            now += v[i] * v[i];  // kinetic energy, but for a factor
        }
        most = std::max(most, now);
    }
    return now / most;
}

int main() {
    std::printf("c = %.0f m/s, %.0f nodes to a pulse\n", wave_speed, 5 * sigma / spacing);
    // 6. Two conditions: order 1, and order 2 matched in steps of dX/(2c), which it then has to be
    // run in. Order 2 without _dt1o2 in its name would take other steps and reflect what they add.
    for (const auto* table :
         {&nmbc::generated::nopd1d_n1_order1, &nmbc::generated::nopd1d_n1_order2_dt1o2}) {
        const double dt = nmbc::stable_time_step(*table, G, wave_speed, spacing);
        std::printf("NMBC%d, dt = %.2e s: %.0e of the energy came back\n", table->order, dt,
                    energy_that_came_back(*table));
    }
}
