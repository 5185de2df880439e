// SPDX-License-Identifier: GPL-2.0-or-later
/// Lattices that exact ends are tried on.
#pragma once

#include <algorithm>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <ostream>
#include <vector>

inline nmbc::Lattice lattice_of(int horizon, double G, double tau = 0) {
    const auto& table = *nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, 1);
    auto lattice = nmbc::make_lattice(table, G);
    if (tau > 0) {  // sigma is what G adds to omega^2 (41)
        lattice.damping = nmbc::make_lattice(table, 1).symbol;
        const auto without = nmbc::make_lattice(table, 0).symbol;
        for (std::size_t m = 0; m < without.size(); ++m) {
            lattice.damping[m] = tau * (lattice.damping[m] - without[m]);
        }
    }
    return lattice;
}

inline double courant_of(const nmbc::Lattice& lattice, double cfl) {
    return 2 * cfl / nmbc::maximum_frequency(lattice);
}

struct Case {
    int horizon;
    double G;
    double tau;
    double cfl;  ///< lowered to what the interior is stable at
};

inline std::vector<Case> cases(const std::vector<int>& horizons,
                               const std::vector<double>& stabilisations,
                               const std::vector<double>& cfls) {
    std::vector<Case> result;
    for (const int horizon : horizons) {
        for (const double cfl : cfls) {
            result.push_back({horizon, stabilisations[1], 0.05, cfl});
            for (const double G : stabilisations) {
                result.push_back({horizon, G, 0, cfl});
            }
        }
    }
    for (Case& one : result) {
        const auto lattice = lattice_of(one.horizon, one.G, one.tau);
        one.cfl = std::min(one.cfl, nmbc::interior_cfl(lattice));
    }
    return result;
}

inline std::ostream& operator<<(std::ostream& stream, const Case& one) {
    return stream << "n = " << one.horizon << ", G = " << one.G << ", tau = " << one.tau
                  << ", cfl = " << one.cfl;
}
