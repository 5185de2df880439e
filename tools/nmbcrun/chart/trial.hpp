// SPDX-License-Identifier: MIT
/// A scene run with one boundary in one time step, and how far off it is.
#pragma once

#include <nmbc/chain.hpp>
#include <string>
#include <vector>

#include "tools/nmbcrun/output/work.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Interior displacements at t = 0 and after each of equal parts of the run's time.
using Samples = std::vector<std::vector<double>>;

/// Sampling times of a run; time steps are chosen such that they are whole numbers of steps.
inline constexpr std::size_t sample_count = 100;

/// The scene in the longest such steps up to this cfl.
Scene in_steps_of(Scene scene, double cfl);

/// The chain of a scene that has its step, without its sources, between such ends.
nmbc::Chain chain_between(const Scene& scene, const nmbc::ChainEnd& left,
                          const nmbc::ChainEnd& right);

/// What a scene that has its step shows. Throws as Simulation does.
Samples samples_of(
    const Scene& scene, const Advance& advance = [](double) {});

/// What comes without ends: in the scene's own step. Throws as Simulation does, and Unstable where
/// nothing moves.
Samples samples_without_ends(
    const Scene& scene, const Advance& advance = [](double) {});

/// max |u - v| / max |v| over nodes and sampling times; infinite where u is not finite.
double relative_difference(const Samples& u, const Samples& v);

struct Trial {
    double cfl = 0;
    std::size_t steps = 0;
    std::string objection{};  ///< to the pair of ends, as Plan has it
    bool certified() const { return objection.empty(); }
    /// Against the endless run in the same steps: what the ends do.
    double boundary_error = 0;
    /// Against the endless run in fine steps: what ends and steps do.
    double total_error = 0;
    double energy_left = 0;  ///< over the peak
};

/// Runs a scene that has its step. Both references are of samples_without_ends(). A run that stops
/// being finite has infinite errors and energy.
Trial run_trial(const Scene& scene, const Samples& same_steps, const Samples& fine_steps,
                const Advance& advance);

}  // namespace nmbcrun
