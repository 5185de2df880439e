// SPDX-License-Identifier: MIT
/// Whether a chain or a plane fits in memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nmbc/lattice.hpp>

#include "tools/nmbcrun/scene/scene.hpp"

namespace nmbcrun {

/// Of the machine, whoever else uses it [bytes].
std::uintmax_t physical_memory();

/// Throws SceneError, with the number of nodes that are allowed, where a run of a chain of so many
/// nodes, layers included, would not fit in so much memory [bytes]. Else a system that gives out
/// more memory than it has would end the run, or another program, without a word.
void require_memory(std::size_t nodes, std::uintmax_t memory);

/// Likewise of a plane, whose checkpoints take most.
void require_memory_of_plane(const std::array<std::size_t, 2>& nodes, std::uintmax_t memory);

/// As the first one, of the scene in steps of time_step [time], in the machine's memory.
void require_memory(const Scene& scene, const nmbc::Lattice& lattice, double time_step);

}  // namespace nmbcrun
