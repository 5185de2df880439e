// SPDX-License-Identifier: MIT
/// A correspondence model of a plane lattice: the energy of a node, whole or with neighbours
/// missing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/plane_family.hpp>
#include <nmbc/plane_wave.hpp>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace nmbc {

enum class StressState { plane_stress, plane_strain };

/// 2D non-ordinary peridynamics of a correspondence material, stabilised after Silling (Nicely
/// 2018, sections 2 and 6), where E = density = dX = 1. With g the gradient (62) of u at a node, e
/// its symmetric part, w the influence of a bond R and z = u_J - u_I - g R on it, the energy of the
/// node is
///     k' (e_xx + e_yy)^2/2 + mu ((e_xx - e_yy)^2 + 4 e_xy^2)/2 + beta det g + (s/2) sum w |z|^2.
struct CorrespondenceModel {
    unsigned radius_squared = 1;  ///< delta^2 [dX^2]
    double bulk = 0;              ///< k', of the plane (10)
    double shear = 0;             ///< mu
    double stabilisation = 0;     ///< s = G C_BB/m of (9) to (11), m the bonds of a whole family
    /// beta: no force of the interior depends on it, only what acts at sides that are cut off.
    double null_lagrangian = 0;
    /// The s of forces on velocities, as those of the stabilisation on displacements; 0: none.
    double damping = 0;
    /// Of a bond by its |R|^2, those of squared_lengths(); their mean over the bonds is 1. Empty:
    /// it is 1 of each.
    std::vector<double> influence{};

    std::size_t horizon() const { return horizon_of(radius_squared); }
    std::size_t reach() const { return 2 * horizon(); }         ///< of forces [dX]
    double speed_P() const { return std::sqrt(bulk + shear); }  ///< c_L, of long waves
    double speed_S() const { return std::sqrt(shear); }         ///< c_S
};

/// poisson is nu; tau [dX sqrt(density/E)]: there are forces on velocities, too, tau times those of
/// the stabilisation at G = pi, as `nmbcgen recommend` finds it for sides of a plane. Throws
/// std::invalid_argument where there is no such material, and of a radius squared that is no sum of
/// two squares.
inline CorrespondenceModel nopd2d(unsigned radius_squared, double poisson, double G,
                                  StressState state = StressState::plane_stress, double tau = 0) {
    detail::require_radius(radius_squared);
    const double highest = state == StressState::plane_stress ? 1 : 0.5;
    if (!(poisson > -1 && poisson < highest)) {
        throw std::invalid_argument("Poisson's ratio must be between -1 and " +
                                    std::string(state == StressState::plane_stress ? "1" : "1/2") +
                                    ", not " + std::to_string(poisson));
    }
    if (!(G >= 0 && std::isfinite(G))) {
        throw std::invalid_argument("G must be a number not below 0");
    }
    if (!(tau >= 0 && std::isfinite(tau))) {
        throw std::invalid_argument("tau must be a number not below 0");
    }
    const double bulk = state == StressState::plane_stress
                            ? 1 / (2 * (1 - poisson))
                            : 1 / (2 * (1 + poisson) * (1 - 2 * poisson));
    const double radius4 = static_cast<double>(radius_squared) * radius_squared;
    const auto stabilisation = [&](double at) {
        return at * 12 * bulk /
               (std::numbers::pi * radius4 *
                static_cast<double>(plane_family(radius_squared).size()));
    };
    return {.radius_squared = radius_squared,
            .bulk = bulk,
            .shear = 1 / (2 * (1 + poisson)),
            .stabilisation = stabilisation(G),
            .damping = tau * stabilisation(std::numbers::pi)};
}

