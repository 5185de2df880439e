// SPDX-License-Identifier: MIT
/// A chain that ends on its outermost interior node, with the energy of that edge.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/edge_energy.hpp>
#include <nmbc/lattice.hpp>
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

/// K of the nodes next to a left edge, whose forces -K u differ from the lattice's, row by row.
struct EdgeStiffness {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<double> entries{};
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

/// The outermost node lies on the surface. Beyond it there is nothing: the ghosts go with it, so
/// that in a body that has moved far the lattice's own forces, which are taken back, are small.
template <class Real>
class EdgeCondition final : public BoundaryCondition<Real> {
  public:
    /// K: stiffness_of() the edges.
    EdgeCondition(EdgeEnergies edges, const EdgeStiffness& K, const Lattice& lattice,
                  const ChainParameters& p, OnSurface given, std::function<double(double)> value)
        : edges_(std::move(edges)),
          ghosts_(lattice.reach()),
          rows_(K.rows),
          columns_(K.columns),
          changes_(K.entries.size()),
          time_step_(p.time_step),
          given_(given),
          load_(1 / (p.density * p.spacing * edges_.left.mass.at(0))),
          value_(std::move(value)) {
        const double rate = p.wave_speed() / p.spacing;
        for (std::size_t row = 0; row < rows_; ++row) {
            const double mass = row < edges_.left.mass.size() ? edges_.left.mass[row] : 1;
            std::vector<double> change(columns_);
            for (std::size_t column = 0; column < columns_; ++column) {
                change[column] = -K.entries[row * columns_ + column] / mass;
            }
            change[row] += lattice.symbol[0];
            for (std::size_t m = 1; m <= ghosts_; ++m) {
                change[row + m] += lattice.symbol[m];
                change[row < m ? 0 : row - m] += lattice.symbol[m];  // ghosts are where node 0 is
            }
            for (std::size_t column = 0; column < columns_; ++column) {
                changes_[row * columns_ + column] = rate * rate * change[column];
            }
        }
    }

    std::size_t least_interior_nodes() const override { return columns_; }

    const EdgeEnergy* own_energy(End end) const override {
        return end == End::left ? &edges_.left : &edges_.right;
    }

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
        change(u, v, duration);
        if (given_ == OnSurface::traction) {
            v[ghosts_] += static_cast<Real>(duration * load_ * at(0));
        }
    }

