// SPDX-License-Identifier: MIT
/// A piece of a large steel plate, struck in the middle: its sides are where the model stops and
/// the plate does not. SI units.
#include <cmath>
#include <cstdio>
#include <nmbc/plane_stability.hpp>

#include "passive_side.hpp"

int main() {
    // The side was designed for this lattice: nmbcgen's g is G/pi.
    constexpr double pi = 3.14159265358979323846;
    const nmbc::PlaneModel model = nmbc::nopd2d(1, 0.3, 0.25 * pi);
    const auto sides = nmbc::PlaneSides::all(nmbc::generated::passive_nopd2d_r1_nu3o10_g1o4);

    nmbc::PlaneParameters plate{.nx = 200,
                                .ny = 200,
                                .spacing = 0.001,         // m
                                .youngs_modulus = 210e9,  // Pa
                                .density = 7850};         // kg/m^3
    plate.time_step = 0.9 * 2 /
                      std::sqrt(nmbc::highest_eigenvalue(model, sides, plate.nx, plate.ny)) /
                      plate.rate();
    nmbc::Plane plane(model, sides, plate);

    // A body force along y on nine nodes for 10 us. It acts before the sides do.
    const double duration = 10e-6;
    const auto strike = [&](nmbc::Plane& body, double time) {
        if (time > duration) {
            return;
        }
        const double force = 1e9 * std::pow(std::sin(pi * time / duration), 2);  // N/m^3
        for (std::size_t x = 99; x < 102; ++x) {
            for (std::size_t y = 99; y < 102; ++y) {
                body.velocity(1)[body.entry(x, y)] += plate.time_step * force / plate.density;
            }
        }
    };
    const auto nothing = [](const nmbc::Plane& /*body*/) {};

    double most = 0;
    for (const double t : {10e-6, 20e-6, 40e-6, 80e-6, 160e-6}) {
        plane.advance(static_cast<std::size_t>(t / plate.time_step) - plane.steps(), strike,
                      nothing);
        const double energy = plane.interior_energies().total();
        most = std::max(most, energy);
        std::printf("t = %3.0f us: energy %.3e J/m, %.1e of the largest\n", t * 1e6, energy,
                    energy / most);
    }
    return plane.interior_energies().total() < 2e-3 * most ? 0 : 1;
}
