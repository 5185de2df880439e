// SPDX-License-Identifier: MIT
/// A uniform chain between two ends, stepped by leapfrog.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/certificate.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/lattice.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace nmbc {

/// Physical set-up, in any one consistent system of units.
struct ChainParameters {
    std::size_t nodes = 0;                       ///< interior nodes
    double spacing = 1;                          ///< dX [length]
    double youngs_modulus = 1;                   ///< E [stress]
    double density = 1;                          ///< rho [mass/volume]
    double time_step = 0;                        ///< dt [time]
    GhostRule ghost_rule = GhostRule::midpoint;  ///< of two like ends

    double wave_speed() const { return std::sqrt(youngs_modulus / density); }
};

/// The state: displacement u at t and velocity v at t - dt/2, on nodes() entries each, of which
/// the first and last ghosts() are ghost nodes.
class Chain {
  public:
    /// At rest, at t = 0. Throws std::invalid_argument where a parameter is not positive and
    /// finite or the chain is too short for its ends, and as MatchingBoundary does; NotCertified
    /// where it is shorter than the certificate of an end allows.
    Chain(Lattice lattice, const ChainEnd& left, const ChainEnd& right,
          const ChainParameters& parameters)
        : lattice_(std::move(lattice)),
          parameters_(checked(parameters)),
          left_(make_end(left)),
          right_(make_end(right)) {
        const std::size_t smallest = std::max(reach_of(left_), reach_of(right_));
        if (parameters.nodes < smallest) {
            throw std::invalid_argument("the chain needs at least " + std::to_string(smallest) +
                                        " interior nodes for these ends");
        }
        require_certified_for(left);
        require_certified_for(right);
        displacement_.resize(nodes(), 0.0);
        velocity_.resize(nodes(), 0.0);
        acceleration_.resize(nodes(), 0.0);
        if (is_damped()) {
            deceleration_.resize(nodes(), 0.0);
            damped_.resize(nodes(), 0.0);
        }
    }

    /// Between two like matching boundaries with the ghost rule of the parameters.
    Chain(Lattice lattice, const BoundaryCoefficients& coefficients,
          const ChainParameters& parameters)
        : Chain(std::move(lattice), MatchingEnd{coefficients, parameters.ghost_rule},
                MatchingEnd{coefficients, parameters.ghost_rule}, parameters) {}

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

    /// Energy [per cross-section area] that the damping force has taken out at each node since the
    /// start, ghosts (which it does not act on) included; empty where the lattice is undamped.
    std::span<const double> damped() const { return damped_; }

    /// Sets u and v at t = 0 on all nodes; v is moved to -dt/2 by the lattice's acceleration. The
    /// ghosts of a fixed or free end are as it has them, here and in every step, whatever is given.
    void start(std::span<const double> u, std::span<const double> v) {
        if (u.size() != nodes() || v.size() != nodes()) {
            throw std::invalid_argument(
                "initial data must have an entry for every node, ghosts "
                "included");
        }
        steps_ = 0;
        std::ranges::fill(damped_, 0.0);
        std::ranges::copy(u, displacement_.begin());
        std::ranges::copy(v, velocity_.begin());
        find_accelerations();
        kick(-parameters_.time_step / 2);
        impose_on(velocity_);
    }

    /// One step: v to t + dt/2, ghosts by their end, u to t + dt. Before the ghosts, `prescribe`
    /// may set velocities of interior nodes: it is called with u at t, v at t + dt/2 and t + dt.
    template <class Prescribe>
    void step(Prescribe&& prescribe) {
        const double dt = parameters_.time_step;
        find_accelerations();
        count_damped();
        kick(dt);
        ++steps_;
        prescribe(std::span<const double>(displacement_), std::span<double>(velocity_), time());
        count_damped();
        match(left_, End::left);
        match(right_, End::right);
        impose_on(velocity_);
        for (std::size_t node = 0; node < displacement_.size(); ++node) {
            displacement_[node] += dt * velocity_[node];
        }
    }

    /// One step of the chain left to itself.
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
    using Condition = std::variant<MatchingBoundary, FixedEnd, FreeEnd>;

    static const ChainParameters& checked(const ChainParameters& p) {
        for (const double value : {p.youngs_modulus, p.density, p.spacing, p.time_step}) {
            if (!(value > 0) || !std::isfinite(value)) {
                throw std::invalid_argument(
                    "Young's modulus, density, spacing and time step must be positive and finite");
            }
        }
        return p;
    }

