// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_lattice.hpp"

#include <cmath>

#include "generator/exact/rational.hpp"

namespace nmbcrun {

nmbc::BondModel bonds_of(const PlaneScene& scene) {
    return nmbc::bond2d(scene.radius_squared, scene.weights);
}

nmbc::CorrespondenceModel nopd2d_of(const PlaneScene& scene) {
    const nmbc::CorrespondenceModel model =
        nmbc::nopd2d(scene.radius_squared, nmbcgen::nearest_double(scene.nu), scene.G, scene.state,
                     nmbcgen::nearest_double(scene.tau));
    return scene.influence.empty() ? model : nmbc::with_influence(model, scene.influence);
}

double G_of_least_dispersion(PlaneScene scene, bool is_P) {
    constexpr double xi = 0.01;  // its square is what this leaves of the answer, relatively
    const auto error = [&](double G) {
        scene.G = G;
        const nmbc::PlaneModel model = nopd2d_of(scene);
        const double speed = is_P ? model.speed_P() : model.speed_S();
        return nmbc::plane_wave(model, {xi, 0}, is_P).omega_squared / std::pow(speed * xi, 2) - 1;
    };
    return error(0) / (error(0) - error(1));  // omega^2 along an axis is linear in G
}

nmbc::PlaneModel model_of(const PlaneScene& scene) {
    if (scene.is_bond_based()) {
        return bonds_of(scene);
    }
    return nopd2d_of(scene);
}

std::optional<double> critical_stretch(const PlaneScene& scene) {
    if (!scene.fracture || !scene.fracture->energy) {
        return scene.fracture ? scene.fracture->critical_stretch : std::nullopt;
    }
    const double of_one = nmbc::fracture_energy(bonds_of(scene), 1);
    return std::sqrt(*scene.fracture->energy / (of_one * scene.youngs_modulus * scene.spacing));
}

double rate_of(const PlaneScene& scene) {
    return wave_speed(scene) / scene.spacing;
}

}  // namespace nmbcrun
