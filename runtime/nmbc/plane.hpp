// SPDX-License-Identifier: MIT
/// A rectangle of a plane lattice between four sides, stepped by leapfrog.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nmbc/bond_force.hpp>
#include <nmbc/bond_states.hpp>
#include <nmbc/coefficients.hpp>
#include <nmbc/leapfrog.hpp>
#include <nmbc/plane_dashpots.hpp>
#include <nmbc/plane_force.hpp>
#include <nmbc/plane_ghosts.hpp>
#include <nmbc/plane_model.hpp>
#include <nmbc/plane_parameters.hpp>
#include <nmbc/plane_pieces.hpp>
#include <nmbc/plane_potential.hpp>
#include <nmbc/plane_sides.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace nmbc {

struct PlaneEnergies;
template <class Real>
struct PlaneState;

/// The state: u at t and v at t - dt/2, two components each, on grid(): ghosts, the layers of
/// passive sides, the interior.
template <class Real>
class BasicPlane {
  public:
    /// At rest, at t = 0. Throws std::invalid_argument where a parameter is not positive and
    /// finite, sides do not go together, or the body is too thin for them.
    BasicPlane(const PlaneModel& model, const PlaneSides& sides, const PlaneParameters& parameters);

    const PlaneModel& model() const { return model_; }
    const PlaneSides& sides() const { return sides_; }
    const PlaneParameters& parameters() const { return parameters_; }

    /// Nodes of a field: ghosts and layers included.
    Grid grid() const { return {.nx = nx_ + 2 * ghosts_, .ny = ny_ + 2 * ghosts_}; }
    /// The entry of an interior node in the fields.
    std::size_t entry(std::size_t x, std::size_t y) const {
        return (y + ghosts_ + layers_[2]) * grid().nx + x + ghosts_ + layers_[0];
    }
    std::size_t ghosts() const { return ghosts_; }
    /// Of a node by its entry [per thickness], of displacements of this component.
    double mass(std::size_t component, std::size_t entry) const {
        const auto at = [this](std::size_t place) {
            return static_cast<std::ptrdiff_t>(place) - static_cast<std::ptrdiff_t>(ghosts_);
        };
        return parameters_.density * parameters_.spacing * parameters_.spacing *
               mass_of(component, at(entry % grid().nx), at(entry / grid().nx));
    }
    /// Between the ghosts of a side and the interior; sides in the order of plane_sides.
    const std::array<std::size_t, 4>& layers() const { return layers_; }

    double time() const { return static_cast<double>(steps_) * parameters_.time_step; }
    std::size_t steps() const { return steps_; }

    /// Component 0 is along x, 1 along y.
    std::span<const Real> displacement(std::size_t component) const { return u_[component]; }
    std::span<const Real> velocity(std::size_t component) const { return v_[component]; }
    std::span<Real> displacement(std::size_t component) { return u_[component]; }
    std::span<Real> velocity(std::size_t component) { return v_[component]; }

    /// Energy [per thickness] that has left through each passive side or sponge since the start; in
    /// the order of plane_sides. What moving ghosts take is not counted.
    std::array<double, 4> left() const {
        std::array<double, 4> energy{};
        const double unit = parameters_.density * parameters_.spacing * parameters_.spacing *
                            parameters_.rate() * parameters_.time_step;
        std::ranges::transform(gone_, energy.begin(), [=](double sum) { return unit * sum; });
        return energy;
    }

    /// Energy [per thickness] that the forces on velocities of a damped lattice have taken.
    double damped() const {
        return parameters_.density * parameters_.spacing * parameters_.spacing * damped_;
    }

    /// Takes the fields for u and v at t = 0 and moves v to -dt/2 by the accelerations there.
    void start();
    /// Takes the fields for u at t = 0 and v at -dt/2, as another plane may have left them.
    void start_staggered();

    PlaneState<Real> state() const;
    /// Goes on from the state of a plane of the same model, sides, parameters and, of bonds, that
    /// break alike, bit for bit.
    /// Throws std::invalid_argument where the state is of another size.
    void resume(const PlaneState<Real>& state);

    /// Steps, each of them: v to t + dt/2, then u to t + dt. Before the sides' dashpots, which act
    /// on what it leaves, `prescribe` may change velocities: it is called with this plane and t +
    /// dt, u at t and v at t + dt/2. After the step, `observe` sees this plane.
    /// Throws NotCertified where the step is longer than the undamped interior allows; damping and
    /// sides may allow less (longest_step() of plane_stability.hpp).
    template <class Prescribe, class Observe>
    void advance(std::size_t steps, Prescribe&& prescribe, Observe&& observe) {
        for (std::size_t step = 0; step < steps; ++step) {
            advance(1, prescribe);
            observe(std::as_const(*this));
        }
    }
    /// Many steps at once are faster than one by one, and the same bit for bit.
    template <class Prescribe>
    void advance(std::size_t steps, Prescribe&& prescribe) {
        require_stable_interior();
        detail::advance(*this, steps, prescribe);
    }
    void advance(std::size_t steps) {
        const auto nothing = [](auto&&...) {};
        advance(steps, nothing);
    }

