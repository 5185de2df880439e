// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/matched_layers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <vector>

namespace nmbcrun {
namespace {

std::string lack_of_lattice(const PlaneScene& scene) {
    if (scene.is_bond_based()) {
        return "a perfectly matched layer stretches the derivatives along its axis, and a bond of "
               "bond2d that leads along both has none: take passive sides or a sponge";
    }
    if (!scene.influence.empty()) {
        return "perfectly matched layers are for constant influence, not model.influence";
    }
    return scene.tau == 0 ? ""
                          : "model.damping must be 0 beside perfectly matched layers, which were "
                            "not made for it";
}

std::string lack_of_sides(const PlaneScene& scene) {
    constexpr std::array beside{SideKind::pml, SideKind::fixed, SideKind::extended,
                                SideKind::periodic, SideKind::sponge};
    std::map<SideKind, std::vector<std::string_view>> others;
    for (std::size_t i = 0; i < scene.sides.size(); ++i) {
        const SideKind kind = scene.sides[i].kind;
        if (std::ranges::find(beside, kind) == beside.end()) {
            others[kind].push_back(plane_side_names[i]);
        }
    }
    std::vector<std::string> listed;
    listed.reserve(others.size());
    for (const auto& [kind, sides] : others) {
        listed.push_back(fmt::format("\"{}\" ({})", name_of(kind), fmt::join(sides, ", ")));
    }
    return listed.empty() ? ""
                          : fmt::format(
                                "beside a perfectly matched layer there are pml, fixed, "
                                "extended, periodic and sponge sides, and none of kind {}",
                                fmt::join(listed, ", "));
}

}  // namespace

std::string lack_of_matched_layers(const PlaneScene& scene,
                                   const std::vector<std::string>& missing_keys) {
    if (!scene.has(SideKind::pml)) {
        return "";
    }
    std::vector<std::string> lacks{lack_of_lattice(scene), lack_of_sides(scene)};
    if (!missing_keys.empty()) {
        lacks.push_back(fmt::format("it needs {}, its nodes", fmt::join(missing_keys, " and ")));
    }
    std::erase(lacks, "");
    if (!lacks.empty() && !scene.allow_unstable) {
        lacks.emplace_back("it needs boundary.allow_unstable = true, as some such layers grow");
    }
    return fmt::format("{}", fmt::join(lacks, "; "));
}

}  // namespace nmbcrun
