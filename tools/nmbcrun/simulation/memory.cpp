// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "tools/nmbcrun/ends/half_line.hpp"
#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {
namespace {

/// Of one node: 79 were measured, 119 in a damped lattice (docs/how-to/long-runs.md).
constexpr std::uintmax_t bytes_of_node = 120;

}  // namespace

std::uintmax_t physical_memory() {
    return std::uintmax_t(sysconf(_SC_PHYS_PAGES)) * std::uintmax_t(sysconf(_SC_PAGESIZE));
}

void require_memory(std::size_t nodes, std::uintmax_t memory) {
    if (nodes > memory / bytes_of_node) {
        throw SceneError(fmt::format(
            "a chain of {} nodes, layers included, needs {:.3g} GB of memory, and there "
            "are {:.3g}: at most {} nodes are allowed",
            nodes, double(nodes) * double(bytes_of_node) / 1e9, double(memory) / 1e9,
            memory / bytes_of_node));
    }
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
