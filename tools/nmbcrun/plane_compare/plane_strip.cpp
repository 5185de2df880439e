// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane_compare/plane_strip.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace nmbcrun {
namespace {

/// Whether a rectangle has all nodes along an axis.
bool spans(const PlaneScene& scene, std::size_t axis, double centre, double half_width) {
    const auto has = [&](double node) {
        return std::abs(node * scene.spacing - centre) <= half_width;
    };
    return has(1) && has(double(scene.nodes[axis]));
}

bool is_uniform(const PlaneScene& scene, std::size_t axis) {
    if (scene.sides[2 * axis].kind != SideKind::periodic || scene.initial || scene.force ||
        scene.fracture) {
        return false;
    }
    const bool drive_spans = !scene.drive || spans(scene, axis, scene.drive->centre[axis],
                                                   scene.drive->half_width[axis]);
    return drive_spans && std::ranges::all_of(scene.loads, [&](const PlaneLoad& load) {
               return load.side ? *load.side / 2 != axis
                                : spans(scene, axis, load.centre[axis], load.half_width[axis]);
           });
}

}  // namespace

std::optional<PlaneStrip> strip_of(const PlaneScene& scene) {
    for (const std::size_t axis : {0U, 1U}) {
        const std::size_t width =
            scene.is_bond_based() ? nmbc::horizon_of(scene.radius_squared) : 1;
        if (!is_uniform(scene, axis) || scene.nodes[axis] <= width) {
            continue;
        }
        PlaneStrip strip{.scene = scene, .axis = axis};
        PlaneScene& thin = strip.scene;
        thin.nodes[axis] = width;
        strip.settings = fmt::format("--set 'domain.nodes=[{}, {}]'", thin.nodes[0], thin.nodes[1]);
        const double middle = double(width + 1) / 2 * scene.spacing;
        const auto place = [&](const std::string& table, std::array<double, 2>& centre) {
            centre[axis] = middle;
            strip.settings +=
                fmt::format(" --set '{}.centre=[{}, {}]'", table, centre[0], centre[1]);
        };
        if (thin.drive) {
            place("drive", thin.drive->centre);
        }
        for (PlaneLoad& load : thin.loads) {
            if (!load.side) {
                place(load.name, load.centre);
            }
        }
        std::vector<std::string> probes;
        for (auto& probe : thin.probes) {
            probe[axis] = 0;
            const auto [X, Y] = position_of(thin, probe[0], probe[1]);
            probes.push_back(fmt::format("[{}, {}]", X, Y));
        }
        if (!probes.empty()) {
            strip.settings += fmt::format(" --set 'output.probes=[{}]'", fmt::join(probes, ", "));
        }
        return strip;
    }
    return std::nullopt;
}

}  // namespace nmbcrun
