// SPDX-License-Identifier: MIT
/// The series (7) of SNM 2023: a nonlocal bar between true ends, as the continuum has it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// u = sum_m A_m phi_m(x) cos(omega_m t) of a bar that is 0 or free at each end, phi_m sines or
/// cosines of k_m: the endless bar with an odd extension where u = 0 is given and an even one where
/// no traction is. omega^2 = (2 v^2/delta) int_0^delta (1 - cos(k xi))/xi^2 dxi, which is (2
/// v^2/delta^2) (k delta Si(k delta) + cos(k delta) - 1).
class BarSeries {
  public:
    /// Of a scene that starts from rest by a pulse of displacement, between surfaces with nothing
    /// given but 0, with the bonds of SNM 2023 of horizon 2 or more, printed or corrected: of the
    /// printed ones v is that of the bar which they stand for. Nothing of another scene.
    static std::optional<BarSeries> of(const Scene& scene);

    /// ||u - series||/||u at t = 0|| over the nodes.
    double error(std::span<const double> u, double time) const;

  private:
    BarSeries(const Scene& scene, double speed);

    struct Term {
        double wave_number;  ///< [1/length]
        double frequency;    ///< [1/time]
        double amplitude;    ///< A_m
    };
    /// phi_m
    double shape(double wave_number, double x) const;

    bool begins_odd_;            ///< u = 0 is given at the left surface
    std::vector<double> nodes_;  ///< x, from the left surface
    std::vector<Term> terms_;
    double size_ = 0;  ///< ||u at t = 0||
};

}  // namespace nmbcrun
