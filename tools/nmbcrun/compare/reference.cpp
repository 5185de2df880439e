// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/compare/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nmbcrun {

Scene endless(Scene scene, double time_step) {
    scene.step = time_step;
    scene.cfl.reset();
    return with_artificial_ends(std::move(scene), {.kind = BoundaryKind::extended});
}

Scene with_mirrors(Scene scene) {
    for (Boundary* const end : {&scene.left, &scene.right}) {
        if (is_surface(end->kind)) {
            end->kind = nmbc::ends_on_node(closure_of(end->kind)) ? BoundaryKind::node_mirror
                                                                  : BoundaryKind::mirror;
        }
    }
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
