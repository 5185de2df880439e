// SPDX-License-Identifier: MIT
/// Set-ups that meet a tolerance by prediction and certificate.
#pragma once

#include <string>
#include <vector>

#include "tools/nmbcrun/advise/pause.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// One boundary at all artificial ends, in the longest steps it may take.
struct Candidate {
    std::string name;
    int horizon = 1;
    double G = 0;
    Boundary boundary;
    double cfl = 0;
    double time_step = 0;  ///< [time]
    std::size_t steps = 0;
    double boundary_error = 0;  ///< predicted, over max |u|
    /// Likewise, of time steps; 0 where the scene prescribes its step. Where horizon or G is
    /// "auto": of time steps and dispersion, against the wave equation.
    double interior_error = 0;
    std::string why_not_longer{};  ///< steps
    double cost = 0;  ///< of a run, in steps of the bare interior; filled in when it is measured

    double error() const { return boundary_error + interior_error; }
};

/// What was looked at, and why it is no candidate.
struct LeftOut {
    std::string name;
    std::string reason;
};

struct Candidates {
    std::vector<Candidate> meet;  ///< the tolerance, in no order
    std::vector<LeftOut> left_out;
};

/// Whether a scene leaves its lattice to be chosen.
bool has_open_lattice(const Scene& scene);

/// The scene with a candidate's lattice.
Scene with_lattice(Scene scene, int horizon, double G);

/// Every boundary that a scene's lattice can be certified with, each in the longest steps in which
/// it meets the tolerance; a scene's own time.step or time.cfl is kept. Its own artificial ends do
/// not count, its physical ones stay, and where both are the time step alone is sought. Where
/// horizon or G is "auto": those of every horizon of its family that there is, at some G; what is
/// left out is told by horizon then. Throws as Simulation does.
Candidates find_candidates(const Scene& scene, double tolerance, const Pause& pause);

}  // namespace nmbcrun
