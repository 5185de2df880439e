// SPDX-License-Identifier: MIT
/// A uniform chain between two ends, stepped by leapfrog.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/certificate.hpp>
#include <nmbc/chain_sweeps.hpp>
#include <nmbc/folded_energy.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/leapfrog.hpp>
#include <nmbc/mirror_images.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace nmbc {

/// All that a run goes on from.
template <class Real>
struct ChainState {
    std::size_t steps = 0;
    std::vector<Real> displacement;
    std::vector<Real> velocity;
    std::vector<double> damped;
    std::vector<Real> left;   ///< what the left end remembers
    std::vector<Real> right;  ///< and the right one
};

/// The state: displacement u at t and velocity v at t - dt/2, on nodes() entries each: ghosts, the
/// left end's layer, the interior, the right end's layer, ghosts.
template <class Real>
class BasicChain {
  public:
    /// At rest, at t = 0. Throws std::invalid_argument where a parameter is not positive and
    /// finite or the chain is too short for its ends, NotCertified where steps are beyond the
    /// interior's limit, or an end is certified with its like only and the other one is not, and as
    /// the ends do when they are made.
    BasicChain(Lattice lattice, const BasicChainEnd<Real>& left, const BasicChainEnd<Real>& right,
               const ChainParameters& parameters)
        : lattice_(with_mirror_images(std::move(lattice))),
          parameters_(checked(parameters)),
          left_(left.make(lattice_, parameters_)),
          right_(right.make(lattice_, parameters_)),
          folded_energy_(detail::folded(lattice_.energy)),
          force_(force_during(parameters_.time_step)),
          damping_(damping_during(parameters_.time_step)) {
        require_stable_interior();
        require_certified_pair();
        const std::size_t least =
            std::max(left_->least_interior_nodes(), right_->least_interior_nodes());
        if (parameters.nodes < least) {
            throw std::invalid_argument("the chain needs at least " + std::to_string(least) +
                                        " interior nodes for these ends");
        }
        if (parameters.nodes > memory_.max_size() / 4) {
            throw std::length_error("so many nodes fit in no memory");
        }
        const std::size_t second = detail::second_field<Real>(nodes());
        memory_.resize(second + nodes(), 0);
        displacement_ = std::span(memory_).first(nodes());
        velocity_ = std::span(memory_).subspan(second);
        if (is_damped()) {
            damping_change_.resize(nodes(), 0);
            damped_.resize(nodes(), 0);
        }
    }

    /// Between two like ends.
    BasicChain(Lattice lattice, const BasicChainEnd<Real>& both, const ChainParameters& parameters)
        : BasicChain(std::move(lattice), both, both, parameters) {}

    /// With a mirror image of every square: each node has half of each of its bonds.
    const Lattice& lattice() const { return lattice_; }
    const ChainParameters& parameters() const { return parameters_; }
    /// The lattice's energy as energies() sums it.
    const std::vector<detail::FoldedSquare>& folded_energy() const { return folded_energy_; }
    /// Ghost nodes at each end; nodes in all: interior, layers and ghosts.
    std::size_t ghosts() const { return lattice_.reach(); }
    std::size_t nodes() const {
        return parameters_.nodes + left_->layer_nodes() + right_->layer_nodes() + 2 * ghosts();
    }
    /// Entry of the first interior node.
    std::size_t first_interior() const { return first_interior_from(End::left); }
    /// Interior nodes next to an end whose velocities it may change.
    std::size_t nodes_changed_by(End end) const {
        return (end == End::left ? left_ : right_)->least_interior_nodes();
    }
    /// Of the interior nodes next to an end that has it for them; nullptr: they have the lattice's.
    const EdgeEnergy* edge_energy(End end) const {
        return (end == End::left ? left_ : right_)->own_energy();
    }
    double time() const { return static_cast<double>(steps_) * parameters_.time_step; }
    std::size_t steps() const { return steps_; }

    std::span<const Real> displacement() const { return displacement_; }
    std::span<const Real> velocity() const { return velocity_; }

    /// To be written to between two steps. To the ends it is a new start, at the next step.
    std::span<Real> displacement() { return to_be_written(displacement_); }
    std::span<Real> velocity() { return to_be_written(velocity_); }

    /// Energy [per cross-section area] that the damping force has taken out at each node since the
    /// start, ghosts (which it does not act on) included; empty where the lattice is undamped.
    std::span<const double> damped() const { return damped_; }

    /// Sets u and v at t = 0 on all nodes; v is moved to -dt/2 by the lattice's acceleration. The
    /// ghosts of a fixed or free end are as it has them, here and in every step, whatever is given.
    void start(std::span<const Real> u, std::span<const Real> v) {
        if (u.size() != nodes() || v.size() != nodes()) {
            throw std::invalid_argument(
                "initial data must have an entry for every node, layers and ghosts included");
        }
        steps_ = 0;
        std::ranges::fill(damped_, 0.0);
        std::ranges::copy(u, displacement_.begin());
        std::ranges::copy(v, velocity_.begin());
        start_ends();
        const double back = -parameters_.time_step / 2;
        if (is_damped()) {
            find_damping(*damping_during(back), back);
            damp();
        }
        force_during(back)->kick(displacement_, velocity_);
        const std::span<const Real> fixed = displacement_;
        left_->after_start({fixed, End::left}, {velocity_, End::left}, back);
        right_->after_start({fixed, End::right}, {velocity_, End::right}, back);
        is_written_to_ = false;
        start_ends();  // their ghosts' velocities follow those of -dt/2
    }

