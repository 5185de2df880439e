// SPDX-License-Identifier: MIT
/// Stability of a matching boundary on a half space and on chains of any length with two such
/// ends (theory of Gustafsson, Kreiss and Sundstrom, at one value of G).
///
/// A growing boundary mode is a wave k, |k| < 1, of s C(k) = B(k), s^2 = -omega^2(k), Re s > 0.
/// Without one, a chain with two like ends is stable at every length, short ones apart in which
/// decaying waves reach the other end, if and only if no sequence of
/// reflections is amplified: sup over diagonal phase matrices D of rho(R(omega) D) <= 1 for every
/// omega, D being the phases that travelling waves pick up on their way.
#pragma once

#include <complex>

#include "generator/stability/boundary_modes.hpp"
#include "generator/stability/reflection.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {

struct ModalVerdict {
    Failure failure = Failure::none;  ///< growing_mode; resonance, Delta(k_o) = 0 of a travelling
                                      ///< wave; amplified_wave, sup rho > 1
    double supremum = 0;              ///< of rho(R D) over the band, 0 where a mode decides
    double wave_number =
        0;  ///< the least |xi| of the frequency where it is reached; of the resonance
    bool backward = false;            ///< waves of opposed group and phase velocity travel there
    bool contractive = false;         ///< sigma_max(R) <= 1 on the whole band
    std::complex<double> growth = 0;  ///< s [c/dX] of the fastest growing mode
};

/// Its failure, which tells amplified backward waves from others.
inline Failure failure_of(const ModalVerdict& verdict) {
    return verdict.failure == Failure::amplified_wave && verdict.backward ? Failure::backward_band
                                                                          : verdict.failure;
}

/// A supremum above this counts as more than 1: the exact 1 of NMBC1 is found to 1e-13 or better up
/// to horizon 5.
inline constexpr double amplification_limit = 1 + 1e-12;

/// Whether it fails by a growing mode or a resonance.
ModalVerdict verdict_without_incident_waves(const HalfSpace& half_space);

ModalVerdict modal_verdict(const HalfSpace& half_space);

/// The grade alone (step_grades.hpp), in the half space's own step.
Grade stability_grade(const HalfSpace& half_space);

/// sup over D of rho(R D), R the reflection of both ends.
double like_ends_supremum(const Reflection& reflection);

/// sigma_max(R).
double norm(const Reflection& reflection);

}  // namespace nmbcgen
