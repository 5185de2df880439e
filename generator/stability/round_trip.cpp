// SPDX-License-Identifier: MIT
#include "generator/stability/round_trip.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "generator/stability/band_search.hpp"
#include "generator/stability/damped.hpp"
#include "generator/stability/merging_waves.hpp"
#include "generator/stability/mode_polynomial.hpp"

namespace nmbcgen {
namespace {

/// C = 1, B = 0.
HalfSpace without_condition(HalfSpace lattice) {
    lattice.E = Polynomial(std::vector<Rational>{1});
    lattice.O = Polynomial();
    lattice.F = Polynomial();
    lattice.H = Polynomial();
    lattice.c = {1};
    lattice.b = {0};
    lattice.stride = 1;
    lattice.modes = mode_coefficients(lattice);
    return lattice;
}

/// What an end does by itself. Fixed and free ends keep the energy.
RoundTripVerdict verdict_of_one(const LatticeEnd& end) {
    if (end.kind != LatticeEnd::Kind::matching) {
        return {};
    }
    const ModalVerdict alone = verdict_without_incident_waves(end.half_space);
    return {.failure = alone.failure, .wave_number = alone.wave_number, .growth = alone.growth};
}

double round_trip_supremum_at(const LatticeEnd& left, const LatticeEnd& right, double omega) {
    // A free end's R is a part of D, and sup rho(R D) is a square root of that of like ends.
    for (const auto& [end, opposite] : {std::pair(&left, &right), std::pair(&right, &left)}) {
        if (end->kind == LatticeEnd::Kind::free) {
            const Reflection other = reflection(*opposite, omega);
            return std::sqrt(round_trip_supremum(other, other));
        }
    }
    return round_trip_supremum(reflection(left, omega), reflection(right, omega));
}

/// Of both ends, ascending.
std::vector<double> critical_frequencies(const LatticeEnd& left, const LatticeEnd& right) {
    std::vector<double> frequencies = critical_frequencies(left.half_space);
    const std::vector<double> others = critical_frequencies(right.half_space);
    frequencies.insert(frequencies.end(), others.begin(), others.end());
    std::ranges::sort(frequencies);
    return frequencies;
}

Peak largest_undamped(const LatticeEnd& left, const LatticeEnd& right) {
    return largest_over_band(critical_frequencies(left, right), [&](double omega) {
        return round_trip_supremum_at(left, right, omega);
    });
}

Peak largest_damped(const LatticeEnd& left, const LatticeEnd& right, std::size_t nodes) {
    // The mirror image of a chain that ends in a free end makes it one of twice the length with
    // like ends, where a round trip is two of its own.
    for (const auto& [end, opposite] : {std::pair(&left, &right), std::pair(&right, &left)}) {
        if (end->kind == LatticeEnd::Kind::free) {
            const Peak twice = damped_amplification(opposite->half_space, 2 * nodes);
            return {std::sqrt(twice.value), twice.omega};
        }
    }
    return damped_amplification(left.half_space, right.half_space,
                                critical_frequencies(left, right), nodes);
}

/// Of the wave that fades least at this frequency; of several that travel the least one.
double wave_number_at(const HalfSpace& half_space, double omega) {
    const std::vector<Mode> modes = outgoing_modes(half_space, omega);
    const Mode& wave = half_space.is_damped() ? least_fading(modes) : modes.front();
    return std::abs(std::arg(wave.k));
}

bool are_alike(const LatticeEnd& left, const LatticeEnd& right) {
    return left.half_space.c == right.half_space.c && left.half_space.b == right.half_space.b &&
           left.half_space.stride == right.half_space.stride &&
           left.half_space.time_step == right.half_space.time_step;
}

/// Whether no wave is amplified in pieces of the band that are too narrow to sample, as far as each
/// end by itself tells.
bool keeps_narrow_pieces(const LatticeEnd& left, const LatticeEnd& right) {
    const bool meets_its_image = are_alike(left, right) || left.kind == LatticeEnd::Kind::free ||
                                 right.kind == LatticeEnd::Kind::free;
    const Grade enough = meets_its_image ? Grade::paired : Grade::contractive;
    const auto keeps = [enough](const LatticeEnd& end) {
        return end.kind != LatticeEnd::Kind::matching ||
               grade_of_narrow_pieces(end.half_space, critical_frequencies(end.half_space)).grade >=
                   enough;
    };
    return keeps(left) && keeps(right);
}

/// Throws std::invalid_argument where the two ends cannot be of one chain.
void require_one_chain(const HalfSpace& left, const HalfSpace& right, std::size_t nodes) {
    if (left.symbol != right.symbol || left.damping != right.damping) {
        throw std::invalid_argument("the two ends are of different lattices");
    }
    if (!left.is_damped()) {
        return;
    }
    if (nodes == 0) {
        throw std::invalid_argument("a damped chain needs its number of interior nodes");
    }
    if (left.time_step != right.time_step) {
        throw std::invalid_argument("the two ends of a damped chain have different time steps");
    }
    if (!interior_is_stable(left)) {
        throw std::invalid_argument("the interior of the damped chain is not stable in such steps");
    }
}

}  // namespace

LatticeEnd fixed_end(const HalfSpace& lattice) {
    return {LatticeEnd::Kind::fixed, without_condition(lattice)};
}

LatticeEnd free_end(const HalfSpace& lattice) {
    return {LatticeEnd::Kind::free, without_condition(lattice)};
}

Reflection reflection(const LatticeEnd& end, double omega) {
    Reflection found = reflection(end.half_space, omega);
    if (end.kind == LatticeEnd::Kind::free) {
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

RoundTripVerdict round_trip_verdict(const LatticeEnd& left, const LatticeEnd& right,
                                    std::size_t nodes) {
    require_one_chain(left.half_space, right.half_space, nodes);
    for (const LatticeEnd* end : {&left, &right}) {
        RoundTripVerdict verdict = verdict_of_one(*end);
        if (verdict.failure != Failure::none) {
            verdict.left = end == &left;
            return verdict;
        }
    }
    if (left.kind != LatticeEnd::Kind::matching && right.kind != LatticeEnd::Kind::matching) {
        return {.amplification = 1};  // exactly: energy is kept; with damping, at most
    }
    const Peak highest = left.half_space.is_damped() ? largest_damped(left, right, nodes)
                                                     : largest_undamped(left, right);
    RoundTripVerdict verdict;
    verdict.amplification = highest.value;
    if (highest.value > amplification_limit * amplification_limit ||
        (!left.half_space.is_damped() && !keeps_narrow_pieces(left, right))) {
        verdict.failure = Failure::amplified_wave;
    }
    if (highest.omega > 0) {
        verdict.wave_number = wave_number_at(left.half_space, highest.omega);
    }
    return verdict;
}

}  // namespace nmbcgen
