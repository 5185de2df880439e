// SPDX-License-Identifier: MIT
/// A plane scene made ready to be stepped: lattice, sides, time step and sources.
#pragma once

#include <array>
#include <cstddef>
#include <nmbc/plane_stability.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/nmbcrun/plane/plane_scene.hpp"
#include "tools/nmbcrun/plane/plane_sources.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"
#include "tools/nmbcrun/sides/plane_pml.hpp"
#include "tools/nmbcrun/stepping/plane_stepping.hpp"

namespace nmbcrun {

struct PlanePlan : StepPlan {
    double of_stable = 0;  ///< dt over the longest step that is stable between these sides
};

/// What has gone where since the start. Not a number where it is not measured: what goes out
/// through sides that may feed energy in, and the drift beside such.
struct PlaneBalance {
    double energy = 0;             ///< staggered, of the whole body
    double work = 0;               ///< done by the sources
    std::array<double, 4> left{};  ///< gone out through each side, in the order of plane_sides
    double fracture = 0;           ///< what the bonds had that have broken
    double damped = 0;             ///< what the damping has taken
    /// energy of the whole body - (at the start + work - left - fracture - damped): roundings
    double drift = 0;
};

class PlaneSimulation {
  public:
    /// Designs passive sides, which takes a second at radius 1 and 20 s at radius 3. Throws
    /// SceneError where the scene asks for what there is not, std::invalid_argument as nmbc::Plane
    /// does, and Unstable where its step is too long for its sides.
    explicit PlaneSimulation(const PlaneScene& scene);
    /// Between these, which sides_of() made for the scene or one that differs in its steps.
    /// Likewise.
    PlaneSimulation(const PlaneScene& scene, const nmbc::PlaneSides& sides);

    const PlaneScene& scene() const { return scene_; }
    const PlanePlan& plan() const { return plan_; }
    const nmbc::Plane& plane() const { return plane_; }
    /// Layers that extended sides add to the scene's nodes, in the order of plane_sides.
    const std::array<std::size_t, 4>& extension() const { return extension_; }

    bool is_done() const { return plane_.steps() >= plan_.steps; }
    void advance(std::size_t steps);

    /// Of the scene's nodes, at t - dt/2.
    nmbc::PlaneEnergies energies() const;
    /// The energy of the whole body over that of its start and its sources.
    double times_supplied() const;
    /// At the same time, of the whole body.
    PlaneBalance balance() const;

    /// As lists of numbers; and to go on from those of a simulation of the same scene, bit for bit.
    /// Throws FileError where they are none of such a one.
    std::vector<std::vector<double>> state() const;
    void resume(std::size_t steps, const std::vector<std::vector<double>>& state);

    /// Largest difference of a component of u between neighbours whose bonds all hold [dX].
    double largest_strain() const;

    /// The field's entry of a node of the scene.
    std::size_t entry(std::size_t x, std::size_t y) const {
        return plane_.entry(x + extension_[0], y + extension_[2]);
    }

    /// The part of the bonds of a scene's node that no longer hold.
    double damage(std::size_t x, std::size_t y) const {
        return plane_.damage(x + extension_[0], y + extension_[2]);
    }

    /// In words: what the time steps miss of the sources; empty where they do not.
    const std::string& warning() const { return sources_.warning(); }

    /// Whether a source still acts at this time or later.
    bool is_driven(double time) const { return sources_.drives(time); }

  private:
    PlaneSimulation(PlaneScene scene, const nmbc::PlaneSides& sides,
                    const std::array<std::size_t, 4>& extension);
    nmbc::PlanePoint node_at(double X, double Y) const;
    void cut();
    void let_break();

    PlaneScene scene_;
    std::array<std::size_t, 4> extension_;
    PlanePlan plan_;
    nmbc::Plane plane_;
    std::optional<PlanePml> pml_;  // of the scene's layers of that kind
    PlaneSources sources_;
    double at_start_ = 0;  // energy of the whole body
};

}  // namespace nmbcrun
