// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/resumable.hpp"

#include <fmt/format.h>

#include "generator/names/checksum.hpp"
#include "tools/nmbcrun/errors.hpp"

namespace nmbcrun {
namespace {

/// Whether a run that ends later takes other steps up to there, too.
bool depends_on_end(const Scene& scene) {
    const auto depends = [](const Boundary& boundary) {
        return boundary.kind == BoundaryKind::exact ||
               (boundary.kind == BoundaryKind::extended && boundary.layer == 0);
    };
    return scene.incoming || depends(scene.left) || depends(scene.right);
}

}  // namespace

std::map<std::string, std::string> identity(const Simulation& simulation) {
    auto keys = identity_of(simulation.scene().given, depends_on_end(simulation.scene()),
                            simulation.plan().steps, simulation.plan().time_step);
    for (const auto& file : simulation.scene().own_tables) {
        keys["the checksum of " + file->name()] =
            fmt::format("{:x}", nmbcgen::checksum(file->text()));
    }
    return keys;
}

std::vector<std::vector<double>> packed(const ChainRun& run) {
    const auto& [chain, ledger, highlights] = run;
    return {chain.displacement,
            chain.velocity,
            chain.damped,
            chain.left,
            chain.right,
            {ledger.start, ledger.work, ledger.left, ledger.right},
            {highlights.peak, highlights.driven_peak, highlights.drift}};
}

ChainRun chain_run_of(const Checkpoint& checkpoint, const std::filesystem::path& path) {
    const auto& parts = checkpoint.state;
    if (parts.size() != 7 || parts[5].size() != 4 || parts[6].size() != 3) {
        throw FileError(fmt::format("{} is no checkpoint of a chain", path.string()));
    }
    return {.chain = {.steps = checkpoint.steps,
                      .displacement = parts[0],
                      .velocity = parts[1],
                      .damped = parts[2],
                      .left = parts[3],
                      .right = parts[4]},
            .ledger = {parts[5][0], parts[5][1], parts[5][2], parts[5][3]},
            .highlights = {parts[6][0], parts[6][1], parts[6][2]}};
}

}  // namespace nmbcrun
