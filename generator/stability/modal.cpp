// SPDX-License-Identifier: MIT
#include "generator/stability/modal.hpp"

#include <algorithm>
#include <cmath>

#include "generator/dense/decompositions.hpp"
#include "generator/stability/band_search.hpp"
#include "generator/stability/damped.hpp"
#include "generator/stability/merging_waves.hpp"
#include "generator/stability/reflection.hpp"
#include "generator/table/certificate.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

/// Of a damped lattice, without boundary modes.
ModalVerdict damped_verdict(const HalfSpace& half_space) {
    if (!interior_is_stable(half_space)) {
        return {.failure = Failure::amplified_wave};
    }
    const Peak highest = damped_amplification(half_space, least_damped_nodes);
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

double like_ends_supremum(const Reflection& reflection) {
    return std::sqrt(round_trip_supremum(reflection, reflection));
}

double norm(const Reflection& reflection) {
    return std::sqrt(squared_spectral_norm(reflection.matrix));
}

ModalVerdict verdict_without_incident_waves(const HalfSpace& half_space) {
    const BoundaryModes modes(half_space);
    if (const auto growth = modes.growing()) {
        return {.failure = Failure::growing_mode, .growth = *growth};
    }
    if (const auto xi = modes.resonance()) {
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
        return damped_verdict(half_space);
    }
    double largest_norm = 0;
    OutgoingModes waves(half_space);
    const auto supremum = [&](double omega) {
        const Reflection R = reflection(half_space, omega, waves.at(omega));
        largest_norm = std::max(largest_norm, norm(R));
        return like_ends_supremum(R);
    };
    const std::vector<double> critical = critical_frequencies(half_space);
    Peak highest = largest_over_band(critical, supremum);
    const NarrowPieces narrow = grade_of_narrow_pieces(half_space, critical);
    if (highest.value <= amplification_limit && narrow.grade == Grade::none) {
        highest.omega = narrow.omega;  // elsewhere the peak is one of roundings
    }
    ModalVerdict verdict;
    verdict.supremum = highest.value;
    verdict.contractive = largest_norm <= amplification_limit && narrow.grade == Grade::contractive;
    if (highest.value > amplification_limit || narrow.grade == Grade::none) {
        verdict.failure = Failure::amplified_wave;
    }
    if (highest.omega > 0) {
        const auto modes = waves.at(highest.omega);
        verdict.wave_number = std::abs(std::arg(modes.front().k));
        verdict.backward = std::ranges::any_of(
            modes, [](const Mode& mode) { return mode.travels() && std::arg(mode.k) > 0; });
    }
    return verdict;
}

}  // namespace nmbcgen
