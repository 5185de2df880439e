// SPDX-License-Identifier: MIT
/// A correspondence model of a plane lattice: the energy of a node, whole or with neighbours
/// missing.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/plane_family.hpp>
#include <nmbc/plane_wave.hpp>
#include <numbers>
#include <stdexcept>
#include <string>

namespace nmbc {

enum class StressState { plane_stress, plane_strain };

/// 2D non-ordinary peridynamics of a correspondence material with constant influence, stabilised
/// after Silling (Nicely 2018, sections 2 and 6), where E = density = dX = 1. With g the gradient
/// (62) of u at a node, e its symmetric part, z = u_J - u_I - g R on each bond R, the energy of the
/// node is
///     k' (e_xx + e_yy)^2/2 + mu ((e_xx - e_yy)^2 + 4 e_xy^2)/2 + beta det g + (s/2) sum |z|^2.
struct CorrespondenceModel {
    unsigned radius_squared = 1;  ///< delta^2 [dX^2]
    double bulk = 0;              ///< k', of the plane (10)
    double shear = 0;             ///< mu
    double stabilisation = 0;     ///< s = G C_BB/m of (9) to (11), m the bonds of a whole family
    /// beta: no force of the interior depends on it, only what acts at sides that are cut off.
    double null_lagrangian = 0;
    /// The s of forces on velocities, as those of the stabilisation on displacements; 0: none.
    double damping = 0;

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

/// Of P or S waves. With t the phase of a bond, A the sum of x^2 over the family and s = sum R sin
/// t, omega^2 is (k' + mu or mu) |s|^2/A^2 + s_z (2 sum (1 - cos t) - |s|^2/A), s_z the weight of
/// the stabilisation; P moves along s, S across it.
inline PlaneWave plane_wave(const CorrespondenceModel& model, const std::array<double, 2>& xi,
                            bool is_P) {
    double sine_x = 0;
    double sine_y = 0;
    double cosines = 0;
    double shape = 0;
    for (const PlaneOffset& bond : plane_family(model.radius_squared)) {
        const double phase = bond.x * xi[0] + bond.y * xi[1];
        sine_x += bond.x * std::sin(phase);
        sine_y += bond.y * std::sin(phase);
        cosines += 1 - std::cos(phase);
        shape += bond.x * bond.x;
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
