// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/chains.hpp"

#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {

nmbc::Chain chain_between(const Scene& scene, const nmbc::ChainEnd& left,
                          const nmbc::ChainEnd& right) {
    return {lattice_of(scene),
            left,
            right,
            {.nodes = scene.nodes,
             .spacing = scene.spacing,
             .youngs_modulus = scene.youngs_modulus,
             .density = scene.density,
             .time_step = scene.step.value()}};
}

}  // namespace nmbcrun
