// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/ends.hpp"

#include <nmbc/coefficients.hpp>
#include <nmbc/ends.hpp>

#include "tools/nmbcrun/simulation/tables.hpp"

namespace nmbcrun {

bool takes_table(BoundaryKind kind) {
    return kind == BoundaryKind::nmbc;
}

nmbc::ChainEnd chain_end(const Scene& scene, const Boundary& boundary) {
    switch (boundary.kind) {
        case BoundaryKind::fixed:
            return nmbc::FixedEnd{};
        case BoundaryKind::free:
            return nmbc::FreeEnd{};
        case BoundaryKind::extended:
            return nmbc::FixedEnd{boundary.layer};
        case BoundaryKind::nmbc:
            break;
    }
    return nmbc::MatchingEnd{
        nmbc::boundary_coefficients(table_of(scene, boundary), scene.G, nmbc::allow_unstable),
        boundary.ghosts};
}

}  // namespace nmbcrun
