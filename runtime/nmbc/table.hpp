// SPDX-License-Identifier: MIT
/// The contract between generator and runtime: what an emitted table holds.
///
/// Units: dX = 1 and c = sqrt(E/rho) = 1, so xi is in 1/dX, omega and tau in c/dX, c_j and G
/// without dimension, b_j in c/dX. Equation numbers: Nicely, Tang, Qian 2018.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace nmbc {

/// Raised by any change that an old reader would misread; every emitted header asserts it.
inline constexpr int table_schema = 6;

/// An exact rational function of the stabilisation G. Each string is a polynomial: its integer
/// coefficients in ascending powers of G, in decimal, one space between. "576 -170" over
/// "-128 85" is (576 - 170 G) / (-128 + 85 G). No common factor; leading denominator positive.
struct RationalFunction {
    std::string_view numerator;
    std::string_view denominator;

    friend bool operator==(const RationalFunction&, const RationalFunction&) = default;
};

/// The ledger entry an energy is counted in.
enum class EnergyPart { strain, stabilisation };

/// Its name in every format.
constexpr std::string_view name_of(EnergyPart part) {
    return part == EnergyPart::strain ? "strain" : "stabilisation";
}

/// One square of the lattice's potential energy density at node I (in E/dX^2 times
/// displacement^2),
///     (1/2) weight(G) * ( sum_{i = -r..r} stencil_i u_{I+i} / divisor )^2,
/// stencil: 2r+1 integers as in RationalFunction; divisor: one integer.
struct EnergySquare {
    EnergyPart part;
    RationalFunction weight;
    std::string_view stencil;
    std::string_view divisor;
};

/// The values of G from low to high, both included.
struct Window {
    double low;
    double high;

    constexpr bool contains(double G) const { return low <= G && G <= high; }
};

/// The upper end of a window that has none.
inline constexpr double unbounded = std::numeric_limits<double>::infinity();

enum class Grade {
    none,  ///< not certified
    /// Stable with the same condition at the other end, in chains of MatchingTable::least_nodes.
    paired,
    /// And, in continuous time, with any other end that adds no energy. In time steps that holds up
    /// to certified_cfl(.., Opposite::any), which may be less than for like ends, or 0.
    contractive,
};

/// Time level of u in (60) when the ghost velocities at k+1/2 are found.
enum class GhostRule {
    midpoint,      ///< the mean of levels k and k+1; costs one division, done once
    explicit_rule  ///< level k: for comparison, without a certificate
};

/// At every G of the window leapfrog with midpoint ghosts is stable in all steps from `from` to
/// `cfl`, both as dt omega_max / 2. A `from` above 0: in some shorter steps an end's own mode
/// grows.
struct StableStep {
    Window window{};
    double cfl = 0;
    double from = 0;

    /// Up to roundings of a cfl that was a time step on its way here.
    constexpr bool allows(double other_cfl) const {
        constexpr double roundings = 1e-9;
        return other_cfl >= from * (1 - roundings) && other_cfl <= cfl * (1 + roundings);
    }
};

/// A lattice at every G: a family's model at one horizon, with its influence and damping.
struct LatticeTable {
    std::string_view name;  ///< of the header and of the table, e.g. "nopd1d_n3_tau1o10"
    std::string_view family;
    int horizon;               ///< in dX
    std::string_view weights;  ///< of the influence, "1,1/2" for w_1 = 1, w_2 = 1/2; "": constant
    std::string_view tau;      ///< damping [c/dX], "p/q"; "0": undamped
    std::string_view source;   ///< the equations it is taken from
    /// omega^2 = symbol[0] + sum_{m >= 1} symbol[m] (z^m + z^-m), z = exp(i xi dX): the interior
    /// stencil is minus this, rho u_tt = -(E/dX^2) sum_m symbol[|m|] u_{I+m}.
    std::span<const RationalFunction> symbol;
    /// tau sigma = damping[0] + sum_{m >= 1} damping[m] (z^m + z^-m), numbers, as many as in
    /// `symbol`; empty where tau = 0. sigma is the symbol of the stabilisation at G = 1, and the
    /// damping force -(rho c/dX) sum_m damping[|m|] v_{I+m}: s^2 + tau sigma s + omega^2 = 0.
    std::span<const RationalFunction> damping;
    std::span<const EnergySquare> energy;  ///< the squares the symbol follows from

