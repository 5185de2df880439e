// SPDX-License-Identifier: MIT
/// The ends of the runtime: a matching boundary, two that keep the energy, and one that does
/// nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <nmbc/boundary.hpp>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/edge_energy.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace nmbc {

namespace detail {

template <class Real>
class MatchingCondition final : public BoundaryCondition<Real> {
  public:
    MatchingCondition(const BoundaryCoefficients& coefficients, std::size_t ghosts,
                      const ChainParameters& p, GhostRule rule)
        : boundary_(coefficients,
                    {.ghost_layers = ghosts,
                     .wave_speed = p.wave_speed(),
                     .spacing = p.spacing,
                     .time_step = p.time_step},
                    rule),
          coefficients_(coefficients) {}

    std::size_t least_interior_nodes() const override {
        return std::max<std::size_t>(boundary_.reach() - boundary_.ghost_layers(), 1);
    }

    const BoundaryCoefficients* only_opposite() const override {
        const auto& certificate = coefficients_.certificate;
        return certificate && certificate->opposite == Opposite::like ? &coefficients_ : nullptr;
    }

    void after_kick(NodeLine<const Real> u, NodeLine<Real> v, std::size_t /*step*/) override {
        boundary_.update(u, v);
    }

  private:
    BasicMatchingBoundary<Real> boundary_;
    BoundaryCoefficients coefficients_;
};

template <class Real>
class FixedCondition final : public BoundaryCondition<Real> {
  public:
    FixedCondition(std::size_t ghosts, std::size_t layer) : ghosts_(ghosts), layer_(layer) {}

    std::size_t layer_nodes() const override { return layer_; }

    void start(NodeLine<Real> u, NodeLine<Real> v, std::size_t /*step*/) override {
        hold(u);
        hold(v);
    }
    void after_kick(NodeLine<const Real> /*u*/, NodeLine<Real> v, std::size_t /*step*/) override {
        hold(v);
    }

  private:
    void hold(NodeLine<Real> field) const {
        for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
            field[ghost] = 0;
        }
    }

    std::size_t ghosts_;
    std::size_t layer_;
};

template <class Real>
class FreeCondition final : public BoundaryCondition<Real> {
  public:
    explicit FreeCondition(const Lattice& lattice) : ghosts_(lattice.reach()) {}

    std::size_t least_interior_nodes() const override { return ghosts_; }

    void start(NodeLine<Real> u, NodeLine<Real> v, std::size_t /*step*/) override {
        mirror(u);
        mirror(v);
    }
    void after_kick(NodeLine<const Real> /*u*/, NodeLine<Real> v, std::size_t /*step*/) override {
        mirror(v);
    }
    const EdgeEnergy* own_energy() const override { return &energy_; }

  private:
    void mirror(NodeLine<Real> field) const {
        for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
            field[ghost] = field[2 * ghosts_ - 1 - ghost];
        }
    }

    std::size_t ghosts_;
    EdgeEnergy energy_{};  // that of a mirror between nodes: no node has one of its own
};

template <class Real>
class IdleCondition final : public BoundaryCondition<Real> {
  public:
    void after_kick(NodeLine<const Real> /*u*/, NodeLine<Real> /*v*/,
                    std::size_t /*step*/) override {}
};

}  // namespace detail

/// (60) on every ghost layer.
struct MatchingEnd {
    BoundaryCoefficients coefficients;
    GhostRule ghost_rule = GhostRule::midpoint;

    /// What is certified is certified for its own lattice and for long chains. Throws NotCertified
    /// otherwise, and as MatchingBoundary does.
    template <class Real>
    std::unique_ptr<BoundaryCondition<Real>> make(const Lattice& lattice, const ChainParameters& p,
                                                  std::type_identity<Real> /*precision*/) const {
        if (const auto& certificate = coefficients.certificate) {
            if (lattice.table == nullptr || lattice.G != certificate->G ||
                !is_same_lattice(*lattice.table, *certificate->lattice)) {
                throw NotCertified(
                    std::string("the boundary is certified for another lattice: horizon, G or tau "
                                "are not those of the chain") +
                    detail::how_to_run_it);
            }
            if (p.nodes < certificate->least_nodes) {
                throw NotCertified("a chain with this matching boundary is certified from " +
                                   std::to_string(certificate->least_nodes) +
                                   " interior nodes on, and has " + std::to_string(p.nodes) +
                                   detail::how_to_run_it);
            }
        }
        return std::make_unique<detail::MatchingCondition<Real>>(coefficients, lattice.reach(), p,
                                                                 ghost_rule);
    }
};

/// Every ghost node is held at u = 0, beyond a layer of nodes that the interior is extended by:
/// with a layer so wide that nothing returns in time, the 'ideal' of Nicely 2018.
struct FixedEnd {
    std::size_t layer = 0;

    template <class Real>
    std::unique_ptr<BoundaryCondition<Real>> make(const Lattice& lattice,
                                                  const ChainParameters& /*p*/,
                                                  std::type_identity<Real> /*precision*/) const {
        return std::make_unique<detail::FixedCondition<Real>>(lattice.reach(), layer);
    }
};

/// The mirror image: j = 0 the outermost interior node, counted inwards, ghost node -1-j moves as
/// node j does. The mirror is midway between the outermost interior node and the innermost ghost.
struct FreeEnd {
    template <class Real>
    std::unique_ptr<BoundaryCondition<Real>> make(const Lattice& lattice,
                                                  const ChainParameters& /*p*/,
                                                  std::type_identity<Real> /*precision*/) const {
        return std::make_unique<detail::FreeCondition<Real>>(lattice);
    }
};

/// The ghosts go on as they are, with whatever velocity they have: the least that an end can cost,
/// for others to be measured against.
struct IdleEnd {
    template <class Real>
    std::unique_ptr<BoundaryCondition<Real>> make(const Lattice& /*lattice*/,
                                                  const ChainParameters& /*p*/,
                                                  std::type_identity<Real> /*precision*/) const {
        return std::make_unique<detail::IdleCondition<Real>>();
    }
};

}  // namespace nmbc
