// SPDX-License-Identifier: GPL-2.0-or-later
// Chains whose true ends are on the outermost node, for the tests of those.
#pragma once

#include <cmath>
#include <cstddef>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <vector>

inline nmbc::Lattice constant_influence(int horizon, double G) {
    return nmbc::make_lattice(*nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1, 1),
                              G);
}

/// nopd1d of a cubic spline of radius 3 dX, at G = 0: weights 15, 2.
inline nmbc::Lattice spline_lattice() {
    const double shape = 2 * (15 + 4 * 2);
    const double near = 15 / shape;
    const double far = 4 / shape;
    nmbc::Lattice lattice;
    lattice.energy.push_back({nmbc::EnergyPart::strain, 1, {-far, -near, 0, near, far}});
    const std::vector<double>& strain = lattice.energy[0].stencil;
    for (std::size_t m = 0; m <= 4; ++m) {
        double sum = 0;
        for (std::size_t i = 0; i + m < strain.size(); ++i) {
            sum += strain[i] * strain[i + m];
        }
        lattice.symbol.push_back(sum);
    }
    return lattice;
}

/// Where the square of a bond from I to I+k is counted.
enum class Counted { near, far, half_at_each };

/// Bonds of these weights over their sum of w_k k^2.
inline nmbc::Lattice bonds_of(const std::vector<double>& weights, Counted counted = Counted::near) {
    double modulus = 0;
    for (std::size_t k = 1; k <= weights.size(); ++k) {
        modulus += weights[k - 1] * double(k * k);
    }
    nmbc::Lattice lattice;
    lattice.symbol.push_back(0);
    for (std::size_t k = 1; k <= weights.size(); ++k) {
        const double weight = weights[k - 1] / modulus;
        std::vector<double> forth(2 * k + 1);
        forth[k] = -1;
        forth[2 * k] = 1;
        const std::vector<double> back(forth.rbegin(), forth.rend());
        const double part = counted == Counted::half_at_each ? weight / 2 : weight;
        if (counted != Counted::far) {
            lattice.energy.push_back({nmbc::EnergyPart::strain, part, forth});
        }
        if (counted != Counted::near) {
            lattice.energy.push_back({nmbc::EnergyPart::strain, part, back});
        }
        lattice.symbol[0] += 2 * weight;
        lattice.symbol.push_back(-weight);
    }
    return lattice;
}

/// The nearest neighbours alone, an even micromodulus, and one in which the second matters most,
/// counted in every way.
inline std::vector<nmbc::Lattice> lattices_of_bonds() {
    std::vector<nmbc::Lattice> all;
    for (const std::vector<double>& weights :
         std::vector<std::vector<double>>{{1}, {1, 1, 1, 1, 0.5}, {1, 5, 0, 2}}) {
        for (const Counted counted : {Counted::near, Counted::far, Counted::half_at_each}) {
            all.push_back(bonds_of(weights, counted));
        }
    }
    return all;
}

inline std::vector<nmbc::Lattice> lattices_for(nmbc::Closure closure) {
    if (closure == nmbc::Closure::kernel) {
        return {spline_lattice()};
    }
    std::vector<nmbc::Lattice> all = lattices_of_bonds();
    for (int horizon = 1; horizon <= 5; ++horizon) {
        for (const double G : {0.0, 0.8, 4.0}) {
            all.push_back(constant_influence(horizon, G));
        }
    }
    return all;
}

/// In units of their own, so that none is taken for 1, and in steps that the closure allows.
inline nmbc::ChainParameters parameters_of(std::size_t nodes, nmbc::Closure closure,
                                           const nmbc::Lattice& lattice) {
    nmbc::ChainParameters p{.nodes = nodes, .spacing = 0.5, .youngs_modulus = 8, .density = 2};
    p.time_step =
        1.8 /
        std::sqrt(nmbc::largest_eigenvalue(lattice, closure, nmbc::OnSurface::traction, nodes)) *
        p.spacing / p.wave_speed();
    return p;
}