    /// Starts the ends anew where displacement() or velocity() were written to since the last step,
    /// as the next step does: their ghosts are right from now on.
    void restart_ends() {
        if (std::exchange(is_written_to_, false)) {
            start_ends();
        }
    }

    /// Steps, each of them: v to t + dt/2, ghosts by their end, u to t + dt. Before the ends,
    /// `prescribe` may set velocities of interior nodes: it is called with u at t, v at t + dt/2
    /// and t + dt. After them, `observe` sees the same two fields whole, and t + dt. Many steps at
    /// once are faster than one by one, and the same bit for bit (leapfrog.hpp).
    template <class Prescribe, class Observe>
    void advance(std::size_t steps, Prescribe&& prescribe, Observe&& observe) {
        detail::advance(*this, steps, prescribe, observe);
    }

    template <class Prescribe>
    void advance(std::size_t steps, Prescribe&& prescribe) {
        advance(steps, prescribe, ignore_fields);
    }

    /// Steps of the chain left to itself.
    void advance(std::size_t steps) { advance(steps, ignore_fields, ignore_fields); }

    /// One step, as advance() has them.
    template <class Prescribe, class Observe>
    void step(Prescribe&& prescribe, Observe&& observe) {
        advance(1, prescribe, observe);
    }

    template <class Prescribe>
    void step(Prescribe&& prescribe) {
        advance(1, prescribe, ignore_fields);
    }

    void step() { advance(1); }

    ChainState<Real> state() const {
        const auto copy = [](auto values) { return std::vector(values.begin(), values.end()); };
        return {steps_,  copy(displacement_),   copy(velocity_),
                damped_, copy(left_->memory()), copy(right_->memory())};
    }

    /// Goes on from the state of a chain that was made with the same arguments, bit for bit as it
    /// would have. Throws std::invalid_argument where a size is another one.
    void resume(const ChainState<Real>& state) {
        if (state.displacement.size() != nodes() || state.velocity.size() != nodes() ||
            state.damped.size() != damped_.size() || state.left.size() != left_->memory().size() ||
            state.right.size() != right_->memory().size()) {
            throw std::invalid_argument("the stored state is that of another chain");
        }
        steps_ = state.steps;
        std::ranges::copy(state.displacement, displacement_.begin());
        std::ranges::copy(state.velocity, velocity_.begin());
        damped_ = state.damped;
        left_->remember(state.left);
        right_->remember(state.right);
        is_written_to_ = false;
    }

    /// Whether every displacement and velocity is finite.
    bool is_finite() const { return first_not_finite() == nodes(); }

    /// The first entry with a displacement or velocity that is not finite; nodes() if there is
    /// none.
    std::size_t first_not_finite() const {
        std::size_t node = 0;
        while (node < nodes() && std::isfinite(displacement_[node]) &&
               std::isfinite(velocity_[node])) {
            ++node;
        }
        return node;
    }

  private:
    template <class Body, class... Hooks>
    friend void detail::advance(Body& body, std::size_t steps, Hooks&... hooks);

    static constexpr auto ignore_fields = [](const auto& /*u*/, const auto& /*v*/,
                                             double /*time*/) {};

    static const ChainParameters& checked(const ChainParameters& p) {
        for (const double value : {p.youngs_modulus, p.density, p.spacing, p.time_step}) {
            if (!(value > 0) || !std::isfinite(value)) {
                throw std::invalid_argument(
                    "Young's modulus, density, spacing and time step must be positive and finite");
            }
        }
        return p;
    }

    /// Whatever the ends are.
    void require_stable_interior() const {
        const double longest = 2 * interior_cfl(lattice_) / maximum_frequency(lattice_);
        const double step = parameters_.time_step * parameters_.wave_speed() / parameters_.spacing;
        constexpr double roundings = 1e-9;
        if (step > longest * (1 + roundings)) {
            throw NotCertified("the interior of the chain is stable in steps up to " +
                               detail::to_text(longest) + " dX/c, and the step is " +
                               detail::to_text(step) + " dX/c");
        }
    }

    void require_certified_pair() const {
        const BoundaryCoefficients* left = left_->only_opposite();
        const BoundaryCoefficients* right = right_->only_opposite();
        const bool alike = left != nullptr && right != nullptr && left->c == right->c &&
                           left->b == right->b && left->stride == right->stride;
        if (!alike && (left != nullptr || right != nullptr)) {
            throw NotCertified(
                "a matching boundary opposite another end than its like: take its coefficients "
                "with Opposite::any, or with allow_unstable to run it");
        }
    }

