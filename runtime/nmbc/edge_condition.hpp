// SPDX-License-Identifier: MIT
/// A chain that ends on its outermost interior node, with the energy of that edge.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/edge_damping.hpp>
#include <nmbc/edge_energy.hpp>
#include <nmbc/lattice.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// Half the width of the widest square of a lattice.
inline std::size_t half_width(const Lattice& lattice) {
    std::size_t half = 0;
    for (const Lattice::Square& square : lattice.energy) {
        half = std::max(half, square.stencil.size() / 2);
    }
    return half;
}

/// K of the nodes next to a left edge, whose forces -K u differ from the lattice's, row by row. Of
/// squares that are damped it is the matrix of the damping.
struct EdgeStiffness {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<double> entries{};

    double at(std::size_t row, std::size_t column) const { return entries[row * columns + column]; }
};

inline EdgeStiffness stiffness_of(const EdgeEnergy& edge, const Lattice& lattice) {
    const std::size_t half = half_width(lattice);
    const std::size_t rows = edge.mass.size() + half;
    EdgeStiffness K{rows, rows + std::max(2 * half, lattice.reach()), {}};
    K.entries.resize(K.rows * K.columns);
    const auto add = [&](double weight, const std::vector<double>& stencil, std::size_t first) {
        for (std::size_t i = 0; i < stencil.size() && first + i < K.rows; ++i) {
            for (std::size_t j = 0; j < stencil.size(); ++j) {
                if (stencil[i] != 0 && stencil[j] != 0) {
                    K.entries[(first + i) * K.columns + first + j] +=
                        weight * stencil[i] * stencil[j];
                }
            }
        }
    };
    for (const EdgeEnergy::Square& square : edge.squares) {
        add(square.weight, square.stencil, 0);
    }
    for (const auto& [part, weight, stencil] : lattice.energy) {
        const std::size_t own = stencil.size() / 2;
        for (std::size_t node = edge.mass.size(); node < K.rows + own; ++node) {
            add(weight, stencil, node - own);
        }
    }
    return K;
}

/// What brings the accelerations of the nodes next to an edge from the lattice's to the edge's.
class EdgeChange {
  public:
    /// symbol: of the lattice that K is the edge of; factor: unit of the accelerations.
    EdgeChange(const EdgeStiffness& K, const std::vector<double>& mass,
               const std::vector<double>& symbol, double factor)
        : ghosts_(symbol.size() - 1),
          rows_(K.rows),
          columns_(K.columns),
          entries_(rows_ * columns_) {
        for (std::size_t row = 0; row < rows_; ++row) {
            double* const change = &entries_[row * columns_];
            for (std::size_t column = 0; column < columns_; ++column) {
                change[column] = -K.at(row, column) / (row < mass.size() ? mass[row] : 1);
            }
            change[row] += symbol[0];
            for (std::size_t m = 1; m <= ghosts_; ++m) {
                change[row + m] += symbol[m];
                change[row < m ? 0 : row - m] += symbol[m];  // ghosts are where node 0 is
            }
            for (std::size_t column = 0; column < columns_; ++column) {
                change[column] *= factor;
            }
        }
    }

    std::size_t columns() const { return columns_; }

    /// Adds so long of it, at this field, to `to`.
    template <class Real>
    void add(NodeLine<const Real> field, NodeLine<Real> to, double duration) const {
        const double* entry = entries_.data();
        for (std::size_t row = 0; row < rows_; ++row) {
            const auto own = static_cast<double>(field[ghosts_ + row]);
            double sum = 0;
            for (std::size_t column = 0; column < columns_; ++column) {
                sum += *entry++ * (static_cast<double>(field[ghosts_ + column]) - own);
            }
            to[ghosts_ + row] += static_cast<Real>(duration * sum);
        }
    }

  private:
    std::size_t ghosts_;
    std::size_t rows_;
    std::size_t columns_;
    std::vector<double> entries_;  // row by row; rows add up to 0
};

/// The outermost node lies on the surface. Beyond it there is nothing: the ghosts go with it, so
/// that in a body that has moved far the lattice's own forces, which are taken back, are small.
template <class Real>
class EdgeCondition final : public BoundaryCondition<Real> {
  public:
    /// damping: of a damped lattice.
    EdgeCondition(EdgeEnergy edge, const Lattice& lattice,
                  const std::optional<EdgeDamping>& damping, const ChainParameters& p,
                  OnSurface given, std::function<double(double)> value)
        : edge_(std::move(edge)),
          ghosts_(lattice.reach()),
          change_(stiffness_of(edge_, lattice), edge_.mass, lattice.symbol,
                  std::pow(p.wave_speed() / p.spacing, 2)),
          time_step_(p.time_step),
          given_(given),
          load_(1 / (p.density * p.spacing * edge_.mass.at(0))),
          value_(std::move(value)) {
        if (damping) {
            damping_change_.emplace(stiffness_of(damping->edge, damping->lattice), edge_.mass,
                                    damping->lattice.symbol, p.wave_speed() / p.spacing);
        }
    }

    std::size_t least_interior_nodes() const override { return change_.columns(); }

    const EdgeEnergy* own_energy() const override { return &edge_; }

    void start(NodeLine<Real> u, NodeLine<Real> v, std::size_t step) override {
        if (given_ == OnSurface::displacement) {
            const double time = static_cast<double>(step) * time_step_;
            u[ghosts_] = static_cast<Real>(at(time));
            v[ghosts_] = static_cast<Real>((at(time) - at(time - time_step_)) / time_step_);
        }
        for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
            u[ghost] = u[ghosts_];
            v[ghost] = v[ghosts_];
        }
    }

    void after_start(NodeLine<const Real> u, NodeLine<Real> v, double duration) override {
        change_.add(u, v, duration);
        if (given_ == OnSurface::traction) {
            v[ghosts_] += static_cast<Real>(duration * load_ * at(0));
        }
    }

    void complete_damping(NodeLine<const Real> v, NodeLine<Real> change,
                          double duration) const override {
        if (damping_change_) {
            damping_change_->add(v, change, duration);
        }
    }

    void complete_kick(NodeLine<const Real> u, NodeLine<Real> v) override {
        change_.add(u, v, time_step_);
    }

    void after_kick(NodeLine<const Real> u, NodeLine<Real> v, std::size_t step) override {
        const double time = static_cast<double>(step) * time_step_;
        if (given_ == OnSurface::traction) {
            v[ghosts_] += static_cast<Real>(time_step_ * load_ * at(time));
        } else {
            v[ghosts_] = static_cast<Real>(
                (at(time + time_step_) - static_cast<double>(u[ghosts_])) / time_step_);
        }
        for (std::size_t ghost = 0; ghost < ghosts_; ++ghost) {
            v[ghost] = v[ghosts_];
        }
    }

  private:
    double at(double time) const { return value_ ? value_(time) : 0; }

    EdgeEnergy edge_;
    std::size_t ghosts_;
    EdgeChange change_;                         // of the accelerations by u
    std::optional<EdgeChange> damping_change_;  // and by v
    double time_step_;
    OnSurface given_;
    double load_;  // acceleration of node 0 by a traction of 1
    std::function<double(double)> value_;
};

}  // namespace nmbc::detail
