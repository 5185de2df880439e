// SPDX-License-Identifier: GPL-2.0-or-later
/// Bars for the tests of nmbcrun's simulations.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "tools/nmbcrun/simulation/simulation.hpp"

namespace nmbcrun::test {

/// n = 2, G = 1 between NMBC1 ends; dX = 1/2, c = 2, so that no unit is 1 by chance.
inline Scene bar(std::size_t nodes, double end) {
    Scene scene;
    scene.horizon = 2;
    scene.G = 1;
    scene.youngs_modulus = 12;
    scene.density = 3;
    scene.spacing = 0.5;
    scene.nodes = nodes;
    scene.end = end;
    scene.cfl = 0.5;
    return scene;
}

inline void run_to_end(Simulation& simulation) {
    while (!simulation.is_done()) {
        simulation.step();
    }
}

inline std::span<const double> interior(const Simulation& simulation,
                                        std::span<const double> field) {
    return field.subspan(simulation.chain().first_interior(),
                         simulation.chain().parameters().nodes);
}

inline double largest(std::span<const double> values) {
    double most = 0;
    for (const double value : values) {
        most = std::max(most, std::abs(value));
    }
    return most;
}

/// The largest difference of the interior's displacements from f(X), X in length.
template <class Function>
double largest_error(const Simulation& simulation, Function f) {
    double most = 0;
    const auto u = interior(simulation, simulation.chain().displacement());
    for (std::size_t node = 0; node < u.size(); ++node) {
        const double X = double(node + 1) * simulation.scene().spacing;
        most = std::max(most, std::abs(u[node] - f(X)));
    }
    return most;
}

/// Where the kinetic energy of the interior is on average [dX; node 1 is at 1].
inline double centre_of_energy(const Simulation& simulation) {
    const auto v = interior(simulation, simulation.chain().velocity());
    double sum = 0;
    double moment = 0;
    for (std::size_t node = 0; node < v.size(); ++node) {
        sum += v[node] * v[node];
        moment += v[node] * v[node] * double(node + 1);
    }
    return moment / sum;
}

}  // namespace nmbcrun::test
