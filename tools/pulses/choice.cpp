// SPDX-License-Identifier: MIT
#include "tools/pulses/choice.hpp"

#include <algorithm>
#include <nmbc/certificate.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/tables/tables.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>

#include "tools/pulses/fraction.hpp"

namespace pulses {
namespace {

constexpr std::string_view family = "nopd1d";
constexpr double smallest_cfl = 0.25;  // as `nmbcgen recommend` asks for at least

double value_of(std::string_view text, const nmbc::MatchingTable& table) {
    const auto value = fraction(text);
    if (!value) {
        throw std::logic_error(std::string(table.name) + ": no fraction: " + std::string(text));
    }
    return *value;
}

/// That a table has to be certified for.
double least_cfl(const nmbc::MatchingTable& table, double G) {
    const double matched = step_of(table);
    return std::max(smallest_cfl,
                    matched * nmbc::maximum_frequency(nmbc::make_lattice(table, G)) / 2);
}

/// The least comes first.
auto rank(const nmbc::MatchingTable& table, double G) {
    return std::tuple(damping_of(table), -nmbc::certified_cfl(table, G));
}

}  // namespace

double damping_of(const nmbc::MatchingTable& table) {
    return value_of(table.tau, table);
}

double step_of(const nmbc::MatchingTable& table) {
    return value_of(table.time_step, table);
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
