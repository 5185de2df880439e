// SPDX-License-Identifier: MIT
#include "tools/pulses/choice.hpp"

#include <nmbc/certificate.hpp>
#include <nmbc/tables/tables.hpp>
#include <stdexcept>
#include <string>
#include <tuple>

#include "tools/pulses/fraction.hpp"

namespace pulses {
namespace {

constexpr std::string_view family = "nopd1d";
constexpr double smallest_cfl = 0.25;  // as `nmbcgen recommend` asks for at least

/// The least comes first.
auto rank(const nmbc::MatchingTable& table, double G) {
    return std::tuple(damping_of(table), -nmbc::certified_cfl(table, G));
}

}  // namespace

double damping_of(const nmbc::MatchingTable& table) {
    const auto tau = fraction(table.tau);
    if (!tau) {
        throw std::logic_error(std::string(table.name) + ": tau is no fraction");
    }
    return *tau;
}

const nmbc::MatchingTable* first_order(int horizon, double G) {
    const auto* table = nmbc::find_table(nmbc::generated::tables, family, horizon, 1);
    return table != nullptr && nmbc::certified_cfl(*table, G) > 0 ? table : nullptr;
}

const nmbc::MatchingTable* higher_order(int horizon, double G) {
    const nmbc::MatchingTable* best = nullptr;
    for (const nmbc::MatchingTable* table : nmbc::generated::tables) {
        if (table->family == family && table->horizon == horizon && table->order >= 2 &&
            nmbc::certified_grade(*table, G) != nmbc::Grade::none &&
            nmbc::certified_cfl(*table, G) >= smallest_cfl &&
            (best == nullptr || rank(*table, G) < rank(*best, G))) {
            best = table;
        }
    }
    return best;
}

}  // namespace pulses
