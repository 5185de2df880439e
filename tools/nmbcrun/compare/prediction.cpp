// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/compare/prediction.hpp"

#include <cmath>

#include "generator/stability/band_reflection.hpp"
#include "tools/nmbcrun/certification/half_space.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {

std::optional<double> predicted_reflection(const Scene& scene, const Boundary& boundary,
                                           const Packet& packet, double time_step) {
    if (is_damped(scene)) {
        return std::nullopt;
    }
    if (boundary.kind == BoundaryKind::fixed || boundary.kind == BoundaryKind::free) {
        return 1;
    }
    if (boundary.kind != BoundaryKind::nmbc) {
        return std::nullopt;
    }
    const auto half_space =
        stepped(half_space_of(table_of(scene, boundary), scene.G), time_step, boundary.ghosts);
    double reflected = 0;
    double total = 0;
    for (const Wave& wave : packet.waves()) {
        reflected += wave.energy() * nmbcgen::reflected_energy(half_space, std::abs(wave.xi));
        total += wave.energy();
    }
    return reflected / total;
}

}  // namespace nmbcrun
