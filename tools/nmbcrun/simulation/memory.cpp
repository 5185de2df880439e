// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "tools/nmbcrun/ends/half_line.hpp"
#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {
namespace {

/// Of one node of a chain: 79 were measured, 119 in a damped lattice (docs/how-to/long-runs.md).
constexpr std::uintmax_t bytes_of_node = 120;
/// Of one of a plane, while a checkpoint is stored: 202 were measured.
constexpr std::uintmax_t bytes_of_plane_node = 210;

void require(const std::string& body, std::size_t nodes, std::uintmax_t bytes_of_one,
             std::uintmax_t memory) {
    if (nodes > memory / bytes_of_one) {
        throw SceneError(
            fmt::format("{} needs {:.3g} GB of memory, and there are {:.3g}: at most "
                        "{} nodes are allowed",
                        body, double(nodes) * double(bytes_of_one) / 1e9, double(memory) / 1e9,
                        memory / bytes_of_one));
    }
}

}  // namespace

std::uintmax_t physical_memory() {
    return std::uintmax_t(sysconf(_SC_PHYS_PAGES)) * std::uintmax_t(sysconf(_SC_PAGESIZE));
}

void require_memory(std::size_t nodes, std::uintmax_t memory) {
    require(fmt::format("a chain of {} nodes, layers included,", nodes), nodes, bytes_of_node,
            memory);
}

void require_memory_of_plane(const std::array<std::size_t, 2>& nodes, std::uintmax_t memory) {
    require(fmt::format("a plane of {} x {} nodes", nodes[0], nodes[1]), nodes[0] * nodes[1],
            bytes_of_plane_node, memory);
}

void require_memory(const Scene& scene, const nmbc::Lattice& lattice, double time_step) {
    std::size_t nodes = scene.nodes;
    std::size_t fields =
        0;  // of perfectly matched layers: one or two for each square of the energy
    for (const Boundary* boundary : {&scene.left, &scene.right}) {
        if (boundary->kind == BoundaryKind::extended && boundary->layer == 0) {
            // A wider one is refused when it is made.
            nodes += std::min(layer_of(scene, *boundary, lattice, time_step / unit_of_time(scene)),
                              std::size_t(most_layer));
        } else if (has_layer(boundary->kind)) {
            nodes += boundary->layer;
        }
        fields +=
            boundary->kind == BoundaryKind::pml ? 2 * boundary->layer * lattice.energy.size() : 0;
    }
    const std::uintmax_t memory = physical_memory();
    const std::uintmax_t of_fields = fields * sizeof(double);
    require_memory(nodes, memory - std::min(memory, of_fields));
}

}  // namespace nmbcrun
