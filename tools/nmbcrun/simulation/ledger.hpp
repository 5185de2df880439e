// SPDX-License-Identifier: MIT
/// Where the energy of a chain's interior comes from and goes to, balanced in every step.
#pragma once

#include <cstddef>
#include <nmbc/chain.hpp>
#include <nmbc/energy.hpp>
#include <span>
#include <vector>

namespace nmbcrun {

/// The balance of leapfrog for the interior, per cross-section area. Its energy is
///     E^{k+1/2} = dX sum rho v^2/2 + sum_q w_q (L_q u^k)(L_q u^{k+1})/2,
/// v = v^{k+1/2} of the interior nodes, q all squares of the lattice's energy that an interior node
/// takes part in, those of ghosts and of layer nodes, too. In a step it changes by the work of the
/// nodes outside, dt/2 sum_i F_i (v_i^{k+1/2} + v_i^{k-1/2}) with F_i = sum_q w_q L_qi L_q u^k, by
/// dX rho (v^{k+1/2} + v^{k-1/2})/2 (v^{k+1/2} - v') at nodes where somebody puts v^{k+1/2} in the
/// place of the lattice's own v', and by what the damping takes out; roundings apart.
struct Balance {
    double energy = 0;  ///< E
    double work = 0;    ///< of the sources, since the start
    double left = 0;    ///< gone through the left end since the start
    double right = 0;   ///< and through the right one
    double drift = 0;   ///< energy - (that at the start + work - left - right - damped)
};

/// Keeps the balance of a chain by looking at the velocities of the nodes that somebody may change,
/// before the sources, after them and after the ends: work at the ends and the sources only.
class Ledger {
  public:
    /// What a ledger goes on from, and beside it the chain's own state.
    struct Totals {
        double start = 0;  ///< E at the start
        double work = 0;
        double left = 0;
        double right = 0;
    };

    /// Starts with the chain as it is. driven: the interior nodes that sources may act on, from 0.
    Ledger(const nmbc::Chain& chain, std::span<const std::size_t> driven);

    /// Steps of the chain with its sources, which may change v of the driven nodes.
    template <class Prescribe>
    void advance(nmbc::Chain& chain, std::size_t steps, Prescribe&& prescribe) {
        chain.advance(
            steps,
            [&](std::span<const double> u, std::span<double> v, double time) {
                keep_kicked(v);
                prescribe(u, v, time);
                find_driven(v);
            },
            [&](std::span<const double> u, std::span<const double> v, double /*time*/) {
                enter(u, v);
            });
    }

    /// Of the chain after its last step, and of its energies there.
    Balance balance(const nmbc::Chain& chain, const nmbc::Energies& energies) const;

    const Totals& totals() const { return totals_; }
    /// Goes on with the chain as it is, after these totals.
    void resume(const nmbc::Chain& chain, const Totals& totals);

  private:
    /// One of the energy's at each node, in the user's units.
    struct Square {
        double weight;
        std::vector<double> stencil;  // from the first entry that is not 0 to the last
        std::size_t before;           // its node's place in that, from the first entry
    };
    /// An interior node whose velocity the sources or an end may change.
    struct Watched {
        std::size_t node = 0;
        double mass = 1;    // of an interior node's
        double old = 0;     // v half a step ago
        double kicked = 0;  // by the lattice, and then the sources
        double driven = 0;  // what the sources added
    };
    /// An edge of the interior: the nodes outside that share squares with interior ones.
    struct Edge {
        std::size_t outside = 0;          // the first of them
        std::size_t first = 0;            // the first node of those squares
        std::vector<double> old{};        // v of the nodes outside half a step ago
        std::vector<double> stiffness{};  // of those squares: a row for each node outside, twice
                                          // as many entries as there are rows
    };

    void watch(const nmbc::Chain& chain, std::span<const std::size_t> driven);
    Edge edge_at(std::size_t edge, bool is_left) const;
    void keep_old(std::span<const double> v);
    void keep_kicked(std::span<const double> v);
    void find_driven(std::span<const double> v);
    void enter(std::span<const double> u, std::span<const double> v);
    /// sum_i F_i (v_i + old v_i) over the nodes outside.
    static double power(const Edge& edge, std::span<const double> u, std::span<const double> v);
    /// E, which `energies` has but for the squares of nodes outside.
    double energy(const nmbc::Chain& chain, const nmbc::Energies& energies) const;

    std::vector<Square> squares_;
    std::size_t begin_;  // of the interior
    std::size_t end_;
    double mass_;  // rho dX
    double time_step_;
    std::vector<Watched> watched_;  // by node
    Edge left_;
    Edge right_;
    Totals totals_;
};

}  // namespace nmbcrun
