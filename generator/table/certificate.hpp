// SPDX-License-Identifier: MIT
/// What is known of the stability of a table, as sets of the stabilisation G.
#pragma once

#include <nmbc/table.hpp>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/table/algebraic.hpp"

namespace nmbcgen {

using nmbc::Grade;
using nmbc::StableStep;

/// The values of G from low to high; none: to infinity.
struct ExactWindow {
    AlgebraicNumber low;
    std::optional<AlgebraicNumber> high;
};

/// What a statement rests on. All else that is said to be stable is so by construction.
enum class Evidence {
    sampled,  ///< found at points
    proved,   ///< exact, or enclosed for every number of an interval
};

/// Its name in every format.
constexpr std::string_view name_of(Evidence evidence) {
    return evidence == Evidence::proved ? "proved" : "sampled";
}

/// Why there is no stability beyond an edge.
enum class Failure {
    none,
    growing_mode,    ///< a boundary mode that decays inwards and grows in time
    resonance,       ///< the boundary sends out a travelling wave without an incident one
    amplified_wave,  ///< reflections add up to more than came in
    backward_band,   ///< likewise, with waves of opposed group and phase velocity among them
    pole,            ///< the coefficients have a pole at the edge
    jordan_block,    ///< C(1) = 0 at the edge: a constant displacement grows like t^2
    time_step,       ///< the step that the condition is matched in is above the largest sampled
};

/// Its name in every format.
constexpr std::string_view name_of(Failure failure) {
    switch (failure) {
        case Failure::none:
            return "none";
        case Failure::growing_mode:
            return "growing boundary mode";
        case Failure::resonance:
            return "resonance";
        case Failure::amplified_wave:
            return "amplified wave";
        case Failure::backward_band:
            return "backward band";
        case Failure::pole:
            return "pole";
        case Failure::jordan_block:
            return "Jordan block";
        case Failure::time_step:
            return "time step";
    }
    return "";
}

/// An edge found by bisection, to between low and high, at most 1e-6 apart. Where the supremum
/// leaves 1 very slowly it is up to 3e-6 nearer to the middle of the window (n = 2, N = 3, G
/// = 23.0423).
struct Bracket {
    double low;
    double high;
};

/// Where a set of G begins or ends, and how stability fails just beyond.
struct Edge {
    std::variant<AlgebraicNumber, Bracket> where;
    double inner = 0;  ///< the double nearest to it on the side of the window
    Failure beyond = Failure::none;
    double wave_number = 0;  ///< |xi| [1/dX] of the resonance, or the least one of the most
                             ///< amplified frequency, to 0.01, else 0
};

/// A window with its edges; without the upper one it has no end.
struct StabilityWindow {
    Edge low;
    std::optional<Edge> high;
};

/// Chains of damped lattices are certified from this many interior nodes on: what a boundary
/// amplifies has to be damped away before it arrives at the other end.
inline constexpr unsigned least_damped_nodes = 100;

/// Their windows are not sought beyond this G.
inline constexpr int highest_damped_G = 3;

/// The three levels; ascending, disjoint. Of a damped lattice the modal windows up to
/// highest_damped_G are sought and the steps with midpoint ghosts; the first and the contractive
/// windows are not: both speak of waves that keep their energy on the way. Where the condition is
/// matched in time steps, modal and contractive windows and steps are for the G at which its own
/// step is certified.
struct Certificate {
    std::vector<ExactWindow> reflection;  ///< the paper's scalar |R| <= 1 on the whole band; exact
    std::vector<AlgebraicNumber> poles;   ///< where a coefficient has a pole
    std::vector<StabilityWindow> modal;   ///< stable with both ends alike
    std::vector<StabilityWindow> contractive;  ///< and with any other contractive end
    std::vector<StableStep> max_cfl;           ///< with both ends alike; most of the modal windows
    std::vector<StableStep> max_cfl_contractive;  ///< contractive in steps
    unsigned least_nodes = 0;  ///< interior nodes of a chain for `modal` and the steps to hold
    Evidence paired = Evidence::sampled;    ///< of `modal` and all steps of `max_cfl`
    Evidence with_any = Evidence::sampled;  ///< of `contractive` and all of `max_cfl_contractive`
};

}  // namespace nmbcgen
