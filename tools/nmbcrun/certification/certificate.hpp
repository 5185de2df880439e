// SPDX-License-Identifier: MIT
/// Whether the two ends of a scene are stable together.
#pragma once

#include <nmbc/lattice.hpp>
#include <nmbc/table.hpp>
#include <optional>
#include <string>

#include "generator/stability/half_space.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Whether decaying waves may cross the chain of a scene.
bool is_short(const Scene& scene);

/// Whether PairOfEnds looks at the eigenvalues of that, unless an end is a half line.
bool has_eigenvalues(const Scene& scene);

/// The two ends of a scene, looked at in as many time steps as one likes.
class PairOfEnds {
  public:
    /// left, right: the tables of the ends, of which only the lattice counts where an end is fixed
    /// or free. Their coefficients exist at the scene's G. All three live as long as this.
    PairOfEnds(const Scene& scene, const nmbc::MatchingTable& left,
               const nmbc::MatchingTable& right);

    /// How a chain between the ends can grow at some length, in words with wave number and rate or
    /// amplification; empty where round_trip_verdict() certifies that it does not, in steps of
    /// time_step [time], which are dt omega_max / 2 = cfl. Of a damped lattice: at the scene's own
    /// length.
    /// Opposite an end from which nothing comes back (is_half_line()) an nmbc needs to have no
    /// growing mode and no resonance of its own; opposite a sponge or pml, the certificate of its
    /// table for any end that adds no energy (nmbc::Opposite::any).
    std::string objection(double time_step, double cfl);

  private:
    struct InTime {
        const nmbc::MatchingTable& table;
        std::optional<nmbcgen::HalfSpace> half_space;  // in continuous time, once it is needed
    };
    const nmbcgen::HalfSpace& in_time(InTime& end) const;

    const Scene& scene_;
    InTime left_;
    InTime right_;
    nmbc::Lattice lattice_;
};

}  // namespace nmbcrun