    Condition make_end(const ChainEnd& end) const {
        if (const auto* matching = std::get_if<MatchingEnd>(&end)) {
            return MatchingBoundary(matching->coefficients, ghosts(), parameters_.wave_speed(),
                                    parameters_.spacing, parameters_.time_step,
                                    matching->ghost_rule);
        }
        return std::holds_alternative<FixedEnd>(end) ? Condition(FixedEnd{}) : FreeEnd{};
    }

    /// What is certified is certified for its own lattice and, where that is damped, for long
    /// chains.
    void require_certified_for(const ChainEnd& end) const {
        const auto* matching = std::get_if<MatchingEnd>(&end);
        if (matching == nullptr || matching->coefficients.symbol.empty()) {
            return;
        }
        const int least = matching->coefficients.least_nodes;
        if (matching->coefficients.symbol != lattice_.symbol ||
            matching->coefficients.damping != lattice_.damping) {
            throw NotCertified(
                "the boundary is certified for another lattice: horizon, G or tau are not those of "
                "the chain; take the coefficients with allow_unstable to run it");
        }
        if (parameters_.nodes < static_cast<std::size_t>(least)) {
            throw NotCertified("a chain with this damped matching boundary is certified from " +
                               std::to_string(least) + " interior nodes on, and has " +
                               std::to_string(parameters_.nodes) +
                               "; take the coefficients with allow_unstable to run it");
        }
    }

    /// Interior nodes that an end reads; one at least, so that there is a chain.
    std::size_t reach_of(const Condition& condition) const {
        if (const auto* matching = std::get_if<MatchingBoundary>(&condition)) {
            return std::max<std::size_t>(matching->reach() - ghosts(), 1);
        }
        return std::holds_alternative<FreeEnd>(condition) ? ghosts() : 1;
    }

    /// Ghost velocities at a matching end.
    void match(const Condition& condition, End end) {
        if (const auto* matching = std::get_if<MatchingBoundary>(&condition)) {
            matching->update(displacement_, velocity_, end);
        }
    }

    /// Ghost entries of u or v at fixed and free ends.
    void impose_on(std::vector<double>& field) const {
        for (const auto& [condition, end] : {std::pair(&left_, End::left), {&right_, End::right}}) {
            if (const auto* fixed = std::get_if<FixedEnd>(condition)) {
                impose(*fixed, field, ghosts(), end);
            } else if (const auto* free = std::get_if<FreeEnd>(condition)) {
                impose(*free, field, ghosts(), end);
            }
        }
    }

    bool is_damped() const { return !lattice_.damping.empty(); }

    /// Of the interior nodes, from u and, where the lattice is damped, the old v.
    void find_accelerations() {
        impose_on(displacement_);
        impose_on(velocity_);
        const double rate = parameters_.wave_speed() / parameters_.spacing;
        accelerations(lattice_, rate * rate, displacement_, acceleration_);
        if (is_damped()) {
            decelerations(lattice_, rate, velocity_, deceleration_);
            for (std::size_t node = ghosts(); node + ghosts() < nodes(); ++node) {
                acceleration_[node] -= deceleration_[node];
            }
        }
    }

    /// Half of a step's work against the damping force: its path is dt times the mean of the old
    /// velocities and the new ones, each of which is there once.
    void count_damped() {
        if (!is_damped()) {
            return;
        }
        const double half = parameters_.density * parameters_.spacing * parameters_.time_step / 2;
        for (std::size_t node = ghosts(); node + ghosts() < nodes(); ++node) {
            damped_[node] += half * deceleration_[node] * velocity_[node];
        }
    }

    /// v += duration * a on the interior nodes.
    void kick(double duration) {
        for (std::size_t node = ghosts(); node + ghosts() < nodes(); ++node) {
            velocity_[node] += duration * acceleration_[node];
        }
    }

    Lattice lattice_;
    ChainParameters parameters_;
    Condition left_;
    Condition right_;
    std::vector<double> displacement_;
    std::vector<double> velocity_;
    std::vector<double> acceleration_;
    std::vector<double> deceleration_;  // the damping's part of it; empty where undamped
    std::vector<double> damped_;
    std::size_t steps_ = 0;
};

}  // namespace nmbc
