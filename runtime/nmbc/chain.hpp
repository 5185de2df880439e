// SPDX-License-Identifier: MIT
/// A uniform chain between two matching boundaries, stepped by leapfrog.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/boundary.hpp>
#include <nmbc/lattice.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace nmbc {

/// Physical set-up, in any one consistent system of units.
struct ChainParameters {
    std::size_t nodes = 0;      ///< interior nodes
    double spacing = 1;         ///< dX [length]
    double youngs_modulus = 1;  ///< E [stress]
    double density = 1;         ///< rho [mass/volume]
    double time_step = 0;       ///< dt [time]
    GhostRule ghost_rule = GhostRule::midpoint;

    double wave_speed() const { return std::sqrt(youngs_modulus / density); }
};

/// The state: displacement u at t and velocity v at t - dt/2, on nodes() entries each, of which
/// the first and last ghosts() are ghost nodes.
class Chain {
  public:
    /// At rest, at t = 0. Throws std::invalid_argument where a parameter is not positive and
    /// finite or the chain is too short for its boundaries, and as MatchingBoundary does.
    Chain(Lattice lattice, const BoundaryCoefficients& coefficients,
          const ChainParameters& parameters)
        : lattice_(std::move(lattice)),
          parameters_(parameters),
          boundary_(coefficients, lattice_.reach(), parameters.wave_speed(), parameters.spacing,
                    parameters.time_step, parameters.ghost_rule) {
        if (!(parameters.youngs_modulus > 0) || !(parameters.density > 0)) {
            throw std::invalid_argument("Young's modulus and density must be positive");
        }
        const std::size_t smallest = boundary_.reach() - boundary_.ghost_layers();
        if (parameters.nodes < std::max<std::size_t>(smallest, 1)) {
            throw std::invalid_argument("the chain needs at least " + std::to_string(smallest) +
                                        " interior nodes for this boundary condition");
        }
        displacement_.resize(nodes(), 0.0);
        velocity_.resize(nodes(), 0.0);
        acceleration_.resize(nodes(), 0.0);
    }

    const Lattice& lattice() const { return lattice_; }
    const ChainParameters& parameters() const { return parameters_; }
    std::size_t ghosts() const { return lattice_.reach(); }
    std::size_t nodes() const { return parameters_.nodes + 2 * ghosts(); }
    double time() const { return static_cast<double>(steps_) * parameters_.time_step; }
    std::size_t steps() const { return steps_; }

    std::span<const double> displacement() const { return displacement_; }
    std::span<double> displacement() { return displacement_; }
    std::span<const double> velocity() const { return velocity_; }
    std::span<double> velocity() { return velocity_; }

    /// Sets u and v at t = 0 on all nodes; v is moved to -dt/2 by the lattice's acceleration.
    void start(std::span<const double> u, std::span<const double> v) {
        if (u.size() != nodes() || v.size() != nodes()) {
            throw std::invalid_argument(
                "initial data must have an entry for every node, ghosts "
                "included");
        }
        steps_ = 0;
        std::ranges::copy(u, displacement_.begin());
        std::ranges::copy(v, velocity_.begin());
        accelerate(-parameters_.time_step / 2);
    }

    /// One step: v to t + dt/2, ghosts by (60), u to t + dt. Before the ghosts, `prescribe` may
    /// set velocities of interior nodes: it is called with u at t, v at t + dt/2 and t + dt.
    template <class Prescribe>
    void step(Prescribe&& prescribe) {
        const double dt = parameters_.time_step;
        accelerate(dt);
        ++steps_;
        prescribe(std::span<const double>(displacement_), std::span<double>(velocity_), time());
        boundary_.update(displacement_, velocity_, End::left);
        boundary_.update(displacement_, velocity_, End::right);
        for (std::size_t node = 0; node < displacement_.size(); ++node) {
            displacement_[node] += dt * velocity_[node];
        }
    }

    /// One step of the free chain.
    void step() {
        step([](std::span<const double>, std::span<double>, double) {});
    }

    /// Whether every displacement and velocity is finite.
    bool is_finite() const { return first_not_finite() == nodes(); }

    /// The first node with a displacement or velocity that is not finite; nodes() if there is none.
    std::size_t first_not_finite() const {
        std::size_t node = 0;
        while (node < nodes() && std::isfinite(displacement_[node]) &&
               std::isfinite(velocity_[node])) {
            ++node;
        }
        return node;
    }

  private:
    /// v += duration * a on the interior nodes.
    void accelerate(double duration) {
        const double rate = parameters_.wave_speed() / parameters_.spacing;
        accelerations(lattice_, rate * rate, displacement_, acceleration_);
        for (std::size_t node = ghosts(); node + ghosts() < nodes(); ++node) {
            velocity_[node] += duration * acceleration_[node];
        }
    }

    Lattice lattice_;
    ChainParameters parameters_;
    MatchingBoundary boundary_;
    std::vector<double> displacement_;
    std::vector<double> velocity_;
    std::vector<double> acceleration_;
    std::size_t steps_ = 0;
};

}  // namespace nmbc
