// SPDX-License-Identifier: MIT
/// Sums of waves that solve a chain's own equations, in space and in time steps.
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/node_line.hpp>
#include <span>
#include <vector>

namespace nmbcrun {

/// u = Re(amplitude zeta^k exp(i xi x)) at step k and place x, counted in dX from an origin of the
/// sum's own.
struct LatticeWave {
    std::complex<double> amplitude;  ///< [length]
    double wave_number = 0;          ///< xi [1/dX], 0 to pi
    std::complex<double> change;     ///< zeta - 1, zeta the factor of a time step
    double group_velocity = 0;       ///< without damping [dX/time], positive to the right
};

/// The Fourier transform of a function of x [dX], the integral of f(x) exp(-i xi x), which is 0, or
/// as good as, above the wave number `highest` [1/dX].
struct Transform {
    std::function<std::complex<double>(double xi)> value;
    double highest = 0;
};

/// The waves that make f(x) of the whole numbers x at step 0 and repeat after `period` of them, all
/// of whose energy goes towards one end. Each has the zeta of leapfrog in this lattice,
///     zeta^2 - (2 - dt^2 omega^2 - dt tau sigma) zeta + (1 - dt tau sigma) = 0;
/// undamped zeta = exp(-i omega_d dt) with sin(omega_d dt/2) = dt omega/2. The sign of omega_d
/// follows the group velocity: a backward wave's phase runs against its energy. What is so damped
/// that it does not swing has no direction. Waves below 1e-18 of the largest are left out.
std::vector<LatticeWave> one_way_waves(const Transform& transform, std::size_t period,
                                       nmbc::End towards, const nmbc::Lattice& lattice,
                                       const nmbc::ChainParameters& parameters);

/// A sum of waves at nodes next to each other.
class WavesAtNodes {
  public:
    /// first: place of the first of them in the sum's own counting [dX].
    WavesAtNodes(const std::vector<LatticeWave>& waves, double first, double time_step);

    /// Adds u of step k to `u`, and (u of step k + 1, less u of step k) / dt to `v`: an entry for
    /// each node.
    void add(double k, std::span<double> u, std::span<double> v) const;

  private:
    struct Wave {
        std::complex<double> first;     // at the first node, step 0
        std::complex<double> next;      // from a node to the next
        std::complex<double> log_zeta;  // from a step to the next
        std::complex<double> velocity;  // v of u = 1
    };
    std::vector<Wave> waves_;
};

}  // namespace nmbcrun
