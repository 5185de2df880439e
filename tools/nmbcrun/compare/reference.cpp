// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/compare/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/nmbcrun/simulation/silent_layer.hpp"

namespace nmbcrun {

Scene endless(const Simulation& simulation) {
    const nmbc::Chain& chain = simulation.chain();
    const double unit = chain.parameters().spacing / chain.parameters().wave_speed();
    const double step = simulation.plan().time_step / unit;
    Scene scene = simulation.scene();
    scene.step = simulation.plan().time_step;
    scene.cfl.reset();
    scene.left = {
        .kind = BoundaryKind::extended,
        .layer = silent_layer(chain.lattice(), step, double(simulation.plan().steps) * step)};
    scene.right = scene.left;
    return scene;
}

std::span<const double> interior(const nmbc::Chain& chain) {
    return chain.displacement().subspan(chain.first_interior(), chain.parameters().nodes);
}

void Deviation::look(const nmbc::Chain& chain, const nmbc::Chain& reference) {
    const auto u = interior(chain);
    const auto u_ref = interior(reference);
    for (std::size_t node = 0; node < u.size(); ++node) {
        const double difference = std::abs(u[node] - u_ref[node]);
        if (!(difference <= largest_)) {  // or is not a number
            largest_ =
                std::isfinite(difference) ? difference : std::numeric_limits<double>::infinity();
            node_ = node + 1;
            time_ = chain.time();
        }
        reference_ = std::max(reference_, std::abs(u_ref[node]));
    }
}

double Deviation::relative() const {
    return largest_ == 0 ? 0 : largest_ / reference_;
}

}  // namespace nmbcrun
