// SPDX-License-Identifier: MIT
/// Where the energy of a chain's interior comes from and goes to, balanced in every step.
#pragma once

#include <cstddef>
#include <nmbc/chain.hpp>
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

/// Keeps the balance of a chain by looking at its velocities before the sources, after them and
/// after the ends: three passes over the interior in a step, and some work at the ends.
class Ledger {
  public:
    /// What a ledger goes on from, and beside it the chain's own state.
    struct Totals {
        double start = 0;  ///< E at the start
        double work = 0;
        double left = 0;
        double right = 0;
    };

    /// Starts with the chain as it is.
    explicit Ledger(const nmbc::Chain& chain);

    /// One step of the chain with its sources, which may change v of interior nodes.
    template <class Prescribe>
    void step(nmbc::Chain& chain, Prescribe&& prescribe) {
        chain.step(
            [&](std::span<const double> u, std::span<double> v, double time) {
                keep_kicked(v);
                prescribe(u, v, time);
                find_driven(v);
            },
            [&](std::span<const double> u, std::span<const double> v, double /*time*/) {
                enter(u, v);
            });
    }

    /// Of the chain after its last step.
    Balance balance(const nmbc::Chain& chain) const;

    const Totals& totals() const { return totals_; }
    /// Goes on with the chain as it is, after these totals.
    void resume(const nmbc::Chain& chain, const Totals& totals);

  private:
    struct Change {
        std::size_t node;
        double velocity;  // that a source added
    };

    void keep_kicked(std::span<const double> v);
    void find_driven(std::span<const double> v);
    void enter(std::span<const double> u, std::span<const double> v);
    double energy(std::span<const double> u, std::span<const double> v) const;
    /// sum_i F_i (v_i + old v_i) over the nodes from `first` to `last`-1, all outside, of the
    /// squares that have a node before `edge` and one from there on.
    double power(std::span<const double> u, std::span<const double> v, std::size_t edge,
                 std::size_t first, std::size_t last) const;

    /// Weights in the user's units; stencils from the first entry that is not 0 to the last.
    std::vector<nmbc::Lattice::Square> squares_;
    std::size_t begin_;  // of the interior
    std::size_t end_;
    double mass_;  // rho dX
    double time_step_;
    std::vector<double> old_;     // v half a step ago, all nodes
    std::vector<double> kicked_;  // by the lattice and then the sources
    std::vector<Change> driven_;  // by the sources
    Totals totals_;
};

}  // namespace nmbcrun
