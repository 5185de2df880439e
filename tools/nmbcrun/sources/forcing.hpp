// SPDX-License-Identifier: MIT
/// The body force of a scene.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"
#include "tools/nmbcrun/sources/force_in_time.hpp"

namespace nmbcrun {

/// Its share of every step: v += dt f(t) / rho at its nodes, t the step's beginning, where u is.
class Forcing {
  public:
    /// Throws SceneError where no node takes the force, its file does not make a history or the
    /// steps are too long for it, FileError where the file cannot be read.
    Forcing(const Scene& scene, double time_step);

    /// From 0.
    const std::vector<std::size_t>& nodes() const { return nodes_; }

    /// Of the history: f at a time.
    double force_at(double time) const { return history_.at(time); }

    /// Whether the force acts, above 1e-16 of its amplitude, at this time or later.
    bool drives(double time) const { return history_.drives(time); }

    /// As ForceInTime has it.
    std::vector<std::string> warnings(double end) const {
        return history_.warnings("force", time_step_, end);
    }

    /// first_interior: entry of the first interior node of v. time: the end of the step.
    void operator()(std::span<double> v, std::size_t first_interior, double time) const;

  private:
    ForceInTime history_;
    double density_;
    double time_step_;
    std::vector<std::size_t> nodes_;  // from 0
};

}  // namespace nmbcrun
