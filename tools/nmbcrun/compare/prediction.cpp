// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/compare/prediction.hpp"

#include <cmath>

#include "generator/stability/band_reflection.hpp"
#include "generator/stability/half_space.hpp"
#include "tools/nmbcrun/simulation/exact_table.hpp"
#include "tools/nmbcrun/simulation/tables.hpp"

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
        stepped(make_half_space(exact_table(table_of(scene, boundary)), nmbcgen::Rational(scene.G)),
                time_step,
                boundary.ghosts == nmbc::GhostRule::midpoint ? nmbcgen::GhostLevel::midpoint
                                                             : nmbcgen::GhostLevel::old);
    double reflected = 0;
    double total = 0;
    for (const Wave& wave : packet.waves()) {
        reflected += wave.energy() * nmbcgen::reflected_energy(half_space, std::abs(wave.xi));
        total += wave.energy();
    }
    return reflected / total;
}

}  // namespace nmbcrun
