// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/half_line.hpp"

#include "tools/nmbcrun/ends/silent_layer.hpp"

namespace nmbcrun {
namespace {

double duration_of(const Scene& scene) {  // [dX/c]
    return scene.end * wave_speed(scene) / scene.spacing;
}

}  // namespace

std::size_t layer_of(const Scene& scene, const Boundary& boundary, const nmbc::Lattice& lattice,
                     double time_step) {
    return boundary.kind == BoundaryKind::extended && boundary.layer == 0
               ? silent_layer(lattice, time_step, duration_of(scene))
               : boundary.layer;
}

bool is_half_line(const Scene& scene, const Boundary& boundary, const nmbc::Lattice& lattice,
                  double time_step) {
    if (boundary.kind != BoundaryKind::extended) {
        return boundary.kind == BoundaryKind::exact;
    }
    return boundary.layer == 0 ||
           boundary.layer >= silent_layer(lattice, time_step, duration_of(scene));
}

}  // namespace nmbcrun