    // Of bond-based planes; others throw std::logic_error. Points and nodes are interior ones [dX]:
    // (0, 0) to (nx - 1, ny - 1).

    /// Lets bonds break, for good, where R.(u_J - u_I) is above stretch |R|^2. keep(x, y) says
    /// whether the bonds of a node never do; nodes of layers, and those beyond a halo, are outside
    /// of the interior. Throws std::invalid_argument of a stretch that is not above 0, and of
    /// weights below 0: where other bonds break, the energy of such a lattice has no lower bound;
    /// and beside odd mirrors.
    template <class Keep>
    void break_above(double stretch, const Keep& keep);
    /// Whatever the weights are.
    template <class Keep>
    void break_above(double stretch, const Keep& keep, AllowUnstable tag);
    /// Breaks, before start(), the bonds that the line from one point to the other meets: those of
    /// a node on it, too, but for bonds along the line. They count neither as broken nor as
    /// released. Throws std::invalid_argument unless the points are finite and differ.
    void cut(const PlanePoint& from, const PlanePoint& to);
    /// The part of a node's bonds that no longer hold. Throws std::invalid_argument of a node
    /// outside.
    double damage(std::size_t x, std::size_t y) const;
    /// Bonds that have broken since the start, each counted once.
    double broken() const {
        bonds_of(force_);
        return broken_;
    }
    /// What the staggered energy [per thickness] of the body has lost by them. Where a bond is
    /// pulled from short to too long within one step it can be below 0.
    double released() const {
        bonds_of(force_);
        return parameters_.youngs_modulus * released_;
    }

    /// Of the whole body, and of the ghosts of fixed sides, which are strained, too; with halo
    /// sides, of this block, whose halos need velocities then.
    PlaneEnergies energies() const;
    /// Of the nodes with first_x <= x < last_x, likewise y, which are counted from the interior's
    /// first one: those of layers are below 0 and beyond its last one. Half of each of their bonds,
    /// and all of one to a held ghost. Throws std::invalid_argument where there are none, or
    /// others.
    PlaneEnergies energies(std::ptrdiff_t first_x, std::ptrdiff_t last_x, std::ptrdiff_t first_y,
                           std::ptrdiff_t last_y) const;
    /// Of each of these nodes, row by row, what it has of energies().total() [per thickness].
    std::vector<double> energies_of_nodes(std::ptrdiff_t first_x, std::ptrdiff_t last_x,
                                          std::ptrdiff_t first_y, std::ptrdiff_t last_y) const;
    /// The part of a cell dX^2 that is a node's, counted likewise: beside closed sides not all of
    /// it.
    double volume(std::ptrdiff_t x, std::ptrdiff_t y) const;
    PlaneEnergies interior_energies() const;

  private:
    template <class Body, class... Hooks>
    friend void detail::advance(Body& body, std::size_t steps, Hooks&... hooks);

    using Fields = std::array<std::vector<Real>, 2>;
    struct Window {
        detail::PlaneAxis::Range x;
        detail::PlaneAxis::Range y;
    };

    /// Of nodes counted from the interior's first one, those counted from the body's.
    Window window_of(const detail::PlaneAxis::Range& x, const detail::PlaneAxis::Range& y) const;

    /// Its forces on velocities, where there are any.
    std::optional<detail::PlaneForce<Real>> damping_of(
        const std::variant<CorrespondenceModel, BondModel>& law) const;

    using Force = std::variant<detail::PlaneForce<Real>, detail::BondForce<Real>>;
    Force force_of(const std::variant<CorrespondenceModel, BondModel>& law) const;

    /// A passive side's own layers, and those that they act on; those of a sponge.
    std::size_t layers_of(const PlaneSide& side) const;

    /// What is copied to another block, or beyond a mirror; of bonds, to the other side: both ends
    /// of one are different nodes then.
    std::size_t least_nodes(std::size_t axis) const;

    const detail::PlaneAxis& axis_of(std::size_t number) const {
        return std::visit(
            [=](const auto& force) -> const detail::PlaneAxis& { return force.axis(number); },
            force_);
    }
    double mass_of(std::size_t component, std::ptrdiff_t x, std::ptrdiff_t y) const {
        const auto* const force = std::get_if<detail::PlaneForce<Real>>(&force_);
        return force != nullptr ? force->mass(component, x, y)
                                : axis_of(0).mass(component, x) * axis_of(1).mass(component, y);
    }
    /// From units E = density = dX = 1: of a change of velocity in so much time.
    double kick_scale(double duration) const {
        return duration * parameters_.rate() * parameters_.rate();
    }
    void kick_by_forces(double duration, Fields& v) {
        std::visit(
            [&](auto& force) {
                force.kick(kick_scale(duration), field(std::as_const(u_)), field(v));
            },
            force_);
    }

