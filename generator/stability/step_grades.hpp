// SPDX-License-Identifier: MIT
/// Grades of one half space in steps of any length: what does not depend on the step is found once.
#pragma once

#include <map>
#include <unordered_map>
#include <vector>

#include "generator/stability/half_space.hpp"
#include "generator/stability/reflection.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {

/// Paired where sup rho <= 1, contractive where sigma_max <= 1, too (modal.hpp); none of a damped
/// lattice is contractive. Quicker than modal_verdict(), as it stops at the first failure.
class StepGrades {
  public:
    explicit StepGrades(HalfSpace half_space);
    StepGrades(const StepGrades&) = delete;
    StepGrades& operator=(const StepGrades&) = delete;

    /// In leapfrog steps [dX/c]; 0: in continuous time.
    Grade in(double time_step);

    /// Whether a boundary mode grows.
    bool grows_in(double time_step);

    /// The top of the band, omega_max [c/dX].
    double maximum_frequency() const { return critical_.back(); }

  private:
    Grade found();
    const Reflection& reflection_at(double omega);
    bool holds(double (*size)(const Reflection&));

    HalfSpace half_space_;  ///< in the step that is asked for
    std::vector<double> critical_;
    OutgoingModes modes_;
    std::unordered_map<double, ReflectionInSteps> reflections_;  ///< by frequency
    std::map<double, Grade> known_;
};

}  // namespace nmbcgen
