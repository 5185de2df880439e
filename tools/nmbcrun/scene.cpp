// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene.hpp"

#include <filesystem>

#include "tools/nmbcrun/scene_reader.hpp"

namespace nmbcrun {
namespace {

constexpr long most_nodes = 100'000'000;

nmbc::GhostRule read_ghosts(SceneReader& reader) {
    const std::string rule = reader.text("boundary.ghosts").value_or("midpoint");
    if (rule != "midpoint" && rule != "explicit") {
        reader.fail("boundary.ghosts", R"(must be "midpoint" or "explicit", not ")" + rule + '"');
    }
    return rule == "midpoint" ? nmbc::GhostRule::midpoint : nmbc::GhostRule::explicit_rule;
}

/// The name of the output files: the scene file's own unless it says another.
std::string read_name(SceneReader& reader, const std::string& path) {
    const auto name = reader.text("output.name");
    if (name && (name->empty() || name->find('/') != std::string::npos)) {
        reader.fail("output.name", "must be a file name without a folder or an ending");
    }
    return name.value_or(std::filesystem::path(path).stem().string());
}

Drive read_drive(SceneReader& reader) {
    Drive drive;
    drive.amplitude =
        reader.required("drive.amplitude", reader.number("drive.amplitude", any_number));
    if (drive.amplitude == 0) {
        reader.fail("drive.amplitude", "must not be 0");
    }
    drive.duration = reader.required("drive.duration", reader.number("drive.duration", positive));
    drive.centre = reader.required("drive.centre", reader.number("drive.centre", any_number));
    drive.half_width = reader.number("drive.half_width", not_negative).value_or(drive.half_width);
    return drive;
}

}  // namespace

Scene read_scene(const std::string& path, const Overrides& overrides) {
    SceneReader reader(path, overrides);
    Scene scene;
    scene.name = read_name(reader, path);
    scene.title = reader.text("title").value_or(scene.name);
    scene.family = reader.text("model.family").value_or(scene.family);
    scene.horizon =
        int(reader.required("model.horizon", reader.whole_number("model.horizon", 1, 1000)));
    scene.G = reader.number("model.G", not_negative).value_or(scene.G);
    scene.density = reader.number("material.density", positive).value_or(scene.density);
    scene.youngs_modulus =
        reader.number("material.youngs_modulus", positive).value_or(scene.youngs_modulus);
    scene.nodes = std::size_t(
        reader.required("domain.nodes", reader.whole_number("domain.nodes", 1, most_nodes)));
    scene.spacing = reader.number("domain.spacing", positive).value_or(scene.spacing);
    scene.extension =
        std::size_t(reader.whole_number("domain.extension", 0, most_nodes).value_or(0));
    scene.drive = read_drive(reader);
    scene.order = int(reader.whole_number("boundary.order", 1, 1000).value_or(scene.order));
    scene.stride = int(reader.whole_number("boundary.stride", 1, 1000).value_or(scene.stride));
    scene.ghosts = read_ghosts(reader);
    scene.end = reader.required("time.end", reader.number("time.end", positive));
    scene.step = reader.number("time.step", positive);
    scene.cfl = reader.number("time.cfl", positive);
    scene.every =
        std::size_t(reader.whole_number("output.every", 1, most_nodes).value_or(long(scene.every)));
    reader.refuse_unknown_keys();
    // An override of one replaces the other of the file.
    if (scene.step && scene.cfl &&
        reader.is_overridden("time.step") != reader.is_overridden("time.cfl")) {
        (reader.is_overridden("time.cfl") ? scene.step : scene.cfl).reset();
    }
    if (scene.step.has_value() == scene.cfl.has_value()) {
        reader.fail("time", scene.cfl ? "has both step and cfl; one of them is needed"
                                      : "has neither step nor cfl; one of them is needed");
    }
    return scene;
}

}  // namespace nmbcrun
