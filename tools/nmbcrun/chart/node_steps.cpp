// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/node_steps.hpp"

#include "tools/nmbcrun/ends/silent_layer.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {

double node_steps(const Scene& scene) {
    const double step = scene.step.value();
    const double unit = unit_of_time(scene);
    auto nodes = double(scene.nodes);
    switch (scene.left.kind) {
        case BoundaryKind::extended:
            nodes += 2 * double(scene.left.layer > 0 ? scene.left.layer
                                                     : silent_layer(lattice_of(scene), step / unit,
                                                                    scene.end / unit));
            break;
        case BoundaryKind::sponge:
            nodes += 2 * double(scene.left.layer);
            break;
        case BoundaryKind::pml:
            nodes += 60 * double(scene.left.layer);  // 23 to 36 times a plain node each
            break;
        case BoundaryKind::exact:
            nodes += 6e4;
            break;
        default:
            break;
    }
    return nodes * double(steps_until(scene.end, step));
}

}  // namespace nmbcrun
