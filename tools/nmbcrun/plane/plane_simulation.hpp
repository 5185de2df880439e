// SPDX-License-Identifier: MIT
/// A plane scene made ready to be stepped: lattice, sides, time step and sources.
#pragma once

#include <array>
#include <cstddef>
#include <nmbc/plane_pml.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/nmbcrun/plane/held_bonds.hpp"
#include "tools/nmbcrun/plane/plane_body.hpp"
#include "tools/nmbcrun/plane/plane_plan.hpp"
#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/plane/plane_sources.hpp"
#include "tools/nmbcrun/stepping/plane_stepping.hpp"

namespace nmbcrun {

/// What has gone where since the start. Not a number where it is not measured: what goes out
/// through sides that may feed energy in, and the drift beside such.
struct PlaneBalance {
    double energy = 0;             ///< staggered, of the whole plane
    double work = 0;               ///< done by the sources
    std::array<double, 4> left{};  ///< gone out through each side, in the order of plane_sides
    double fracture = 0;           ///< what the bonds had that have broken
    double damped = 0;             ///< what the damping has taken
    /// energy of the whole plane - (at the start + work - left - fracture - damped): roundings
    double drift = 0;
};

class PlaneSimulation {
  public:
    /// Between sides_of() the scene, quiet or not. Throws as that does, std::invalid_argument as
    /// nmbc::Plane does, and Unstable where its step is too long for its sides.
    explicit PlaneSimulation(const PlaneScene& scene, bool quiet = true);
    /// Between these, which sides_of() made for the scene or one that differs in its steps.
    /// Likewise.
    PlaneSimulation(const PlaneScene& scene, const nmbc::PlaneSides& sides);

    const PlaneScene& scene() const { return scene_; }
    const PlanePlan& plan() const { return plan_; }
    const nmbc::Plane& plane() const { return plane_; }
    /// Layers that extended sides add to the scene's nodes, in the order of plane_sides.
    const std::array<std::size_t, 4>& extension() const { return extension_; }

    /// Of each side, in that order: what [initial] gave its outermost nodes, over what it gave any;
    /// 0 where it goes on as another run left it.
    const std::array<double, 4>& initial_at_sides() const { return initial_at_sides_; }

    bool is_done() const { return plane_.steps() >= plan_.steps; }
    void advance(std::size_t steps);

    /// Of the nodes of body(), at t - dt/2.
    nmbc::PlaneEnergies energies() const;
    /// Node by node, row by row [per volume].
    std::vector<double> energy_density() const;
    /// The energy of the whole plane over that of its start and its sources.
    double times_supplied() const;
    /// The energy of the whole plane at the start, and the work of its sources since.
    double supplied() const { return at_start_ + sources_.work(); }
    /// At the same time, of the whole plane.
    PlaneBalance balance() const;

    /// As lists of numbers; and to go on from those of a simulation of the same scene, bit for bit.
    /// Throws FileError where they are none of such a one.
    std::vector<std::vector<double>> state() const;
    void resume(std::size_t steps, const std::vector<std::vector<double>>& state);

    /// Largest difference of a component of u between neighbours [dX]; where bonds may break,
    /// between the ends of one that holds, over its length.
    double largest_strain() const;
    /// In words: loads that no longer act on the body, as bonds have broken.
    std::vector<std::string> torn_loads() const {
        return warnings_of_torn_loads(scene_, plane_, sources_);
    }

    /// The field's entry of a node of the scene.
    std::size_t entry(std::size_t x, std::size_t y) const {
        return plane_.entry(x + extension_[0], y + extension_[2]);
    }

    PlaneBody body() const { return body_of(scene_, plane_.layers()); }
    /// The field's entry of such a node, counted from the body's lower left one.
    std::size_t entry_of_body(std::size_t x, std::size_t y) const {
        return entry(x - body().before[0], y - body().before[1]);
    }

    /// The part of the bonds of a scene's node that no longer hold.
    double damage(std::size_t x, std::size_t y) const {
        return plane_.damage(x + extension_[0], y + extension_[2]);
    }

    /// In words: what the time steps miss of the sources; empty where they do not.
    const std::vector<std::string>& warnings() const { return sources_.warnings(); }

    /// Whether a source still acts at this time or later.
    bool is_driven(double time) const { return sources_.drives(time); }

  private:
    PlaneSimulation(PlaneScene scene, const nmbc::PlaneSides& sides,
                    const std::array<std::size_t, 4>& extension);
    nmbc::PlanePoint node_at(double X, double Y) const;
    /// Of the body's nodes along x, and along y, counted from the interior's first one.
    std::array<std::ptrdiff_t, 4> range_of_body() const;
    void cut();
    void let_break();

    PlaneScene scene_;
    std::array<std::size_t, 4> extension_;
    PlanePlan plan_;
    nmbc::Plane plane_;
    std::optional<nmbc::PlanePml> pml_;  // of the scene's layers of that kind
    PlaneSources sources_;
    double at_start_ = 0;  // energy of the whole plane
    std::array<double, 4> initial_at_sides_{};
};

}  // namespace nmbcrun