    /// Node (0, 0) of the interior, among those of the body.
    std::array<std::ptrdiff_t, 2> first_of_interior() const {
        return {static_cast<std::ptrdiff_t>(layers_[0]), static_cast<std::ptrdiff_t>(layers_[2])};
    }
    std::ptrdiff_t origin() const {
        return static_cast<std::ptrdiff_t>(ghosts_ * grid().nx + ghosts_);
    }
    detail::PlaneField<Real> field(Fields& fields) const {
        return {fields[0].data() + origin(), fields[1].data() + origin()};
    }
    detail::PlaneField<const Real> field(const Fields& fields) const {
        return {fields[0].data() + origin(), fields[1].data() + origin()};
    }

    /// Not of the constructor: start() alone, in any step, finds accelerations.
    void require_stable_interior();

    // What leapfrog asks of a body.
    void kick();
    template <class Prescribe>
    void close_sides(Prescribe& prescribe);
    void drift();
    void drift_and_kick();
    void keep_velocities();
    detail::PlaneDrift<Real> drift_of_rows() const {
        return {static_cast<Real>(parameters_.time_step),
                {-static_cast<std::ptrdiff_t>(moving_ghosts_[0]),
                 static_cast<std::ptrdiff_t>(nx_ + moving_ghosts_[1])}};
    }

    /// The forces, const or not, as those of bonds.
    template <class AnyForce>
    static auto& bonds_of(AnyForce& force) {
        auto* const bonds = std::get_if<detail::BondForce<Real>>(&force);
        if (bonds == nullptr) {
            throw std::logic_error("only a bond-based plane has bonds that break");
        }
        return *bonds;
    }
    void count_broken();

    void find_damping(double duration);
    void add_damping(Fields& v) const;
    void count_damped();

    void clear_ghosts();
    void close_ghosts(Fields& fields) const;
    /// The node of a side's layer, along its axis.
    std::ptrdiff_t node_of_layer(std::size_t number, std::ptrdiff_t layer) const {
        const Side side = plane_sides[number];
        const std::size_t nodes = side.axis == 0 ? nx_ : ny_;
        return side.end == End::left ? layer : static_cast<std::ptrdiff_t>(nodes) - 1 - layer;
    }
    double friction_of(std::size_t number, std::ptrdiff_t layer) const;
    double volume_of_line(std::size_t number, std::ptrdiff_t line) const;

    void add_dashpots();
    void add_line_dashpots(std::size_t number);
    void add_corner_dashpots(std::size_t across_x, std::size_t across_y);
    void add_ghost_lines();
    void add_friction();

    /// At t - dt/2, ghosts too.
    struct HalfStep {
        Fields mean;  ///< of two displacements
        Fields velocity;
    };
    HalfStep at_half_step() const;
    double kinetic_energy(std::ptrdiff_t x, std::ptrdiff_t y, const Fields& velocity) const;
    /// Over E.
    detail::PlanePotential potential_of_row(std::ptrdiff_t y, const detail::PlaneAxis::Range& nodes,
                                            const Fields& u) const;
    PlaneEnergies energies_of(const Window& window) const;
    std::vector<double> energies_of_nodes(const Window& window) const;

    PlaneModel model_;
    PlaneSides sides_;
    PlaneParameters parameters_;
    std::size_t ghosts_;
    std::array<std::size_t, 4> layers_;
    std::size_t nx_;  // of the body, layers included
    std::size_t ny_;
    Force force_;
    std::optional<detail::PlaneForce<Real>> damping_;
    Fields damping_change_;  // what the damping changes v by in this step
    std::vector<detail::DashpotGroups<Real>> dashpots_;
    std::vector<detail::GhostLines<Real>> ghost_lines_;  // in the order in which they close
    detail::PlaneFriction<Real> friction_;
    std::array<std::size_t, 4> moving_ghosts_{};  // beyond each side
    Fields u_;
    Fields v_;
    std::array<double, 4> gone_{};  // sums of vbar.C vbar
    double broken_ = 0;
    double released_ = 0;      // over E
    double damped_ = 0;        // over density dX^2
    double longest_step_ = 0;  // of the interior; 0: not found yet
    std::size_t steps_ = 0;
};

using Plane = BasicPlane<double>;

}  // namespace nmbc

#include <nmbc/plane_assembly.hpp>
#include <nmbc/plane_damping.hpp>
#include <nmbc/plane_energies.hpp>
#include <nmbc/plane_fracture.hpp>
#include <nmbc/plane_state.hpp>
#include <nmbc/plane_step.hpp>