/// The |R|^2 that bonds of such a family have, least first [dX^2].
inline std::vector<unsigned> squared_lengths(unsigned radius_squared) {
    std::vector<unsigned> lengths;
    for (const PlaneOffset& bond : plane_family(radius_squared)) {
        lengths.push_back(static_cast<unsigned>(bond.x * bond.x + bond.y * bond.y));
    }
    std::ranges::sort(lengths);
    lengths.erase(std::unique(lengths.begin(), lengths.end()), lengths.end());
    return lengths;
}

namespace detail {

struct WeightedBond {
    int x = 0;
    int y = 0;
    double influence = 1;
};

/// The bonds of the family of a node.
inline std::vector<WeightedBond> weighted_family(const CorrespondenceModel& model) {
    const std::vector<unsigned> lengths = squared_lengths(model.radius_squared);
    std::vector<WeightedBond> family;
    for (const PlaneOffset& bond : plane_family(model.radius_squared)) {
        family.push_back({bond.x, bond.y});
        if (!model.influence.empty()) {
            const auto length = static_cast<unsigned>(bond.x * bond.x + bond.y * bond.y);
            const auto place = std::ranges::lower_bound(lengths, length) - lengths.begin();
            family.back().influence = model.influence[static_cast<std::size_t>(place)];
        }
    }
    return family;
}

/// A, the sum of w x^2 over the family of a node: its shape tensor is A times the identity.
inline double whole_shape(const CorrespondenceModel& model) {
    double sum = 0;
    for (const auto& [x, y, w] : weighted_family(model)) {
        sum += w * x * x;
    }
    return sum;
}

}  // namespace detail

/// The model with this influence, of which a factor says nothing: of bonds by their |R|^2, least
/// first. Throws std::invalid_argument unless there is one for each of squared_lengths(), all of
/// them positive and finite.
inline CorrespondenceModel with_influence(CorrespondenceModel model,
                                          std::vector<double> influence) {
    const std::size_t lengths = squared_lengths(model.radius_squared).size();
    if (influence.size() != lengths ||
        !std::ranges::all_of(influence, [](double one) { return one > 0 && std::isfinite(one); })) {
        throw std::invalid_argument("an influence is a positive number for each length of bonds, " +
                                    std::to_string(lengths) + " of this family");
    }
    model.influence = std::move(influence);
    const std::vector<detail::WeightedBond> family = detail::weighted_family(model);
    double mean = 0;
    for (const detail::WeightedBond& bond : family) {
        mean += bond.influence / static_cast<double>(family.size());
    }
    for (double& one : model.influence) {
        one /= mean;
    }
    const auto [least, most] = std::ranges::minmax(model.influence);
    if (least == most) {
        model.influence.clear();
    }
    return model;
}

/// Of P or S waves. With t the phase of a bond, w its influence, A the sum of w x^2 over the family
/// and s = sum w R sin t, omega^2 is (k' + mu or mu) |s|^2/A^2 + s_z (2 sum w (1 - cos t) -
/// |s|^2/A), s_z the weight of the stabilisation; P moves along s, S across it.
inline PlaneWave plane_wave(const CorrespondenceModel& model, const std::array<double, 2>& xi,
                            bool is_P) {
    double sine_x = 0;
    double sine_y = 0;
    double cosines = 0;
    double shape = 0;
    for (const auto& [x, y, w] : detail::weighted_family(model)) {
        const double phase = x * xi[0] + y * xi[1];
        sine_x += w * x * std::sin(phase);
        sine_y += w * y * std::sin(phase);
        cosines += w * (1 - std::cos(phase));
        shape += w * x * x;
    }
    const double square = sine_x * sine_x + sine_y * sine_y;
    const double length = square > 0 ? std::sqrt(square) : 1;
    const double modulus = is_P ? model.bulk + model.shear : model.shear;
    PlaneWave wave{
        modulus * square / (shape * shape) + model.stabilisation * (2 * cosines - square / shape),
        {sine_x / length, sine_y / length}};
    if (!is_P) {
        wave.direction = {-wave.direction[1], wave.direction[0]};
    }
    return wave;
}

}  // namespace nmbc
