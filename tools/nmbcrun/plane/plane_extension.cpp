// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_extension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/plane/plane_lattice.hpp"

namespace nmbcrun {
namespace {

/// The largest group velocity of any wave [dX rate], on wave vectors in steps of pi/64.
double fastest_group(const nmbc::PlaneModel& model) {
    constexpr int steps = 64;
    const double spacing = std::numbers::pi / steps;
    double fastest = 0;
    for (const bool is_P : {true, false}) {
        const auto omega = [&](int x, int y) {
            return std::sqrt(
                nmbc::plane_wave(model, {spacing * x, spacing * y}, is_P).omega_squared);
        };
        for (int x = 0; x < steps; ++x) {
            for (int y = 0; y < steps; ++y) {
                const double here = omega(x, y);
                fastest = std::max(
                    fastest, std::hypot(omega(x + 1, y) - here, omega(x, y + 1) - here) / spacing);
            }
        }
    }
    return fastest;
}

/// So many that no wave has gone there and back again; what is faster than the fastest group is
/// below 1e-12 some nodes off.
std::size_t nodes_until_end(const PlaneScene& scene) {
    const nmbc::PlaneModel model = model_of(scene);
    const double far = fastest_group(model) * rate_of(scene) * scene.end / 2;
    constexpr std::size_t ahead = 20;
    return std::size_t(std::min(far, double(most_nodes))) + ahead * model.horizon();
}

/// In words, of so many nodes.
std::string too_many(const PlaneScene& scene, double nodes) {
    const bool is_open = has_open_layer(scene);
    if (scene.original && scene.original->ratio > 1) {
        return fmt::format(
            "the reference, the same body on nodes dX/{} apart, has {:.3g} nodes{}; at most {} are "
            "allowed",
            scene.original->ratio, nodes,
            is_open ? fmt::format(", with those in the place of artificial sides until time.end = "
                                  "{:g}",
                                  scene.end)
                    : "",
            most_nodes);
    }
    return fmt::format(
        "with the layers of its sides the plane has {:.3g} nodes; at most {} are "
        "allowed{}",
        nodes, most_nodes,
        is_open ? fmt::format(". Extended sides have as many as it takes until "
                              "time.end = {:g}, unless boundary.layer says how many",
                              scene.end)
                : "");
}

}  // namespace

std::array<std::size_t, 4> extension_of(const PlaneScene& scene) {
    std::array<std::size_t, 4> layers{};
    const std::size_t enough = has_open_layer(scene) ? nodes_until_end(scene) : 0;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (scene.sides[i].kind == SideKind::extended) {
            layers[i] = scene.sides[i].layer > 0 ? scene.sides[i].layer : enough;
        }
    }
    const auto along = [&](std::size_t axis) {
        auto nodes = double(scene.nodes[axis]);
        for (const std::size_t i : {2 * axis, 2 * axis + 1}) {
            nodes += double(layers[i]) +
                     (has_layer(scene.sides[i].kind) ? double(scene.sides[i].layer) : 0);
        }
        return nodes;
    };
    const double nodes = along(0) * along(1);
    if (nodes > double(most_nodes)) {
        throw SceneError(too_many(scene, nodes));
    }
    return layers;
}

void require_room(const PlaneScene& scene) {
    extension_of(scene);
}

}  // namespace nmbcrun
