// SPDX-License-Identifier: GPL-2.0-or-later
/// Scenes that advice is asked for, and what it picks.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "tools/nmbcrun/advise/candidates.hpp"
#include "tools/nmbcrun/scene/scene.hpp"

namespace advised_scenes {

using nmbcrun::Candidate;
using nmbcrun::Scene;

inline Scene scene_of(int horizon, double G, std::size_t nodes, double end) {
    Scene scene;
    scene.horizon = horizon;
    scene.G = G;
    scene.nodes = nodes;
    scene.end = end;
    return scene;
}

inline Scene with_pulse(Scene scene, nmbcrun::Shape shape, double width, double wave_number = 0) {
    scene.initial = nmbcrun::Initial{
        .kind = nmbcrun::InitialKind::displacement,
        .pulse = {.shape = shape, .amplitude = 1, .width = width, .wave_number = wave_number},
        .centre = double(scene.nodes) / 2,
        .file = {}};
    return scene;
}

inline Scene with_drive(Scene scene, double duration) {
    scene.drive = nmbcrun::Drive{
        .amplitude = 1, .duration = duration, .centre = double(scene.nodes) / 2, .half_width = 2};
    return scene;
}

/// The smallest one, where ends without any error are left out. size(candidate):
/// what is least of it.
template <class Size>
Candidate best_boundary(std::vector<Candidate> candidates, Size size) {
    std::erase_if(candidates, [](const Candidate& one) {
        return one.boundary.kind == nmbcrun::BoundaryKind::extended ||
               one.boundary.kind == nmbcrun::BoundaryKind::exact;
    });
    REQUIRE(!candidates.empty());
    return *std::ranges::min_element(candidates, {}, size);
}

}  // namespace advised_scenes
