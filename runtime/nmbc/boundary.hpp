// SPDX-License-Identifier: MIT
/// The nonlocal matching boundary condition (60) on arrays of the user's own.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <nmbc/certificate.hpp>
#include <nmbc/coefficients.hpp>
#include <nmbc/lattice.hpp>
#include <nmbc/node_line.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace nmbc {

/// How far off, relatively, the step may be that a boundary is matched in: for a step written with
/// seven digits. It adds two millionths of the error that steps make of one that is not matched.
inline constexpr double time_step_tolerance = 1e-6;

namespace detail {

/// The first member of parameters that are given by name: {.spacing = ..}. A list without names, in
/// which two of one type could be swapped unseen, does not compile.
struct OnlyByName {
    explicit OnlyByName() = default;
};

}  // namespace detail

/// The lattice that a boundary closes, and its time step, in any one consistent system of units; by
/// name, {.ghost_layers = 4, .wave_speed = c, ..}.
struct BoundaryParameters {
    detail::OnlyByName by_name = detail::OnlyByName();
    std::size_t ghost_layers = 0;  ///< nodes beyond an end that the stencil reaches (2n for NOPD)
    double wave_speed = 0;         ///< c = sqrt(E/rho) [length/time]
    double spacing = 0;            ///< dX [length]
    double time_step = 0;          ///< dt [time]
};

/// Finds the velocities of the ghost nodes at one end of a line of nodes. The scheme it is made for
/// is leapfrog: u at levels k, v at k+1/2, u^{k+1} = u^k + dt v^{k+1/2}, ghost nodes included. For
/// a damped table, v^{k+1/2} = v^{k-1/2} + dt (accelerations of u^k - decelerations of v^{k-1/2}),
/// the old velocities of ghost nodes included (lattice.hpp).
template <class Real>
class BasicMatchingBoundary {
  public:
    /// Throws std::invalid_argument where a parameter is not positive and finite, where the
    /// coefficients are not N+1 of each at a stride of 1 or more or are matched in another time
    /// step or with other ghosts, where this time step makes the midpoint rule singular (b_0 dt/2 =
    /// c_0), and where the coefficients are certified for a lattice with other ghosts. Throws
    /// NotCertified where they are not certified for this time step or rule.
    BasicMatchingBoundary(const BoundaryCoefficients& coefficients,
                          const BoundaryParameters& parameters,
                          GhostRule rule = GhostRule::midpoint)
        : ghost_layers_(parameters.ghost_layers),
          stride_(static_cast<std::size_t>(coefficients.stride)) {
        for (const double value :
             {parameters.wave_speed, parameters.spacing, parameters.time_step}) {
            if (!(value > 0) || !std::isfinite(value)) {
                throw std::invalid_argument(
                    "wave speed, spacing and time step must be positive and finite");
            }
        }
        if (static_cast<std::ptrdiff_t>(ghost_layers_) < 1) {
            throw std::invalid_argument("a boundary needs a ghost layer at least, not " +
                                        in_words(ghost_layers_));
        }
        if (coefficients.c.empty() || coefficients.b.size() != coefficients.c.size() ||
            coefficients.stride < 1) {
            throw std::invalid_argument(
                "boundary coefficients: c and b need the same size, and a stride of 1 or more");
        }
        const double rate = parameters.wave_speed / parameters.spacing;
        require_matched(coefficients.matched_time_step, rate * parameters.time_step, rule);
        require_certified(coefficients, parameters, rule);
        const double implicit_time = rule == GhostRule::midpoint ? parameters.time_step / 2 : 0;
        const double own = coefficients.c[0] - implicit_time * rate * coefficients.b[0];
        if (std::abs(own) < 64 * std::numeric_limits<double>::epsilon()) {
            throw std::invalid_argument("this time step makes the midpoint rule singular");
        }
        // Midpoint: u = u^k + (dt/2) v, and v moves to the left-hand side.
        for (std::size_t j = 0; j < coefficients.c.size(); ++j) {
            const double b = rate * coefficients.b[j];
            weights_.push_back({static_cast<Real>(b / own),
                                static_cast<Real>((implicit_time * b - coefficients.c[j]) / own)});
        }
    }

