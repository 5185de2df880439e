// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/any_scene.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "generator/names/printable.hpp"
#include "tools/nmbcrun/scene/scene_reader.hpp"

namespace nmbcrun {
namespace {

/// With `_` in place of what the name of output files must not have: it is quoted for gnuplot and
/// in XML, printed, and neither hidden nor a way out of the folder.
std::string plain_name(std::string name) {
    char before = '.';  // so that there is none at the start
    for (char& c : name) {
        if (std::iscntrl(static_cast<unsigned char>(c)) != 0 ||
            std::string_view("/\"'&<>").find(c) != std::string_view::npos ||
            (c == '.' && before == '.')) {
            c = '_';
        }
        before = c;
    }
    return name;
}

}  // namespace

std::string warning_of_short_run(const AnyScene& scene) {
    const double way = scene.end / unit_of_time(scene);
    return way < 1 ? fmt::format(
                         "in time.end waves travel {:.1g} dX: do the units of material, "
                         "domain and time belong together?",
                         way)
                   : "";
}

void read_title(SceneReader& reader, const std::string& path, AnyScene& scene) {
    const auto name = reader.text("output.name");
    if (name && (name->empty() || plain_name(*name) != *name)) {
        reader.fail("output.name",
                    "must be a file name without a folder, a dot at its start, '..', control "
                    "characters and \" ' & < >");
    }
    scene.name = name.value_or(plain_name(std::filesystem::path(path).stem().string()));
    scene.title = nmbcgen::printable(reader.text("title").value_or(scene.name));
}

void read_material(SceneReader& reader, AnyScene& scene) {
    const auto density = reader.number("material.density", positive);
    const auto youngs_modulus = reader.number("material.youngs_modulus", positive);
    if (density.has_value() != youngs_modulus.has_value()) {  // in SI units 1 would be far off
        reader.missing(density ? "material.youngs_modulus" : "material.density",
                       "both are given, or neither, which makes them 1");
    }
    scene.density = density.value_or(scene.density);
    scene.youngs_modulus = youngs_modulus.value_or(scene.youngs_modulus);
    const double c = std::sqrt(scene.youngs_modulus / scene.density);
    constexpr double fastest = 1e150;
    if (!(c >= 1 / fastest && c <= fastest)) {
        reader.fail("material",
                    fmt::format("makes the wave speed sqrt(youngs_modulus / density) {:g}; it must "
                                "be from {:g} to {:g}",
                                c, 1 / fastest, fastest));
    }
}

void read_output(SceneReader& reader, AnyScene& scene) {
    scene.every =
        std::size_t(reader.whole_number("output.every", 1, most_nodes).value_or(long(scene.every)));
    scene.field = reader.truth("output.field").value_or(scene.field);
    scene.snapshots =
        std::size_t(reader.whole_number("output.snapshots", 1, most_nodes).value_or(0));
    scene.checkpoint = reader.number("output.checkpoint", positive).value_or(scene.checkpoint);
}

void read_step(SceneReader& reader, AnyScene& scene) {
    scene.step = reader.number("time.step", positive);
    scene.cfl = reader.number("time.cfl", positive);
    scene.given = reader.given();
    reader.refuse_unknown_keys();
    auto& step = scene.step;
    auto& cfl = scene.cfl;
    if (step && cfl && reader.is_overridden("time.step") != reader.is_overridden("time.cfl")) {
        (reader.is_overridden("time.cfl") ? step : cfl).reset();
    }
    if (step && cfl) {
        reader.fail("time", "has both step and cfl; at most one of them is allowed");
    }
}

}  // namespace nmbcrun
