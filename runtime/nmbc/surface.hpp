// SPDX-License-Identifier: MIT
/// True surfaces: ends at which the body ends, with a displacement or a traction that is given in
/// time. Either ghosts stand in for the neighbours that the families beside the surface lack, or
/// these families have an energy of their own.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <nmbc/boundary_condition.hpp>
#include <nmbc/certificate.hpp>
#include <nmbc/convex_kernel.hpp>
#include <nmbc/edge_closure.hpp>
#include <nmbc/edge_condition.hpp>
#include <nmbc/edge_damping.hpp>
#include <nmbc/edge_energy.hpp>
#include <nmbc/edged_chain.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/mirror_images.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace nmbc {

/// How the chain ends. Of the first two the surface is midway between the outermost interior node
/// and the innermost ghost; nodes and ghosts are counted from it, 1, 2, .. Of the others the
/// outermost interior node lies on it.
enum class Closure {
    /// The mirror image about the surface: ghost f has 2 u_s - u_f, u_s the displacement given, or
    /// u_f + (2f - 1) dX e, e the strain of the traction. The chain is one half of a longer one.
    mirror,
    /// The surface node method (SNM 2023), (4) and (5): the ghosts lie on the line through the
    /// surface and the nearest node, and the bonds across the surface bear the traction. For
    /// chains of bonds.
    surface_node,
    sbp,     ///< summation by parts (sbp_edge): lattices of correspondence and of bonds
    kernel,  ///< convex kernels (kernel_edge): of correspondence, of a cubic spline's influence
    cut,     ///< families end where the nodes do (cut_edge): of correspondence and of bonds
    /// A mirror through the outermost node: ghost f has 2 u_s - u_f, or u_f + 2 f dX e, nodes
    /// counted from 0. Half of this node's energy counts, the body's, where nothing is given; else
    /// all of it, so that the energy is not constant while a wave is there.
    node_mirror,
};

/// Whether its surface is at the outermost interior node.
inline bool ends_on_node(Closure closure) {
    return closure != Closure::mirror && closure != Closure::surface_node;
}

/// A true end. The closures keep shifts and, but for kernel and cut, uniform strains exactly.
///
/// A surface node has no energy: its rows are not symmetric. Of bonds w_k > 0 between which one
/// wave travels at every frequency it sends that wave back whole, since its rows are real. The
/// others have one that is a sum of squares, and keep it while nothing is given.
/// `largest_eigenvalue` limits the step.
struct SurfaceEnd {
    Closure closure = Closure::mirror;
    OnSurface given = OnSurface::traction;
    std::function<double(double time)> value{};  ///< none: 0 at all times

    /// Of a lattice whose squares have their mirror images, as a chain's have. Throws NotCertified
    /// for steps that are too long for the closure, std::invalid_argument for a
    /// lattice that it does not end: a damped one for a surface node, and one whose damping is not
    /// tau times the stabilisation of its table for those with an energy of their own.
    template <class Real>
    std::unique_ptr<BoundaryCondition<Real>> make(const Lattice& lattice, const ChainParameters& p,
                                                  std::type_identity<Real> precision) const;

  private:
    /// Of a value of 1 [length].
    double unit_of(const ChainParameters& p) const {
        return given == OnSurface::traction ? p.spacing / p.youngs_modulus : 1;
    }
};

/// What -lambda of u'' = lambda u [c^2/dX^2] stays below in a chain of so many interior nodes with
/// this closure at both ends, where this is given: the interior's, or that of a mode that decays
/// inwards, and 1 % more. Of closures with an energy, a decomposition has shown it, up to
/// roundings, for the chain, or where it is long for one of 40 reaches, beyond which both ends are
/// alone. With the damping of a lattice it is so much more that steps dt [dX/c] are stable while
/// dt^2 times it is below 4; of a mirror see interior_cfl(). Of a surface node, which has no
/// energy, it is an estimate by power iteration. Throws as SurfaceEnd::make.
double largest_eigenvalue(const Lattice& lattice, Closure closure, OnSurface given,
                          std::size_t nodes);

