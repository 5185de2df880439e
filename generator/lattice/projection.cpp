// SPDX-License-Identifier: MIT
#include "generator/lattice/projection.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

/// Of displacements that depend on x alone: sum over y and z of the factors, by offset in x.
std::map<int, Rational> along_x(const VectorSquare& square, std::size_t direction) {
    std::map<int, Rational> sums;
    for (const VectorTerm& term : square.terms) {
        sums[term.offset[0]] += term.factors[direction];
    }
    std::erase_if(sums, [](const auto& entry) { return entry.second == 0; });
    return sums;
}

/// The coupling of two directions is sum of weight times the correlation of their factors.
void require_uncoupled(const VectorModel& model, std::size_t direction) {
    for (std::size_t other = 0; other < model.dimensions; ++other) {
        if (other == direction) {
            continue;
        }
        std::map<int, Polynomial> coupling;  // by the difference of offsets
        for (const VectorSquare& square : model.energy) {
            for (const auto& [i, own] : along_x(square, direction)) {
                for (const auto& [j, coupled] : along_x(square, other)) {
                    coupling[j - i] += square.weight * constant(own * coupled);
                }
            }
        }
        if (std::ranges::any_of(coupling,
                                [](const auto& entry) { return !entry.second.is_zero(); })) {
            throw NoProjection("waves along x of this model are neither P nor S");
        }
    }
}

/// A stencil from -reach to reach, its first entry that is not zero positive: the square of a
/// stencil does not know its sign.
std::vector<Rational> stencil_of(const std::map<int, Rational>& sums) {
    const int reach = std::max(std::abs(sums.begin()->first), std::abs(sums.rbegin()->first));
    const int sign = sums.begin()->second > 0 ? 1 : -1;
    std::vector<Rational> stencil(std::size_t(2 * reach + 1));
    for (const auto& [offset, factor] : sums) {
        stencil[std::size_t(offset + reach)] = sign * factor;
    }
    return stencil;
}

}  // namespace

Polynomial speed_squared(const VectorModel& model, std::size_t direction) {
    // Of long waves a square sees the strain i xi sum x s_x: its factors add up to 0.
    Polynomial sum;
    for (const VectorSquare& square : model.energy) {
        Rational strain = 0;
        for (const auto& [offset, factor] : along_x(square, direction)) {
            strain += offset * factor;
        }
        sum += square.weight * constant(strain * strain);
    }
    return sum;
}

NoProjection long_waves_do_not_travel(std::size_t polarisation) {
    return NoProjection(std::string("long ") + (polarisation == 0 ? "P" : "S") +
                        " waves do not travel: nothing in this model resists them");
}

Model project(const VectorModel& model, std::size_t direction) {
    require_uncoupled(model, direction);
    const Polynomial square_of_speed = speed_squared(model, direction);
    if (square_of_speed.is_zero()) {
        throw long_waves_do_not_travel(direction);
    }
    if (square_of_speed.degree() > 0) {
        throw NoProjection("the speed of long waves depends on G in this model");
    }
    const Polynomial per_unit = constant(1 / square_of_speed[0]);
    Model projected{.description = model.description,
                    .source = model.source,
                    .energy = {},
                    .symbol = {},
                    .damping = {}};
    for (const VectorSquare& square : model.energy) {
        const std::map<int, Rational> sums = along_x(square, direction);
        if (sums.empty()) {
            continue;
        }
        const std::vector<Rational> stencil = stencil_of(sums);
        const auto like = std::ranges::find_if(projected.energy, [&](const ExactSquare& one) {
            return one.part == square.part && one.stencil == stencil;
        });
        if (like == projected.energy.end()) {
            projected.energy.push_back({square.part, square.weight * per_unit, stencil});
        } else {
            like->weight += square.weight * per_unit;
        }
    }
    return projected;
}

}  // namespace nmbcgen
