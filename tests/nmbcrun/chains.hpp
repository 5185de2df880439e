// SPDX-License-Identifier: GPL-2.0-or-later
/// Lattices and random states for the tests of nmbcrun's ends.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <nmbc/nmbc.hpp>
#include <nmbc/tables/tables.hpp>
#include <random>
#include <vector>

inline const nmbc::MatchingTable& table_of(int horizon, int order = 1) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, "nopd1d", horizon, order, 1);
    REQUIRE(table != nullptr);
    return *table;
}

inline nmbc::Lattice lattice_of(int horizon, double G) {
    return nmbc::make_lattice(table_of(horizon), G);
}

/// dt [dX/c] of this cfl.
inline double step_of(const nmbc::Lattice& lattice, double cfl) {
    return 2 * cfl / nmbc::maximum_frequency(lattice);
}

inline std::vector<double> random_field(std::size_t nodes, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> field(nodes);
    std::ranges::generate(field, [&] { return normal(random); });
    return field;
}

inline void start_at_random(nmbc::Chain& chain) {
    chain.start(random_field(chain.nodes(), 1), random_field(chain.nodes(), 2));
}
