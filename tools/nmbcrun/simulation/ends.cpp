// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/ends.hpp"

#include <nmbc/coefficients.hpp>
#include <nmbc/ends.hpp>

#include "tools/nmbcrun/ends/higdon.hpp"
#include "tools/nmbcrun/ends/mbc.hpp"
#include "tools/nmbcrun/ends/pml.hpp"
#include "tools/nmbcrun/ends/sponge.hpp"
#include "tools/nmbcrun/simulation/tables.hpp"

namespace nmbcrun {

namespace {

nmbc::BoundaryCoefficients coefficients_of(const Scene& scene, const Boundary& boundary) {
    return nmbc::boundary_coefficients(table_of(scene, boundary), scene.G, nmbc::allow_unstable);
}

}  // namespace

bool takes_table(BoundaryKind kind) {
    return kind == BoundaryKind::nmbc || kind == BoundaryKind::mbc;
}

bool has_certificate(BoundaryKind kind) {
    return kind == BoundaryKind::nmbc || adds_no_energy(kind);
}

nmbc::ChainEnd chain_end(const Scene& scene, const Boundary& boundary) {
    switch (boundary.kind) {
        case BoundaryKind::fixed:
            return nmbc::FixedEnd{};
        case BoundaryKind::free:
            return nmbc::FreeEnd{};
        case BoundaryKind::extended:
            return nmbc::FixedEnd{boundary.layer};
        case BoundaryKind::sponge:
            return SpongeEnd{{boundary.layer, boundary.profile, target_of(boundary)}};
        case BoundaryKind::pml:
            return PmlEnd{{boundary.layer, boundary.profile, target_of(boundary)}};
        case BoundaryKind::higdon:
            return HigdonEnd{boundary.order};
        case BoundaryKind::mbc:
            return MbcEnd{coefficients_of(scene, boundary), boundary.ghosts};
        case BoundaryKind::nmbc:
            break;
    }
    return nmbc::MatchingEnd{coefficients_of(scene, boundary), boundary.ghosts};
}

}  // namespace nmbcrun
