// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sources/forcing.hpp"

#include "tools/nmbcrun/sources/nodes_within.hpp"

namespace nmbcrun {

Forcing::Forcing(const Scene& scene, double time_step)
    : history_(*scene.force),
      density_(scene.density),
      time_step_(time_step),
      nodes_(
          require_nodes_within(scene, scene.force->centre, scene.force->half_width, "force", 1)) {
    history_.require_resolved("force", time_step);
}

void Forcing::operator()(std::span<double> v, std::size_t first_interior, double time) const {
    const double change = time_step_ * history_.at(time - time_step_) / density_;
    for (const std::size_t node : nodes_) {
        v[first_interior + node] += change;
    }
}

}  // namespace nmbcrun
