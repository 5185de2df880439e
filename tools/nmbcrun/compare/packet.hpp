// SPDX-License-Identifier: MIT
/// What an end sends back of a narrow band of waves, measured.
#pragma once

#include <nmbc/boundary_condition.hpp>
#include <nmbc/lattice.hpp>
#include <vector>

namespace nmbcrun {

/// d(omega')/d(xi) [c], signed, omega' what leapfrog in steps of time_step [dX/c] makes of omega;
/// 0: in continuous time. 0 where omega is.
double group_velocity(const nmbc::Lattice& lattice, double xi, double time_step);

/// One wave of a packet, Re amplitude exp i(xi x + theta t/dt), xi signed so that it travels to the
/// left. Units dX = c = 1.
struct Wave {
    double xi;
    double amplitude;
    double omega;       ///< of the lattice at xi
    double half_angle;  ///< theta/2 in steps of dt: sin(theta/2) = omega dt/2

    /// Up to a common factor. The cosine is from u at k and k+1 in leapfrog's potential energy.
    double energy() const;
};

/// A Gaussian packet of waves about a wave number.
class Packet {
  public:
    /// middle [1/dX] in (0, pi); time_step [dX/c].
    Packet(const nmbc::Lattice& lattice, double middle, double time_step);

    /// Evenly spaced waves that stand for its spectrum: closer ones where the packet holds the
    /// frequency of a band edge, at which the reflection jumps.
    std::vector<Wave> spectrum() const;

    /// Whether it can be measured in a second or so: all its waves are within the band, travel at
    /// c/10 at least and are no longer than 200 dX.
    bool is_measurable() const;

    /// The part of its energy that is still there when the packet has met the end, at the left of
    /// a chain so long that nothing has come back from its right end. The packet, its periodic
    /// images left out, is cut off where it is 1e-9 of its height, so that less than 1e-17 of its
    /// energy is taken for reflected. Where it holds a band edge's frequency it is given four times
    /// as long: waves that hardly travel linger at the end, which takes in more of them.
    double reflected_by(const nmbc::ChainEnd& end, std::size_t layer) const;

    /// Steps that reflected_by() takes.
    std::size_t steps(std::size_t layer) const;

  private:
    std::vector<Wave> waves_about(int parts_per_sigma) const;
    bool holds_band_edge() const;

    const nmbc::Lattice& lattice_;
    double middle_;
    double time_step_;
    double reach_;        ///< half the packet's length [dX]
    double slowest_ = 0;  ///< group velocity of the packet's waves [c]
    double fastest_ = 0;  ///< of all the lattice's waves
    bool forward_;        ///< whether its waves travel as their crests do
    std::vector<Wave> waves_;
    bool at_band_edge_ = false;
};

}  // namespace nmbcrun
