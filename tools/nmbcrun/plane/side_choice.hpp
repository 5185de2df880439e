// SPDX-License-Identifier: MIT
/// The sides that a plane scene can have. Keys, units and defaults: docs/reference/plane-scene.md.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nmbcrun {

enum class SideKind {
    passive,   ///< stable by construction, designed for the lattice
    fixed,     ///< ghosts held at u = 0
    free,      ///< no nodes beyond it
    sbp,       ///< lines of nodes beyond it, the outermost the surface, by summation by parts
    kernel,    ///< likewise, by convex kernels
    mirror,    ///< the mirror image beyond it
    periodic,  ///< the opposite side is its neighbour
    extended,  ///< more of the same lattice, fixed at its far end
    nmbc,      ///< (60) on the ghost layers, component by component
    higdon,    ///< Higdon's product for given waves on the ghost layers
    sponge,    ///< a layer that damps the velocity
    pml,       ///< a perfectly matched layer
};

/// A long wave, and the angle from the side's normal at which it comes.
struct ObliqueWave {
    bool is_P = true;
    double degrees = 0;  ///< 0 <= degrees < 90

    friend bool operator==(const ObliqueWave&, const ObliqueWave&) = default;
};

struct PlaneSideChoice {
    SideKind kind = SideKind::passive;
    /// Nodes of an extended one, 0: as many as it takes; of a layer; of a passive one with numbers
    /// of their own, 0: 2n.
    std::size_t layer = 0;
    // Of an nmbc:
    int order = 1;
    int stride = 1;
    bool as_printed = false;  ///< (81): the speed of P waves for both components
    std::vector<ObliqueWave> absorb{{true, 0}, {false, 0}};  ///< by a higdon, a factor each
    bool is_odd = false;  ///< of a mirror: its image is turned round in itself
    // Of a sponge or a perfectly matched layer:
    double profile = 2;    ///< exponent of the losses in the depth
    double target = 0.01;  ///< amplitude that the continuum sends back

    friend bool operator==(const PlaneSideChoice&, const PlaneSideChoice&) = default;
};

/// In the order of nmbc::plane_sides.
inline constexpr std::array<std::string_view, 4> plane_side_names{"left", "right", "bottom", "top"};

/// Whether the side can feed energy in.
bool may_grow(SideKind kind);

/// Whether it has nodes of its own beyond the scene's, `layer` of them.
bool has_layer(SideKind kind);

/// Whether the body ends there on its outermost nodes, which are beyond the scene's.
bool is_closed(SideKind kind);

/// Whether the body ends there, under tractions or free: at closed and free sides.
bool ends_body(SideKind kind);

/// Whether it stands for more of the same lattice: physical sides are closed, fixed, free, mirror
/// and periodic ones.
bool is_artificial(SideKind kind);

/// As a scene spells it, such as "fixed".
std::string_view name_of(SideKind kind);

/// All of them, by name.
const std::vector<std::pair<std::string_view, SideKind>>& side_kinds();

/// The side in words, such as "NMBC1 as printed, (81)" or "fixed".
std::string heading_of(const PlaneSideChoice& side);

}  // namespace nmbcrun
