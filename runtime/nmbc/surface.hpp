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
#include <nmbc/surface_ghosts.hpp>
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

/// Estimates -lambda of the fastest mode of a chain between two ends with such ghosts.
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
