// SPDX-License-Identifier: MIT
#include "generator/stability/step_grades.hpp"

#include <utility>

#include "generator/stability/band_search.hpp"
#include "generator/stability/damped.hpp"
#include "generator/stability/merging_waves.hpp"
#include "generator/stability/modal.hpp"

namespace nmbcgen {

StepGrades::StepGrades(HalfSpace half_space)
    : half_space_(std::move(half_space)),
      critical_(critical_frequencies(half_space_)),
      modes_(half_space_) {}

Grade StepGrades::in(double time_step) {
    const auto [entry, is_new] = known_.try_emplace(time_step);
    if (is_new) {
        half_space_.time_step = time_step;
        entry->second = found();
    }
    return entry->second;
}

bool StepGrades::grows_in(double time_step) {
    half_space_.time_step = time_step;
    return growing_mode(half_space_).has_value();
}

Grade StepGrades::found() {
    if (verdict_without_incident_waves(half_space_).failure != Failure::none) {
        return Grade::none;
    }
    if (half_space_.is_damped()) {
        constexpr double limit = amplification_limit * amplification_limit;
        const bool holds =
            interior_is_stable(half_space_) &&
            damped_amplification(half_space_, half_space_, critical_, least_damped_nodes, limit)
                    .value <= limit;
        return holds ? Grade::paired : Grade::none;
    }
    const Grade most = grade_of_narrow_pieces(half_space_, critical_).grade;
    if (most == Grade::contractive && holds(norm)) {
        return Grade::contractive;
    }
    return most >= Grade::paired && holds(like_ends_supremum) ? Grade::paired : Grade::none;
}

const Reflection& StepGrades::reflection_at(double omega) {
    auto found = reflections_.find(omega);
    if (found == reflections_.end()) {
        ReflectionInSteps in_steps(half_space_, modes_.at(omega));
        found = reflections_.emplace(omega, std::move(in_steps)).first;
    }
    return found->second.at(boundary_rate(half_space_, omega));
}

bool StepGrades::holds(double (*size)(const Reflection&)) {
    const auto size_at = [&](double omega) { return size(reflection_at(omega)); };
    return largest_over_band(critical_, size_at, amplification_limit).value <= amplification_limit;
}

Grade stability_grade(const HalfSpace& half_space) {
    return StepGrades(half_space).in(half_space.time_step);
}

}  // namespace nmbcgen