    std::span<Real> to_be_written(std::span<Real> field) {
        is_written_to_ = true;
        return field;
    }

    void start_ends() {
        left_->start({displacement_, End::left}, {velocity_, End::left}, steps_);
        right_->start({displacement_, End::right}, {velocity_, End::right}, steps_);
    }

    bool is_damped() const { return !lattice_.damping.empty(); }

    /// The lattice's own forces during so long, which they change v by.
    auto force_during(double duration) const {
        const double rate = parameters_.wave_speed() / parameters_.spacing;
        return detail::make_kick<Real>(lattice_.symbol, -duration * rate * rate);
    }

    /// The same of the damping; none where there is none.
    std::unique_ptr<const detail::Kick<Real>> damping_during(double duration) const {
        if (!is_damped()) {
            return nullptr;
        }
        const double rate = parameters_.wave_speed() / parameters_.spacing;
        return detail::make_kick<Real>(lattice_.damping, -duration * rate);
    }

    /// v of the layers and the interior to t + dt/2, by the lattice's own forces.
    void kick() {
        restart_ends();
        if (is_damped()) {
            find_damping(*damping_, parameters_.time_step);
            count_damped();
            damp();
        }
        force_->kick(displacement_, velocity_);
    }

    template <class Prescribe, class Observe>
    void close_sides(Prescribe& prescribe, Observe& observe) {
        const std::size_t done = steps_++;
        const std::span<const Real> u = displacement_;
        left_->complete_kick({u, End::left}, {velocity_, End::left});
        right_->complete_kick({u, End::right}, {velocity_, End::right});
        prescribe(u, std::span<Real>(velocity_), time());
        left_->after_kick({u, End::left}, {velocity_, End::left}, done);
        right_->after_kick({u, End::right}, {velocity_, End::right}, done);
        count_damped();
        observe(u, std::span<const Real>(velocity_), time());
    }

    /// u to t + dt.
    void drift() {
        detail::drift<Real>(static_cast<Real>(parameters_.time_step), displacement_, velocity_);
    }

    void drift_and_kick() {
        if (is_damped() || is_written_to_) {
            drift();
            kick();
        } else {
            force_->drift_and_kick(static_cast<Real>(parameters_.time_step), displacement_,
                                   velocity_);
        }
    }

    /// What the damping changes v by in so long, from the old v.
    void find_damping(const detail::Kick<Real>& damping, double duration) {
        std::ranges::fill(damping_change_, Real{0});
        damping.kick(velocity_, damping_change_);
        const std::span<const Real> v = velocity_;
        const std::span<Real> change = damping_change_;
        left_->complete_damping({v, End::left}, {change, End::left}, duration);
        right_->complete_damping({v, End::right}, {change, End::right}, duration);
    }

    void damp() {
        for (std::size_t node = ghosts(); node + ghosts() < nodes(); ++node) {
            velocity_[node] += damping_change_[node];
        }
    }

    /// Half of a step's work against the damping force: its path is dt times the mean of the old
    /// velocities and the new ones, each of which is there once.
    void count_damped() {
        if (!is_damped()) {
            return;
        }
        const double half = parameters_.density * parameters_.spacing / 2;
        const auto count = [&](std::size_t node, double mass) {
            damped_[node] -= mass * half * static_cast<double>(damping_change_[node]) *
                             static_cast<double>(velocity_[node]);
        };
        for (std::size_t node = ghosts(); node + ghosts() < nodes(); ++node) {
            count(node, 1);
        }
        for (const End end : {End::left, End::right}) {
            const EdgeEnergy* const edge = edge_energy(end);
            for (std::size_t i = 0; edge != nullptr && i < edge->mass.size(); ++i) {
                const std::size_t inwards = first_interior_from(end) + i;
                count(end == End::left ? inwards : nodes() - 1 - inwards, edge->mass[i] - 1);
            }
        }
    }

    /// Nodes between an end of the fields and its outermost interior node.
    std::size_t first_interior_from(End end) const {
        return ghosts() + (end == End::left ? left_ : right_)->layer_nodes();
    }

    Lattice lattice_;
    ChainParameters parameters_;
    std::unique_ptr<BoundaryCondition<Real>> left_;
    std::unique_ptr<BoundaryCondition<Real>> right_;
    std::vector<detail::FoldedSquare> folded_energy_;
    std::unique_ptr<const detail::Kick<Real>> force_;    // of one time step
    std::unique_ptr<const detail::Kick<Real>> damping_;  // of the damping; none where undamped
    std::vector<Real> memory_;                           // of the two fields
    std::span<Real> displacement_;
    std::span<Real> velocity_;
    std::vector<Real> damping_change_;  // by the damping in this step; empty where undamped
    std::vector<double> damped_;
    std::size_t steps_ = 0;
    bool is_written_to_ = false;  // by the user, since the last step
};

using Chain = BasicChain<double>;

}  // namespace nmbc
