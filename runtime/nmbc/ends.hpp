// SPDX-License-Identifier: MIT
/// What a chain can end in: a matching boundary, or an end that keeps the energy.
#pragma once

#include <cstddef>
#include <nmbc/boundary.hpp>
#include <span>
#include <variant>

namespace nmbc {

/// (60) on every ghost layer.
struct MatchingEnd {
    BoundaryCoefficients coefficients;
    GhostRule ghost_rule = GhostRule::midpoint;
};

/// Every ghost node is held at u = 0.
struct FixedEnd {};

/// The mirror image: j = 0 the outermost interior node, counted inwards, ghost node -1-j moves as
/// node j does. The mirror is midway between the outermost interior node and the innermost ghost.
struct FreeEnd {};

using ChainEnd = std::variant<MatchingEnd, FixedEnd, FreeEnd>;

/// Writes the ghost entries of a field, u or v, at a fixed or free end; `ghosts` entries first and
/// last. A free end needs as many interior nodes.
inline void impose(FixedEnd /*kind*/, std::span<double> field, std::size_t ghosts, End end) {
    for (double& ghost : end == End::left ? field.first(ghosts) : field.last(ghosts)) {
        ghost = 0;
    }
}

inline void impose(FreeEnd /*kind*/, std::span<double> field, std::size_t ghosts, End end) {
    const auto from_end = [&](std::size_t j) -> double& {
        return end == End::left ? field[j] : field[field.size() - 1 - j];
    };
    for (std::size_t layer = 0; layer < ghosts; ++layer) {
        from_end(layer) = from_end(2 * ghosts - 1 - layer);
    }
}

}  // namespace nmbc
