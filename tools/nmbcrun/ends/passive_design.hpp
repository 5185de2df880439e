// SPDX-License-Identifier: MIT
/// Passive ends, designed for the lattice and the steps of the chain that they end. What they do in
/// a step is in nmbc/passive.hpp.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/lattice.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// nmbc::PassiveEnd by nmbcgen's designer. The design of a lattice and a step is made once a
/// process and takes up to seconds.
struct DesignedEnd {
    /// The largest cfl that is chosen for it: its springs are stiffer than the lattice's.
    static constexpr double largest_cfl = 0.9;
    static constexpr int largest_horizon = 6;  ///< designs of larger ones take too long

    /// Throws std::invalid_argument for other lattices than nopd1d of constant influence without
    /// damping, and SceneError where there is no design for such steps.
    static std::unique_ptr<nmbc::BoundaryCondition<double>> make(
        const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
        std::type_identity<double> precision);
};

/// "designed for ..", where the scene's lattice is something else; empty where there may be a
/// design in some steps.
std::string why_not_designed(const Scene& scene);

/// What an end makes of the waves of one frequency that come to it: on the node j nodes inwards of
/// the innermost one of its own, from a wave k^-j, k one of those that travel, a sum over all
/// outgoing ones of amplitude k^j.
struct WavesSentBack {
    std::vector<std::complex<double>> k;  ///< of the outgoing ones, those that travel first
    Eigen::MatrixXcd amplitudes;          ///< rows outgoing, columns incident
    Eigen::Index column = 0;              ///< of the wave asked for
    double energy = 0;                    ///< the part of that wave's that comes back
};

/// By xi dX of a wave, in steps of time_step [dX/c]. Throws as DesignedEnd.
std::function<WavesSentBack(double xi)> sent_back_by_passive_end(const nmbc::Lattice& lattice,
                                                                 double time_step);

}  // namespace nmbcrun
