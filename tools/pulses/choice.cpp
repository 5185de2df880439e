// SPDX-License-Identifier: MIT
#include "tools/pulses/choice.hpp"

#include <algorithm>
#include <nmbc/certificate.hpp>
#include <nmbc/coefficients.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/tables/tables.hpp>
#include <string_view>
#include <tuple>

namespace pulses {
namespace {

constexpr std::string_view family = "nopd1d";
constexpr double smallest_cfl = 0.25;  // as `nmbcgen recommend` asks for at least

/// That a table has to be certified for.
double least_cfl(const nmbc::MatchingTable& table, double G) {
    return std::max(smallest_cfl, cfl_of(table, G, step_of(table)));
}

/// The least comes first.
auto rank(const nmbc::MatchingTable& table, double G) {
    return std::tuple(damping_of(table), -nmbc::certified_cfl(table, G));
}

}  // namespace

double damping_of(const nmbc::MatchingTable& table) {
    return nmbc::detail::nearest_to_fraction(table.tau);
}

double step_of(const nmbc::MatchingTable& table) {
    return nmbc::detail::nearest_to_fraction(table.time_step);
}

double cfl_of(const nmbc::MatchingTable& table, double G, double time_step) {
    return time_step * nmbc::maximum_frequency(nmbc::make_lattice(table, G)) / 2;
}

const nmbc::MatchingTable* first_order(int horizon, double G) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, family, horizon, 1);
    return table != nullptr && nmbc::certified_cfl(*table, G) > 0 ? table : nullptr;
}

const nmbc::MatchingTable* higher_order(int horizon, double G, bool matched) {
    const nmbc::MatchingTable* best = nullptr;
    for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
        if (table->family == family && table->horizon == horizon && table->order >= 2 &&
            (table->time_step != "0") == matched &&
            nmbc::certified_grade(*table, G) != nmbc::Grade::none &&
            nmbc::certified_cfl(*table, G) >= least_cfl(*table, G) &&
            (best == nullptr || rank(*table, G) < rank(*best, G))) {
            best = table;
        }
    }
    return best;
}

}  // namespace pulses
