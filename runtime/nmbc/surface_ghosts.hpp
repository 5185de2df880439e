// SPDX-License-Identifier: MIT
/// Ghosts beyond a true surface, which stand in for the neighbours that the families beside it
/// lack: mirror images, and those of the surface node method (SNM 2023).
#pragma once

#include <cstddef>
#include <functional>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/edge_energy.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/node_line.hpp>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// u of the ghosts, nearest first, as they follow from the nodes, nearest first, and from the value
/// given: rows . u + given [length] value.
struct GhostRows {
    std::size_t count = 0;
    std::size_t columns = 0;     ///< nodes that they follow
    std::vector<double> rows{};  ///< count times columns, row by row
    std::vector<double> given{};
    bool holds_node = false;  ///< the outermost one has the value given
};

/// A traction is in units of E/dX: the elongation that it makes of a node's length.
/// through_node: through the outermost one, and not midway between it and the ghost beyond.
inline GhostRows mirror_rows(const Lattice& lattice, OnSurface given, bool through_node) {
    const std::size_t count = lattice.reach();
    const std::size_t columns = count + (through_node ? 1 : 0);
    double modulus = 0;
    for (std::size_t k = 1; k <= count; ++k) {
        modulus -= static_cast<double>(k * k) * lattice.symbol[k];
    }
    const bool is_traction = given == OnSurface::traction;
    GhostRows ghosts{count, columns, std::vector<double>(count * columns),
                     std::vector<double>(count), through_node && !is_traction};
    for (std::size_t f = 1; f <= count; ++f) {
        ghosts.rows[(f - 1) * columns + columns - count + f - 1] = is_traction ? 1 : -1;
        const auto distance = static_cast<double>(2 * f - (through_node ? 0 : 1));
        ghosts.given[f - 1] = is_traction ? distance / modulus : 2;
    }
    return ghosts;
}

/// (4), and (5) for u_s. The bonds of length k have the force -symbol[k] (u_{i+k} - u_i).
inline GhostRows surface_node_rows(const Lattice& lattice, OnSurface given) {
    const std::size_t count = lattice.reach();
    std::vector<double> surface(count);  // u_s = sum_i surface_i u_i + load value
    double load = 1;
    if (given == OnSurface::traction) {
        double own = 0;
        for (std::size_t k = 1; k <= count; ++k) {
            for (std::size_t f = 1; f <= k; ++f) {
                own -= lattice.symbol[k] * static_cast<double>(2 * f);
                surface[0] -= lattice.symbol[k] * static_cast<double>(2 * f - 1);
                surface[k - f] -= lattice.symbol[k];
            }
        }
        if (!(own > 0)) {
            throw std::invalid_argument("a surface node needs bonds that bear a traction");
        }
        for (double& entry : surface) {
            entry /= own;
        }
        load = 1 / own;
    }
    GhostRows ghosts{count, count, std::vector<double>(count * count), std::vector<double>(count)};
    for (std::size_t f = 1; f <= count; ++f) {
        for (std::size_t i = 0; i < count; ++i) {
            ghosts.rows[(f - 1) * count + i] = static_cast<double>(2 * f) * surface[i];
        }
        ghosts.rows[(f - 1) * count] -= static_cast<double>(2 * f - 1);
        ghosts.given[f - 1] = static_cast<double>(2 * f) * load;
    }
    return ghosts;
}

template <class Real>
class SurfaceCondition final : public BoundaryCondition<Real> {
  public:
    /// unit [length]: of a value of 1. energy: as BoundaryCondition::own_energy() has it.
    SurfaceCondition(const GhostRows& ghosts, double unit, double time_step,
                     std::function<double(double)> value, std::optional<EdgeEnergy> energy = {})
        : ghosts_(ghosts.count),
          columns_(ghosts.columns),
          holds_node_(ghosts.holds_node),
          rows_(ghosts.rows.begin(), ghosts.rows.end()),
          given_(ghosts.given),
          time_step_(time_step),
          value_(std::move(value)),
          energy_(std::move(energy)) {
        for (double& factor : given_) {
            factor *= unit;
        }
    }

    std::size_t least_interior_nodes() const override { return columns_; }

    const EdgeEnergy* own_energy() const override { return energy_ ? &*energy_ : nullptr; }

    void start(NodeLine<Real> u, NodeLine<Real> v, std::size_t step) override {
        const double time = static_cast<double>(step) * time_step_;
        const double now = at(time);
        const double rate = (now - at(time - time_step_)) / time_step_;
        if (holds_node_) {
            u[ghosts_] = static_cast<Real>(now);
            v[ghosts_] = static_cast<Real>(rate);
        }
        for (std::size_t f = 0; f < ghosts_; ++f) {
            u[ghosts_ - 1 - f] = row(f, u) + static_cast<Real>(given_[f] * now);
            v[ghosts_ - 1 - f] = row(f, v) + static_cast<Real>(given_[f] * rate);
        }
    }

    /// The velocity that brings each ghost to its place, so that no rounding adds up.
    void after_kick(NodeLine<const Real> u, NodeLine<Real> v, std::size_t step) override {
        const double next = at(static_cast<double>(step + 1) * time_step_);
        const auto dt = static_cast<Real>(time_step_);
        if (holds_node_) {
            v[ghosts_] = (static_cast<Real>(next) - u[ghosts_]) / dt;
        }
        const NodeLine<const Real> velocity = v;
        for (std::size_t f = 0; f < ghosts_; ++f) {
            const std::size_t ghost = ghosts_ - 1 - f;
            const Real off = row(f, u) + static_cast<Real>(given_[f] * next) - u[ghost];
            v[ghost] = row(f, velocity) + off / dt;
        }
    }

  private:
    double at(double time) const { return value_ ? value_(time) : 0; }

    Real row(std::size_t f, NodeLine<const Real> field) const {
        Real sum = 0;
        for (std::size_t i = 0; i < columns_; ++i) {
            sum += rows_[f * columns_ + i] * field[ghosts_ + i];
        }
        return sum;
    }

    std::size_t ghosts_;
    std::size_t columns_;
    bool holds_node_;
    std::vector<Real> rows_;
    std::vector<double> given_;
    double time_step_;
    std::function<double(double)> value_;
    std::optional<EdgeEnergy> energy_;
};

}  // namespace nmbc::detail
