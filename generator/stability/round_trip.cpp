// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stability/round_trip.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "generator/stability/band_search.hpp"

namespace nmbcgen {
namespace {

/// C = 1, B = 0.
HalfSpace without_condition(HalfSpace lattice) {
    lattice.E = Polynomial(std::vector<Rational>{1});
    lattice.O = Polynomial();
    lattice.c = {1};
    lattice.b = {0};
    lattice.stride = 1;
    return lattice;
}

/// What an end does by itself. Fixed and free ends keep the energy.
RoundTripVerdict verdict_of_one(const ChainEnd& end) {
    if (end.kind != EndKind::matching) {
        return {};
    }
    if (const auto growth = growing_mode(end.half_space)) {
        return {.failure = ModalFailure::growing_mode, .growth = *growth};
    }
    if (const auto xi = resonance(end.half_space)) {
        return {.failure = ModalFailure::resonance, .wave_number = *xi};
    }
    return {};
}

double round_trip_supremum_at(const ChainEnd& left, const ChainEnd& right, double omega) {
    // A free end's R is a part of D, and sup rho(R D) is a square root of that of like ends.
    for (const auto& [end, opposite] : {std::pair(&left, &right), std::pair(&right, &left)}) {
        if (end->kind == EndKind::free) {
            const Reflection other = reflection(*opposite, omega);
            return std::sqrt(round_trip_supremum(other, other));
        }
    }
    return round_trip_supremum(reflection(left, omega), reflection(right, omega));
}

}  // namespace

ChainEnd fixed_end(const HalfSpace& lattice) {
    return {EndKind::fixed, without_condition(lattice)};
}

ChainEnd free_end(const HalfSpace& lattice) {
    return {EndKind::free, without_condition(lattice)};
}

Reflection reflection(const ChainEnd& end, double omega) {
    Reflection found = reflection(end.half_space, omega);
    if (end.kind == EndKind::free) {
        found.matrix.setZero();
        found.amplitudes.setZero();
        for (Eigen::Index i = 0; i < found.matrix.rows(); ++i) {
            // (1/k)^j + A k^j is its own mirror image where A = k; no other wave is needed.
            found.matrix(i, i) = found.outgoing[std::size_t(i)].k;
            found.amplitudes(i, i) = found.matrix(i, i);
        }
    }
    return found;
}

RoundTripVerdict round_trip_verdict(const ChainEnd& left, const ChainEnd& right) {
    if (left.half_space.symbol != right.half_space.symbol) {
        throw std::invalid_argument("the two ends are of different lattices");
    }
    for (const ChainEnd* end : {&left, &right}) {
        RoundTripVerdict verdict = verdict_of_one(*end);
        if (verdict.failure != ModalFailure::none) {
            verdict.left = end == &left;
            return verdict;
        }
    }
    if (left.kind != EndKind::matching && right.kind != EndKind::matching) {
        return {.amplification = 1};  // exactly: energy is kept
    }
    std::vector<double> frequencies = critical_frequencies(left.half_space);
    const std::vector<double> others = critical_frequencies(right.half_space);
    frequencies.insert(frequencies.end(), others.begin(), others.end());
    std::ranges::sort(frequencies);
    const Peak highest = largest_over_band(
        frequencies, [&](double omega) { return round_trip_supremum_at(left, right, omega); });
    RoundTripVerdict verdict;
    verdict.amplification = highest.value;
    if (highest.value > amplification_limit * amplification_limit) {
        verdict.failure = ModalFailure::amplified_wave;
    }
    if (highest.omega > 0) {
        verdict.wave_number =
            std::abs(std::arg(outgoing_modes(left.half_space, highest.omega).front().k));
    }
    return verdict;
}

}  // namespace nmbcgen
