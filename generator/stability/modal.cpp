// SPDX-License-Identifier: MIT
#include "generator/stability/modal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/dense/decompositions.hpp"
#include "generator/stability/band_search.hpp"
#include "generator/stability/damped.hpp"
#include "generator/stability/reflection.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

double like_ends_supremum(const Reflection& reflection) {
    return std::sqrt(round_trip_supremum(reflection, reflection));
}

/// sigma_max(R).
double norm(const Reflection& reflection) {
    return std::sqrt(squared_spectral_norm(reflection.matrix));
}

/// Of a damped lattice, without boundary modes. The search ends at an amplification above `enough`.
ModalVerdict damped_verdict(const HalfSpace& half_space, double enough) {
    if (!interior_is_stable(half_space)) {
        return {.failure = Failure::amplified_wave};
    }
    const Peak highest = damped_amplification(half_space, half_space, least_damped_nodes, enough);
    ModalVerdict verdict;
    verdict.supremum = std::sqrt(highest.value);
    if (verdict.supremum > amplification_limit) {
        verdict.failure = Failure::amplified_wave;
        const auto modes = outgoing_modes(half_space, highest.omega);
        const Mode& wave = least_fading(modes);
        verdict.wave_number = std::abs(std::arg(wave.k));
        verdict.backward = std::arg(wave.k) > 0;
    }
    return verdict;
}

}  // namespace

Grade stability_grade(const HalfSpace& half_space) {
    KnownModes modes(half_space);
    return stability_grade(half_space, modes);
}

Grade stability_grade(const HalfSpace& half_space, KnownModes& modes) {
    if (verdict_without_incident_waves(half_space).failure != Failure::none) {
        return Grade::none;
    }
    if (half_space.is_damped()) {
        return damped_verdict(half_space, amplification_limit).failure == Failure::none
                   ? Grade::paired
                   : Grade::none;
    }
    const std::vector<double> frequencies = critical_frequencies(half_space);
    const auto holds = [&](double (*size)(const Reflection&)) {
        const auto size_at = [&](double omega) {
            return size(reflection(half_space, omega, modes.at(omega)));
        };
        const Peak peak = largest_over_band(frequencies, size_at, amplification_limit);
        return peak.value <= amplification_limit;
    };
    if (holds(norm)) {
        return Grade::contractive;
    }
    return holds(like_ends_supremum) ? Grade::paired : Grade::none;
}

ModalVerdict verdict_without_incident_waves(const HalfSpace& half_space) {
    if (const auto growth = growing_mode(half_space)) {
        return {.failure = Failure::growing_mode, .growth = *growth};
    }
    if (const auto xi = resonance(half_space)) {
        return {.failure = Failure::resonance, .wave_number = *xi};
    }
    return {};
}

ModalVerdict modal_verdict(const HalfSpace& half_space) {
    const ModalVerdict alone = verdict_without_incident_waves(half_space);
    if (alone.failure != Failure::none) {
        return alone;
    }
    if (half_space.is_damped()) {
        return damped_verdict(half_space, std::numeric_limits<double>::infinity());
    }
    double largest_norm = 0;
    const auto supremum = [&](double omega) {
        const Reflection R = reflection(half_space, omega);
        largest_norm = std::max(largest_norm, norm(R));
        return like_ends_supremum(R);
    };
    const Peak highest = largest_over_band(critical_frequencies(half_space), supremum);
    ModalVerdict verdict;
    verdict.supremum = highest.value;
    verdict.contractive = largest_norm <= amplification_limit;
    if (highest.value > amplification_limit) {
        verdict.failure = Failure::amplified_wave;
    }
    if (highest.omega > 0) {
        const auto modes = outgoing_modes(half_space, highest.omega);
        verdict.wave_number = std::abs(std::arg(modes.front().k));
        verdict.backward = std::ranges::any_of(
            modes, [](const Mode& mode) { return mode.travels() && std::arg(mode.k) > 0; });
    }
    return verdict;
}

}  // namespace nmbcgen