    std::size_t ghost_layers() const { return ghost_layers_; }

    /// Nodes next to the end that the condition reads or writes, ghost layers included.
    std::size_t reach() const { return ghost_layers_ + (weights_.size() - 1) * stride_; }

    /// Writes the ghost entries of v at one end, from the innermost layer outwards.
    /// u: displacements at level k; v: velocities at k+1/2, interior entries already new. Both
    /// hold all nodes, `ghost_layers` ghosts first and last.
    /// Throws std::invalid_argument where they differ in size or have fewer than reach() nodes.
    void update(std::span<const Real> u, std::span<Real> v, End end) const {
        if (u.size() != v.size() || v.size() < reach()) {
            throw std::invalid_argument("u and v must have the same size, reach() nodes at least");
        }
        update({u, end}, {v, end});
    }

    /// The same where the sizes are known to be right.
    void update(NodeLine<const Real> u, NodeLine<Real> v) const {
        for (std::size_t ghost = ghost_layers_; ghost-- > 0;) {
            // From the inside out: what waits longest for its number, the velocity of the ghost
            // before this one, comes last.
            Real velocity = 0;
            for (std::size_t j = weights_.size(); --j > 0;) {
                const std::size_t node = ghost + j * stride_;
                velocity += weights_[j].displacement * u[node];
                velocity += weights_[j].velocity * v[node];
            }
            v[ghost] = velocity + weights_[0].displacement * u[ghost];
        }
    }

  private:
    /// What was a negative number is written as one.
    static std::string in_words(std::size_t count) {
        return std::to_string(static_cast<std::ptrdiff_t>(count));
    }

    /// matched, step: dt c/dX.
    static void require_matched(double matched, double step, GhostRule rule) {
        if (matched == 0) {
            return;
        }
        if (std::abs(step - matched) > time_step_tolerance * matched) {
            throw std::invalid_argument("the boundary is matched in time steps of " +
                                        detail::to_text(matched) + " dX/c, not " +
                                        detail::to_text(step));
        }
        if (rule != GhostRule::midpoint) {
            throw std::invalid_argument(
                "the boundary is matched in time steps with midpoint ghosts");
        }
    }

    static void require_certified(const BoundaryCoefficients& coefficients,
                                  const BoundaryParameters& p, GhostRule rule) {
        if (!coefficients.certificate) {
            return;
        }
        const BoundaryCertificate& certificate = *coefficients.certificate;
        const std::size_t reach = certificate.lattice->ghost_layers();
        if (p.ghost_layers != reach) {
            throw std::invalid_argument("the lattice of these coefficients reaches " +
                                        std::to_string(reach) + " nodes: ghost layers must be " +
                                        std::to_string(reach) + ", not " +
                                        in_words(p.ghost_layers));
        }
        if (rule != GhostRule::midpoint) {
            throw NotCertified(std::string("explicit ghosts have no certificate") +
                               detail::how_to_run_it);
        }
        const double unit = 2 * p.spacing / p.wave_speed /
                            maximum_frequency(make_lattice(*certificate.lattice, certificate.G));
        const double longest = certificate.steps.cfl * unit;
        const double shortest = certificate.steps.from * unit;
        // A step that was cfl, or has been in other units, is off by some roundings.
        constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
        const bool certified =
            p.time_step <= longest * (1 + roundings) && p.time_step >= shortest * (1 - roundings);
        if (coefficients.matched_time_step == 0 && !certified) {
            throw NotCertified(
                "a time step of " + detail::to_text(p.time_step) + " is not certified: " +
                (longest > 0
                     ? "it may be " +
                           (shortest > 0 ? detail::to_text(shortest) + " at least and " : "") +
                           detail::to_text(longest) + " at most, in the units given"
                     : "none is at this G") +
                detail::how_to_run_it);
        }
    }

    struct Weights {
        Real displacement;
        Real velocity;
    };
    std::vector<Weights> weights_;  // by j; the division of the midpoint rule is done
    std::size_t ghost_layers_;
    std::size_t stride_;
};

using MatchingBoundary = BasicMatchingBoundary<double>;

}  // namespace nmbc
