// SPDX-License-Identifier: MIT
/// The interior of a uniform chain: stencil, band edge and energy of a table's lattice model.
#pragma once

#include <cmath>
#include <nmbc/coefficients.hpp>
#include <numbers>
#include <span>
#include <stdexcept>
#include <vector>

namespace nmbc {

/// A lattice model at one G, in units dX = c = 1.
struct Lattice {
    /// One square of the energy, weight * (sum_i stencil[i] u_{I+i-r})^2 / 2, 2r+1 entries.
    struct Square {
        EnergyPart part;
        double weight;
        std::vector<double> stencil;
    };
    std::vector<double> symbol;  ///< omega^2 = symbol[0] + 2 sum symbol[m] cos(m xi)
    std::vector<Square> energy;  ///< squares of zero weight left out

    /// Nodes the stencil reaches to each side; also the ghost layers an end needs.
    std::size_t reach() const { return symbol.size() - 1; }
};

/// The lattice of a table at G >= 0. Throws std::invalid_argument for a bad G, and for another one
/// than the table was made for.
inline Lattice make_lattice(const MatchingTable& table, double G) {
    detail::require_own_G(table, G);
    Lattice lattice{evaluate(table.symbol, G), {}};
    for (const EnergySquare& square : table.energy) {
        const double weight = evaluate(square.weight, G);
        if (weight == 0) {
            continue;
        }
        std::vector<double> stencil;
        detail::for_each_integer(square.stencil, [&](std::size_t, std::string_view entry) {
            stencil.push_back(evaluate(RationalFunction{entry, square.divisor}, 0));
        });
        lattice.energy.push_back({square.part, weight, std::move(stencil)});
    }
    return lattice;
}

/// omega^2 [c^2/dX^2] at wave number xi [1/dX].
inline double omega_squared(const Lattice& lattice, double xi) {
    double sum = lattice.symbol[0];
    for (std::size_t m = 1; m < lattice.symbol.size(); ++m) {
        sum += 2 * lattice.symbol[m] * std::cos(static_cast<double>(m) * xi);
    }
    return sum;
}

/// The largest omega of the band, omega_max [c/dX]; cfl = dt omega_max / 2 is 1 at the interior's
/// own limit. Found by sampling omega^2, a trigonometric polynomial of degree `reach`, and
/// golden-section search around the best sample.
inline double maximum_frequency(const Lattice& lattice) {
    // A trigonometric polynomial of degree r has at most r maxima in (0, pi); 64 samples to each
    // leave one between the neighbours of the best sample.
    const std::size_t samples = 64 * lattice.reach();
    const double step = std::numbers::pi / static_cast<double>(samples);
    std::size_t best = 0;
    for (std::size_t i = 1; i <= samples; ++i) {
        if (omega_squared(lattice, static_cast<double>(i) * step) >
            omega_squared(lattice, static_cast<double>(best) * step)) {
            best = i;
        }
    }
    double low = (static_cast<double>(best) - 1) * step;
    double high = (static_cast<double>(best) + 1) * step;
    // 48 steps shrink the bracket below the point where omega^2 can tell its ends apart.
    for (int i = 0; i < 48; ++i) {
        const double inset = (high - low) * (1 - 1 / std::numbers::phi);
        if (omega_squared(lattice, low + inset) > omega_squared(lattice, high - inset)) {
            high -= inset;
        } else {
            low += inset;
        }
    }
    return std::sqrt(omega_squared(lattice, (low + high) / 2));
}

/// The largest time step [spacing/wave_speed] with which a chain between two ends of this table is
/// certified to be stable, midpoint ghosts.
/// Throws NotCertified where there is none, as at the very edge of some windows, and
/// std::invalid_argument where wave_speed or spacing is not positive and finite.
inline double stable_time_step(const MatchingTable& table, double G, double wave_speed,
                               double spacing) {
    for (const double value : {wave_speed, spacing}) {
        if (!(value > 0) || !std::isfinite(value)) {
            throw std::invalid_argument("wave speed and spacing must be positive and finite");
        }
    }
    const double cfl = certified_cfl(table, G);
    if (cfl == 0) {
        throw NotCertified(std::string(table.name) + " is certified for no time step at G = " +
                           detail::to_text(G) + "; " + certified_choices(table, G));
    }
    return 2 * cfl / maximum_frequency(make_lattice(table, G)) * spacing / wave_speed;
}

/// Accelerations of the interior nodes, a_I = -(c/dX)^2 sum_m symbol[|m|] u_{I+m}.
/// u: all nodes, `reach` ghosts first and last; a: the same length, ghost entries untouched.
/// stiffness: (c/dX)^2 = E/(rho dX^2) [1/time^2].
inline void accelerations(const Lattice& lattice, double stiffness, std::span<const double> u,
                          std::span<double> a) {
    const std::size_t reach = lattice.reach();
    for (std::size_t node = reach; node + reach < u.size(); ++node) {
        double sum = lattice.symbol[0] * u[node];
        for (std::size_t m = 1; m <= reach; ++m) {
            sum += lattice.symbol[m] * (u[node + m] + u[node - m]);
        }
        a[node] = -stiffness * sum;
    }
}

}  // namespace nmbc