    void complete_kick(NodeLine<const Real> u, NodeLine<Real> v) override {
        change(u, v, time_step_);
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

    /// From what the lattice's forces do in so long, with these ghosts, to what the edge's do.
    void change(NodeLine<const Real> u, NodeLine<Real> v, double duration) const {
        const double* entry = changes_.data();
        for (std::size_t row = 0; row < rows_; ++row) {
            const auto own = static_cast<double>(u[ghosts_ + row]);
            double sum = 0;
            for (std::size_t column = 0; column < columns_; ++column) {
                sum += *entry++ * (static_cast<double>(u[ghosts_ + column]) - own);
            }
            v[ghosts_ + row] += static_cast<Real>(duration * sum);
        }
    }

    EdgeEnergies edges_;
    std::size_t ghosts_;
    std::size_t rows_;
    std::size_t columns_;
    std::vector<double> changes_;  // of the accelerations by u, row by row; rows add up to 0
    double time_step_;
    OnSurface given_;
    double load_;  // acceleration of node 0 by a traction of 1
    std::function<double(double)> value_;
};

/// Adds weight L^T (L u) of a stencil L, whose entries are at place(0), place(1), ..
template <class Place>
void add_force(double weight, const std::vector<double>& stencil, const Place& place,
               const std::vector<double>& u, std::vector<double>& force) {
    double sum = 0;
    for (std::size_t i = 0; i < stencil.size(); ++i) {
        sum += stencil[i] * u[place(i)];
    }
    for (std::size_t i = 0; i < stencil.size(); ++i) {
        force[place(i)] += weight * stencil[i] * sum;
    }
}

/// M^-1 K u of a chain between two edges.
inline std::vector<double> between_edges(const EdgeEnergies& edges, const Lattice& lattice,
                                         const std::vector<double>& u) {
    const std::size_t nodes = u.size();
    const std::size_t edge = edges.left.mass.size();
    std::vector<double> force(nodes);
    for (const EdgeEnergy::Square& square : edges.left.squares) {
        add_force(
            square.weight, square.stencil, [](std::size_t i) { return i; }, u, force);
    }
    for (const EdgeEnergy::Square& square : edges.right.squares) {
        add_force(
            square.weight, square.stencil, [=](std::size_t i) { return nodes - 1 - i; }, u, force);
    }
    for (const auto& [part, weight, stencil] : lattice.energy) {
        for (std::size_t node = edge; node + edge < nodes; ++node) {
            const std::size_t first = node - stencil.size() / 2;
            add_force(
                weight, stencil, [=](std::size_t i) { return first + i; }, u, force);
        }
    }
    for (std::size_t node = 0; node < edge; ++node) {
        force[node] /= edges.left.mass[node];
        force[nodes - 1 - node] /= edges.right.mass[node];
    }
    return force;
}

/// Estimates -lambda of the fastest mode of a chain of this many nodes, by power iteration; of the
/// interior, if that is more. accelerate(u) puts the accelerations in the place of the
/// displacements u.
template <class Accelerate>
double fastest_mode(const Lattice& lattice, std::size_t nodes, const Accelerate& accelerate) {
    std::vector<double> u(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {  // neither even nor odd about the middle
        const double size = 1 + static_cast<double>(i) / static_cast<double>(nodes);
        u[i] = i % 2 == 0 ? size : -size;
    }
    double largest = 0;
    constexpr int enough = 400;  // the error falls by the ratio of eigenvalues every time
    for (int iteration = 0; iteration < enough; ++iteration) {
        accelerate(u);
        largest = 0;
        for (const double entry : u) {
            largest = std::max(largest, std::abs(entry));
        }
        for (double& entry : u) {
            entry /= largest;
        }
    }
    const double top = maximum_frequency(lattice);
    return std::max(largest, top * top);
}

/// A chain between two edges.
struct EdgedChain {
    const EdgeEnergies& edges;
    const Lattice& lattice;
    bool is_held = false;  ///< u = 0 on the outermost nodes
    std::size_t nodes = 0;

    /// Estimates the largest eigenvalue of M^-1 K.
    double fastest() const {
        const auto hold = [this](std::vector<double>& field) {
            if (is_held) {
                field.front() = field.back() = 0;
            }
        };
        return fastest_mode(lattice, nodes, [&](std::vector<double>& u) {
            hold(u);
            u = between_edges(edges, lattice, u);
            hold(u);
        });
    }

    /// Whether all eigenvalues of M^-1 K are below `bound`, up to roundings: Cholesky's
    /// decomposition of bound M - K exists.
    bool is_below(double bound) const;
};

inline bool EdgedChain::is_below(double bound) const {
    // Whichever node a square is counted at, both ends are one body's: K is its own mirror image.
    const EdgeStiffness K = stiffness_of(edges.left, lattice);
    const auto of_lattice = [this](std::size_t distance) {
        return distance <= lattice.reach() ? lattice.symbol[distance] : 0;
    };
    // What an edge puts in the place of the endless lattice.
    const auto change = [&](std::size_t row, std::size_t column) {
        const std::size_t distance = row > column ? row - column : column - row;
        return row < K.rows && column < K.columns
                   ? K.entries[row * K.columns + column] - of_lattice(distance)
                   : 0;
    };
    const auto mass = [&](std::size_t node) {
        const std::vector<double>& of_left = edges.left.mass;
        const std::vector<double>& of_right = edges.right.mass;
        const std::size_t from_right = nodes - 1 - node;
        return node < of_left.size()          ? of_left[node]
               : from_right < of_right.size() ? of_right[from_right]
                                              : 1;
    };
    const std::size_t width = K.columns;
    const std::size_t first = is_held ? 1 : 0;
    std::vector<double> L(nodes * width);  // entry (i, i - k) at i * width + k
    for (std::size_t i = first; i + first < nodes; ++i) {
        double* const row = &L[i * width];
        const std::size_t band = std::min(i - first, width - 1);
        for (std::size_t k = band + 1; k-- > 0;) {
            const std::size_t j = i - k;
            double entry = -of_lattice(k) - change(i, j) - change(nodes - 1 - i, nodes - 1 - j);
            for (std::size_t m = k + 1; m <= band; ++m) {
                entry -= row[m] * L[j * width + m - k];
            }
            if (k > 0) {
                row[k] = entry / L[j * width];
                continue;
            }
            entry += bound * mass(i);
            if (!(entry > 0)) {
                return false;
            }
            row[0] = std::sqrt(entry);
        }
    }
    return true;
}

}  // namespace nmbc::detail
