// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/resumable.hpp"

#include <fmt/format.h>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/output/checksum.hpp"

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
    auto keys = simulation.scene().given;
    if (depends_on_end(simulation.scene())) {
        keys["the number of steps"] = fmt::format("{}", simulation.plan().steps);
    } else {
        keys.erase("time.end");
    }
    keys.erase("title");
    keys.erase("output.checkpoint");
    for (const auto& file : simulation.scene().own_tables) {
        keys["the checksum of " + file->name()] = fmt::format("{:x}", checksum(file->text()));
    }
    keys["the version of nmbcrun"] = NMBC_VERSION;
    keys["the time step"] = fmt::format("{:a}", simulation.plan().time_step);
    return keys;
}

void require_resumable(const Simulation& simulation, const Checkpoint& checkpoint,
                       const std::filesystem::path& path) {
    const auto& stored = checkpoint.scene;
    const auto given = identity(simulation);
    const auto value = [](const auto& keys, const std::string& key) {
        const auto found = keys.find(key);
        return found == keys.end() ? std::string("not given") : found->second;
    };
    auto all = stored;
    all.insert(given.begin(), given.end());
    for (const auto& [key, unused] : all) {
        if (value(stored, key) != value(given, key)) {
            throw SceneError(fmt::format("{} is of another scene: there {} is {}, here {}",
                                         path.string(), key, value(stored, key),
                                         value(given, key)));
        }
    }
    if (checkpoint.chain.steps > simulation.plan().steps) {
        throw SceneError(fmt::format("{} is at step {}, beyond time.end (step {})", path.string(),
                                     checkpoint.chain.steps, simulation.plan().steps));
    }
}

}  // namespace nmbcrun