namespace detail {

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

/// With like ends.
inline double fastest_eigenvalue(const Lattice& lattice, const GhostRows& ghosts,
                                 std::size_t nodes) {
    const std::size_t n = ghosts.count;
    std::vector<double> u(nodes + 2 * n);
    std::vector<double> next(u.size());
    return fastest_mode(lattice, nodes, [&](std::vector<double>& field) {
        std::ranges::copy(field, u.begin() + std::ptrdiff_t(n));
        for (std::size_t f = 0; f < n; ++f) {
            double left = 0;
            double right = 0;
            for (std::size_t i = 0; i < n; ++i) {
                left += ghosts.rows[f * n + i] * field[i];
                right += ghosts.rows[f * n + i] * field[nodes - 1 - i];
            }
            u[n - 1 - f] = left;
            u[n + nodes + f] = right;
        }
        accelerations(lattice, 1, u, next);
        std::copy_n(next.begin() + std::ptrdiff_t(n), nodes, field.begin());
    });
}

inline bool is_mirror(Closure closure) {
    return closure == Closure::mirror || closure == Closure::node_mirror;
}

inline EdgeEnergy closure_edge(Closure closure, const Lattice& lattice) {
    switch (closure) {
        case Closure::cut:
            return cut_edge(lattice);
        case Closure::sbp:
            return sbp_edge(lattice);
        case Closure::kernel:
            return kernel_edge(lattice);
        case Closure::mirror:
        case Closure::surface_node:
        case Closure::node_mirror:
            break;
    }
    throw std::logic_error("this end has no edge of its own");
}

/// A closure with an energy of its own.
struct Edge {
    EdgeEnergy energy;
    std::optional<EdgeDamping> damping;  ///< none where nothing is damped
};

inline Edge edge_with_damping(Closure closure, const Lattice& lattice) {
    Edge edge{closure_edge(closure, lattice), std::nullopt};
    if (!lattice.damping.empty()) {
        Lattice at_1 = stabilised_at_1(lattice);
        EdgeEnergy edge_at_1 = closure_edge(closure, at_1);
        edge.damping = edge_damping(lattice, std::move(at_1), std::move(edge_at_1));
    }
    return edge;
}

/// 1 % more than estimates say.
inline constexpr double eigenvalue_margin = 1.01;

/// Nodes that show the largest eigenvalue of a chain as well as all: in a longer one, what decays
/// from one end is gone at the other.
inline std::size_t enough_nodes(std::size_t nodes, std::size_t least, std::size_t most) {
    return std::clamp(nodes, least, std::max(least, most));
}

/// largest_eigenvalue() between two such ends.
inline double eigenvalue_bound(const Edge& edge, const Lattice& lattice, OnSurface given,
                               std::size_t nodes) {
    const std::size_t n = lattice.reach();
    const std::size_t least = 2 * edge.energy.mass.size() + 1;
    EdgedChain chain{edge.energy, lattice, edge.damping, given == OnSurface::displacement,
                     enough_nodes(nodes, least, 6 * n + 8)};
    double bound = eigenvalue_margin * chain.fastest();
    chain.nodes = enough_nodes(nodes, least, 40 * n);
    while (!chain.is_stable_below(bound)) {
        bound *= eigenvalue_margin;
    }
    return bound;
}

/// likewise, between surface nodes.
inline double eigenvalue_bound(const GhostRows& surface_nodes, const Lattice& lattice,
                               std::size_t nodes) {
    const std::size_t n = lattice.reach();
    return eigenvalue_margin *
           fastest_eigenvalue(lattice, surface_nodes, enough_nodes(nodes, n, 6 * n + 8));
}

/// Throws NotCertified of steps that are too long for it.
inline void require_step_below(double eigenvalue_bound, const ChainParameters& p) {
    const double longest = 2 / std::sqrt(eigenvalue_bound);
    const double step = p.time_step * p.wave_speed() / p.spacing;
    if (!(step <= longest)) {
        throw NotCertified("a chain with this true end is stable in steps up to " +
                           std::to_string(longest) + " dX/c, and the step is " +
                           std::to_string(step) + " dX/c");
    }
}

}  // namespace detail

inline double largest_eigenvalue(const Lattice& lattice, Closure closure, OnSurface given,
                                 std::size_t nodes) {
    if (detail::is_mirror(closure)) {  // half of a longer chain
        return detail::eigenvalue_margin * std::pow(maximum_frequency(lattice), 2);
    }
    if (closure == Closure::surface_node) {
        return detail::eigenvalue_bound(detail::surface_node_rows(lattice, given), lattice, nodes);
    }
    const Lattice whole = with_mirror_images(lattice);
    return detail::eigenvalue_bound(detail::edge_with_damping(closure, whole), whole, given, nodes);
}

template <class Real>
std::unique_ptr<BoundaryCondition<Real>> SurfaceEnd::make(
    const Lattice& lattice, const ChainParameters& p,
    std::type_identity<Real> /*precision*/) const {
    if (detail::is_mirror(closure)) {
        const bool through_node = closure == Closure::node_mirror;
        std::optional<EdgeEnergy> energy;
        if (!value) {
            energy = through_node ? detail::node_mirror_energy(lattice, given) : EdgeEnergy{};
        }
        return std::make_unique<detail::SurfaceCondition<Real>>(
            detail::mirror_rows(lattice, given, through_node), unit_of(p), p.time_step, value,
            std::move(energy));
    }
    if (closure == Closure::surface_node) {
        if (!lattice.damping.empty()) {
            throw std::invalid_argument("a surface node needs a lattice without damping");
        }
        const detail::GhostRows rows = detail::surface_node_rows(lattice, given);
        detail::require_step_below(detail::eigenvalue_bound(rows, lattice, p.nodes), p);
        return std::make_unique<detail::SurfaceCondition<Real>>(rows, unit_of(p), p.time_step,
                                                                value);
    }
    detail::Edge edge = detail::edge_with_damping(closure, lattice);
    detail::require_step_below(detail::eigenvalue_bound(edge, lattice, given, p.nodes), p);
    return std::make_unique<detail::EdgeCondition<Real>>(std::move(edge.energy), lattice,
                                                         edge.damping, p, given, value);
}

}  // namespace nmbc
