// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/prediction/prediction.hpp"

#include <cmath>

#include "generator/stability/band_reflection.hpp"
#include "tools/nmbcrun/certification/half_space.hpp"
#include "tools/nmbcrun/ends/passive_design.hpp"
#include "tools/nmbcrun/prediction/layer_reflection.hpp"
#include "tools/nmbcrun/tables/tables.hpp"
#include "tools/nmbcrun/terminal/interrupt.hpp"

namespace nmbcrun {

std::optional<std::function<double(double xi)>> reflected_energy_of(const Scene& scene,
                                                                    const Boundary& boundary,
                                                                    double time_step) {
    if (is_damped(scene)) {
        return std::nullopt;
    }
    if (is_physical(boundary.kind)) {
        return [](double) { return 1.0; };
    }
    switch (boundary.kind) {
        case BoundaryKind::exact:
            return [](double) { return 0.0; };
        case BoundaryKind::extended:
            if (boundary.layer > 0) {
                return std::nullopt;
            }
            return [](double) { return 0.0; };
        case BoundaryKind::passive:
            return [sent_back = sent_back_by_passive_end(lattice_of(scene), time_step)](double xi) {
                return sent_back(xi).energy;
            };
        case BoundaryKind::nmbc:
            if (boundary.ghosts != nmbc::GhostRule::midpoint) {
                return std::nullopt;  // the analysis is of midpoint ghosts
            }
            break;
        case BoundaryKind::sponge:
        case BoundaryKind::pml:
            if (boundary.layer > widest_told_layer(lattice_of(scene))) {
                return std::nullopt;
            }
            return energy_sent_back_by_layer(
                lattice_of(scene),
                stepped(half_space_of(table_of(scene, {.kind = BoundaryKind::fixed}), scene.G),
                        time_step),
                boundary);
        default:
            return std::nullopt;
    }
    return [half_space = stepped(half_space_of(table_of(scene, boundary), scene.G), time_step)](
               double xi) { return nmbcgen::reflected_energy(half_space, xi); };
}

std::optional<double> predicted_reflection(const Scene& scene, const Boundary& boundary,
                                           const Packet& packet, double time_step) {
    const auto reflected_energy = reflected_energy_of(scene, boundary, time_step);
    if (!reflected_energy) {
        return std::nullopt;
    }
    double reflected = 0;
    double total = 0;
    for (const Wave& wave : packet.spectrum()) {
        stop_if_interrupted();
        reflected += wave.energy() * (*reflected_energy)(std::abs(wave.xi));
        total += wave.energy();
    }
    return reflected / total;
}

}  // namespace nmbcrun
