// SPDX-License-Identifier: MIT
/// Ghosts of a plane lattice that move by a condition of their own, and friction in layers.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <nmbc/boundary.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/higdon.hpp>
#include <nmbc/plane_force.hpp>
#include <nmbc/plane_sides.hpp>
#include <span>
#include <variant>
#include <vector>

namespace nmbc::detail {

/// The condition of one component on a line across a side; nothing where the ghosts do not move.
template <class Real>
std::unique_ptr<BoundaryCondition<Real>> line_condition(const PlaneSide& side, std::size_t ghosts,
                                                        bool is_normal,
                                                        const ChainParameters& chain) {
    const double rate = chain.wave_speed() / chain.spacing;
    if (const auto* const matching = std::get_if<MatchingSide>(&side)) {
        const std::size_t part = is_normal ? 0 : 1;
        ChainParameters of_part = chain;
        of_part.youngs_modulus *= matching->speeds[part] * matching->speeds[part];
        return std::make_unique<MatchingCondition<Real>>(matching->coefficients[part], ghosts,
                                                         of_part, GhostRule::midpoint);
    }
    if (const auto* const higdon = std::get_if<HigdonSide>(&side)) {
        std::vector<double> courants;
        for (const double speed : higdon->speeds) {
            courants.push_back(speed * chain.time_step * rate);
        }
        return std::make_unique<HigdonCondition<Real>>(
            ghosts, courants, higdon->decay * chain.time_step * rate / 2, chain.time_step);
    }
    return nullptr;
}

/// The conditions of all lines across one side.
template <class Real>
class GhostLines {
  public:
    /// Lines first .. last-1, counted along the other axis of the grid.
    GhostLines(const PlaneSide& kind, Side side, const Grid& grid, std::size_t ghosts,
               std::size_t first, std::size_t last, const ChainParameters& chain)
        : side_(side), grid_(grid), first_(first) {
        for (std::size_t line = first; line < last; ++line) {
            for (std::size_t a = 0; a < 2; ++a) {
                conditions_.push_back(line_condition<Real>(kind, ghosts, a == side.axis, chain));
            }
        }
    }

    std::size_t least_interior_nodes() const {
        return conditions_.empty() ? 1 : conditions_.front()->least_interior_nodes();
    }

    using Fields = std::array<std::vector<Real>, 2>;

    void start(Fields& u, Fields& v) {
        for_each([&](BoundaryCondition<Real>& condition, std::size_t a, std::size_t line) {
            condition.start({u[a], grid_, side_, line}, {v[a], grid_, side_, line}, 0);
        });
    }

    void close(const Fields& u, Fields& v, std::size_t step) {
        for_each([&](BoundaryCondition<Real>& condition, std::size_t a, std::size_t line) {
            condition.after_kick({std::span(u[a]), grid_, side_, line},
                                 {std::span(v[a]), grid_, side_, line}, step);
        });
    }

    std::size_t remembered_size() const {
        std::size_t size = 0;
        for (const auto& condition : conditions_) {
            size += condition->memory().size();
        }
        return size;
    }
    /// Adds what the conditions remember, and takes it out again.
    void remembered(std::vector<Real>& memory) const {
        for (const auto& condition : conditions_) {
            const std::span<const Real> own = condition->memory();
            memory.insert(memory.end(), own.begin(), own.end());
        }
    }
    void remember(std::span<const Real>& memory) {
        for (const auto& condition : conditions_) {
            const std::size_t size = condition->memory().size();
            condition->remember(memory.first(size));
            memory = memory.subspan(size);
        }
    }

  private:
    template <class Work>
    void for_each(const Work& work) {
        for (std::size_t i = 0; i < conditions_.size(); ++i) {
            work(*conditions_[i], i % 2, first_ + i / 2);
        }
    }

    Side side_;
    Grid grid_;
    std::size_t first_;
    std::vector<std::unique_ptr<BoundaryCondition<Real>>> conditions_;
};

/// Friction on nodes of layers, at the mean of the velocities before and after: where two layers
/// cross, that of both.
template <class Real>
class PlaneFriction {
  public:
    /// gamma dt of a node by the side across x and by that across y, whose places among plane_sides
    /// are given; mass: of it.
    void add(std::ptrdiff_t entry, std::array<double, 2> gammas, std::array<std::size_t, 2> sides,
             double mass) {
        nodes_.push_back({entry, gammas, sides, mass, {}});
    }

    void keep(PlaneField<const Real> v) {
        for (Node& node : nodes_) {
            node.before = {v[0][node.entry], v[1][node.entry]};
        }
    }

    /// v += steps times what the friction alone does to it in one.
    void drag(double steps, PlaneField<Real> v) const {
        for (const Node& node : nodes_) {
            const auto factor = static_cast<Real>(1 - steps * (node.gammas[0] + node.gammas[1]));
            v[0][node.entry] *= factor;
            v[1][node.entry] *= factor;
        }
    }

    /// Adds to `gone` what each side has taken out, times 1/dt.
    void close(PlaneField<Real> v, double time_step, std::array<double, 4>& gone) const {
        for (const Node& node : nodes_) {
            const double half = (node.gammas[0] + node.gammas[1]) / 2;
            for (std::size_t a = 0; a < 2; ++a) {
                Real& own = v[a][node.entry];
                const auto before = static_cast<double>(node.before[a]);
                own = static_cast<Real>((static_cast<double>(own) - half * before) / (1 + half));
                const double mean = (before + static_cast<double>(own)) / 2;
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    gone[node.sides[axis]] +=
                        node.mass * node.gammas[axis] / time_step * mean * mean;
                }
            }
        }
    }

  private:
    struct Node {
        std::ptrdiff_t entry;
        std::array<double, 2> gammas;
        std::array<std::size_t, 2> sides;
        double mass;
        std::array<Real, 2> before;
    };
    std::vector<Node> nodes_;
};

}  // namespace nmbc::detail