    /// Nodes the interior stencil reaches to each side: also the ghost layers (60) is used on.
    constexpr std::size_t ghost_layers() const { return symbol.size() - 1; }
};

/// Whether waves are the same in both, exactly, at every G.
constexpr bool is_same_lattice(const LatticeTable& one, const LatticeTable& other) {
    return &one == &other || (std::ranges::equal(one.symbol, other.symbol) &&
                              std::ranges::equal(one.damping, other.damping));
}

/// A nonlocal matching boundary condition of a lattice.
struct MatchingTable {
    std::string_view name;  ///< of the header and of the table, e.g. "nopd1d_n2_order3"
    const LatticeTable* lattice;
    int order;                 ///< N of NMBCN
    int stride;                ///< node offsets of the condition are 0, s, 2s, .. Ns
    std::string_view fixed_G;  ///< "p/q" where G was fixed when the table was made, else ""
    /// dt of leapfrog with midpoint ghosts in which it is matched [dX/c], "p/q"; "0": in continuous
    /// time. A boundary takes no other step, and modal and contractive windows and steps are for
    /// the G at which it is certified.
    std::string_view time_step;
    std::string_view source;                   ///< the equations it is taken from
    std::string_view proved;                   ///< what the generator established exactly
    std::span<const RationalFunction> taylor;  ///< a_1 .. a_{2N+1} of s = sum a_k (i xi)^k (47)
    std::span<const RationalFunction> c;       ///< c_0 .. c_N, c_0 = 1 (60)
    std::span<const RationalFunction> b;       ///< b_0 .. b_N (60)
    /// Where the paper's scalar |R| <= 1 on the whole band: neither enough for stability nor, in
    /// general, needed. Not sought where tau > 0, and empty.
    std::span<const Window> reflection;
    /// Where a chain is stable with both ends alike, from `least_nodes` interior nodes on.
    std::span<const Window> modal;
    /// Where, in continuous time, no wave leaves the boundary with more energy than came in, so
    /// that the other end may be any that does not add energy, a fixed or a free one too. In time
    /// steps that holds up to max_cfl_contractive only. Not sought where tau > 0, and empty.
    std::span<const Window> contractive;
    std::span<const StableStep> max_cfl;  ///< of `modal`: both ends alike
    /// Of `contractive`: the other end may be any that adds no energy. At some G much less than
    /// max_cfl, or none. Not sought where tau > 0, and empty.
    std::span<const StableStep> max_cfl_contractive;
    /// Interior nodes a chain needs for `modal` and the steps to hold. With tau = 0: in shorter
    /// ones waves that decay from one end reach the other. With tau > 0: what an end amplifies is
    /// damped away on the way there. 0 where no step is certified.
    int least_nodes;

    constexpr std::size_t ghost_layers() const { return lattice->ghost_layers(); }
};

/// The lattice with these properties, or nullptr. `lattices` is nmbc::generated::lattices of
/// <nmbc/tables/tables.hpp>, or any list of the user's own. tau and weights are written as in the
/// table.
constexpr const LatticeTable* find_lattice(std::span<const LatticeTable* const> lattices,
                                           std::string_view family, int horizon,
                                           std::string_view tau = "0",
                                           std::string_view weights = "") {
    const auto found = std::ranges::find_if(lattices, [&](const LatticeTable* lattice) {
        return lattice->family == family && lattice->horizon == horizon && lattice->tau == tau &&
               lattice->weights == weights;
    });
    return found == lattices.end() ? nullptr : *found;
}

/// The table with these properties, of constant influence, or nullptr; a damped one only where its
/// tau is asked for, and one that is matched in time steps only where its step is, in lowest terms,
/// as in the table. `tables` is nmbc::generated::tables of <nmbc/tables/tables.hpp>, or any list of
/// tables of the user's own.
constexpr const MatchingTable* find_table(std::span<const MatchingTable* const> tables,
                                          std::string_view family, int horizon, int order,
                                          int stride = 1, std::string_view tau = "0",
                                          std::string_view time_step = "0") {
    const auto found = std::ranges::find_if(tables, [&](const MatchingTable* table) {
        return find_lattice({&table->lattice, 1}, family, horizon, tau) != nullptr &&
               table->order == order && table->stride == stride && table->time_step == time_step;
    });
    return found == tables.end() ? nullptr : *found;
}

}  // namespace nmbc
