// SPDX-License-Identifier: MIT
/// The place where an end plugs into a chain: one class for each kind of end, all in one loop.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <nmbc/coefficients.hpp>
#include <nmbc/edge_energy.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/node_line.hpp>
#include <span>
#include <type_traits>
#include <utility>

namespace nmbc {

/// Physical set-up, in any one consistent system of units.
struct ChainParameters {
    std::size_t nodes = 0;      ///< interior nodes
    double spacing = 1;         ///< dX [length]
    double youngs_modulus = 1;  ///< E [stress]
    double density = 1;         ///< rho [mass/volume]
    double time_step = 0;       ///< dt [time]

    double wave_speed() const { return std::sqrt(youngs_modulus / density); }
};

/// What a chain has at one of its ends. Entries of u and v are counted inwards from the outermost
/// ghost node: first the ghosts, as many as the lattice reaches, then the layer, then the
/// interior.
template <class Real>
class BoundaryCondition {
  public:
    BoundaryCondition() = default;
    BoundaryCondition(const BoundaryCondition&) = delete;
    BoundaryCondition& operator=(const BoundaryCondition&) = delete;
    BoundaryCondition(BoundaryCondition&&) = delete;
    BoundaryCondition& operator=(BoundaryCondition&&) = delete;
    virtual ~BoundaryCondition() = default;

    /// Nodes this end puts between its ghosts and the interior. They move as the lattice does.
    virtual std::size_t layer_nodes() const { return 0; }

    /// Interior nodes the chain needs for it; it reads and writes no others.
    virtual std::size_t least_interior_nodes() const { return 1; }

    /// What the other end has to be too, where this one is certified opposite its like only.
    virtual const BoundaryCoefficients* only_opposite() const { return nullptr; }

    /// t = 0: called with v at 0, as the user gave it, and again with v at -dt/2. And wherever the
    /// user has written to the fields between two steps, with u at step * dt and v half a step
    /// before. Ghost entries may be overwritten.
    virtual void start(NodeLine<Real> /*u*/, NodeLine<Real> /*v*/, std::size_t /*step*/) {}

    /// Between the two: the lattice's own forces have brought v from 0 to `duration` = -dt/2. An
    /// end with forces of its own puts the v of its layer right.
    virtual void after_start(NodeLine<const Real> /*u*/, NodeLine<Real> /*v*/,
                             double /*duration*/) {}

    /// Of an end beyond which there is no energy: what its outermost nodes have of their own.
    virtual const EdgeEnergy* own_energy() const { return nullptr; }

    /// Of a damped lattice, in every step before forces act: `change`, what the lattice's own
    /// damping changes v by in so long [time], becomes what the end's does at such nodes. v is half
    /// a step old.
    virtual void complete_damping(NodeLine<const Real> /*v*/, NodeLine<Real> /*change*/,
                                  double /*duration*/) const {}

    /// In every step, when the lattice's own forces have acted and nothing else has: the forces of
    /// such nodes.
    virtual void complete_kick(NodeLine<const Real> /*u*/, NodeLine<Real> /*v*/) {}

    /// In every step, when u is at t, t = step * dt, and the lattice's own forces have brought the
    /// layer's and the interior's v to t + dt/2. Writes the ghosts' v, and may change the v of
    /// nodes near the end. After that every u moves on by dt v, ghosts included.
    virtual void after_kick(NodeLine<const Real> u, NodeLine<Real> v, std::size_t step) = 0;

    /// What it remembers from step to step, and to make it remember that again: always as many
    /// numbers. A run that is stored with them goes on bit for bit.
    virtual std::span<const Real> memory() const { return {}; }
    virtual void remember(std::span<const Real> /*memory*/) {}
};

/// Which end a chain is to have: anything with
///     std::unique_ptr<BoundaryCondition<Real>> make(const Lattice&, const ChainParameters&,
///                                              std::type_identity<Real>) const
/// of the chain's Real, such as MatchingEnd, FixedEnd and FreeEnd of ends.hpp.
template <class Real>
class BasicChainEnd {
  public:
    template <class Description>
    requires(!std::same_as<Description, BasicChainEnd>) &&
        requires(const Description& end, const Lattice& lattice, const ChainParameters& p) {
        end.make(lattice, p, std::type_identity<Real>{});
    }
    BasicChainEnd(Description description)  // NOLINT(google-explicit-constructor): any will do
        : make_([description = std::move(description)](const Lattice& lattice,
                                                       const ChainParameters& parameters) {
              return description.make(lattice, parameters, std::type_identity<Real>{});
          }) {}

    std::unique_ptr<BoundaryCondition<Real>> make(const Lattice& lattice,
                                                  const ChainParameters& parameters) const {
        return make_(lattice, parameters);
    }

  private:
    std::function<std::unique_ptr<BoundaryCondition<Real>>(const Lattice&, const ChainParameters&)>
        make_;
};

using ChainEnd = BasicChainEnd<double>;

}  // namespace nmbc
