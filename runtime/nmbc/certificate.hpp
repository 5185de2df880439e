// SPDX-License-Identifier: MIT
/// What a table's certificate says of one value of G.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <nmbc/table.hpp>
#include <span>
#include <stdexcept>
#include <string>

namespace nmbc {

/// The end at the other side of the chain.
enum class Opposite {
    like,  ///< the same condition
    any,   ///< any that adds no energy: fixed, free, or another condition at a step where it, too,
           ///< is certified for any other end
};

/// The grade of a table at G; a damped one has no contractive windows.
constexpr Grade certified_grade(const MatchingTable& table, double G) {
    const auto holds = [G](std::span<const Window> windows) {
        return std::ranges::any_of(windows,
                                   [G](const Window& window) { return window.contains(G); });
    };
    if (!holds(table.modal)) {
        return Grade::none;
    }
    return holds(table.contractive) ? Grade::contractive : Grade::paired;
}

/// The certified steps at G, midpoint ghosts, those that go furthest where there are several; of
/// cfl 0 where none is certified, as with a damped table opposite any other end. omega_max is that
/// of the lattice without its damping, which the certified value allows for.
constexpr StableStep certified_steps(const MatchingTable& table, double G,
                                     Opposite opposite = Opposite::like) {
    StableStep longest{{G, G}, 0};
    // Any end may be a like one, and the two lists were sought in different pieces of G.
    for (const auto& steps : {table.max_cfl_contractive, table.max_cfl}) {
        for (const StableStep& step : steps) {
            if (step.window.contains(G) && step.cfl > longest.cfl) {
                longest = step;  // where two of them meet, both hold
            }
        }
        if (opposite == Opposite::any) {
            break;
        }
    }
    return longest;
}

/// The largest certified cfl = dt omega_max / 2 at G; 0 where no time step is certified.
constexpr double certified_cfl(const MatchingTable& table, double G,
                               Opposite opposite = Opposite::like) {
    return certified_steps(table, G, opposite).cfl;
}

/// A table that is not certified to be stable was asked for. what() names what is.
struct NotCertified : std::domain_error {
    using std::domain_error::domain_error;
};

namespace detail {

/// The shortest text that reads back as the same number.
inline std::string to_text(double value) {
    std::array<char, 32> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end};
}

inline std::string to_text(const Window& window) {
    if (window.low == window.high) {
        return "= " + to_text(window.low);
    }
    const bool has_end = window.high != unbounded;
    return "from " + to_text(window.low) + (has_end ? " to " + to_text(window.high) : " and above");
}

inline std::string name_of(const MatchingTable& table) {
    return "NMBC" + std::to_string(table.order) + " with stride " + std::to_string(table.stride) +
           (table.lattice->tau == "0" ? "" : " and tau " + std::string(table.lattice->tau)) +
           (table.time_step == "0" ? "" : " in steps of " + std::string(table.time_step) + " dX/c");
}

}  // namespace detail

/// Says which other choices are certified with a time step opposite such an end: the table's own
/// ranges of G, and from `others` (such as nmbc::generated::tables) those of the same lattice,
/// damping included, at this G.
inline std::string certified_choices(const MatchingTable& table, double G,
                                     std::span<const MatchingTable* const> others = {},
                                     Opposite opposite = Opposite::like) {
    const auto steps = opposite == Opposite::like ? table.max_cfl : table.max_cfl_contractive;
    std::string ranges;
    for (std::size_t i = 0; i < steps.size();) {
        Window range = steps[i].window;
        for (++i; i < steps.size() && steps[i].window.low == range.high; ++i) {
            range.high = steps[i].window.high;
        }
        ranges += (ranges.empty() ? "" : "; ") + detail::to_text(range);
    }
    std::string same_G;
    for (const MatchingTable* other : others) {
        if (is_same_lattice(*other->lattice, *table.lattice) &&
            certified_cfl(*other, G, opposite) > 0) {
            same_G += (same_G.empty() ? "" : ", ") + detail::name_of(*other);
        }
    }
    std::string text = detail::name_of(table);
    if (table.fixed_G.empty()) {
        text += " is certified for " + (ranges.empty() ? "no G" : "G " + ranges);
    } else {
        text += ranges.empty() ? " is not certified at its G, " : " is certified at its G, ";
        text += table.fixed_G;
    }
    return text + (same_G.empty() ? "" : "; at this G: " + same_G);
}

/// Throws NotCertified where the table is not certified at G opposite such an end. How long the
/// chain is, is not known here: see BoundaryCertificate::least_nodes.
inline void require_certified(const MatchingTable& table, double G, Opposite opposite,
                              std::span<const MatchingTable* const> others = {}) {
    const bool like = opposite == Opposite::like;
    if (like ? certified_grade(table, G) == Grade::none
             : certified_steps(table, G, opposite).cfl == 0) {
        throw NotCertified(detail::name_of(table) + " (" + std::string(table.name) +
                           ") is not certified to be stable " +
                           (like ? "" : "opposite another end than its like ") + "at G = " +
                           detail::to_text(G) + "; " + (like ? "" : "opposite any end ") +
                           certified_choices(table, G, others, opposite));
    }
}

}  // namespace nmbc
