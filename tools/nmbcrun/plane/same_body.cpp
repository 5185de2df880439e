// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/same_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/plane/plane_extension.hpp"
#include "tools/nmbcrun/plane/plane_sides.hpp"

namespace nmbcrun {
namespace {

/// How far beyond the scene's outermost nodes the body ends [dX]; lines: that the side adds.
double beyond(SideKind kind, std::size_t lines, bool is_low) {
    switch (kind) {
        case SideKind::sbp:
        case SideKind::kernel:
            return double(lines);
        case SideKind::free:
        case SideKind::mirror:
            return 0.5;
        case SideKind::periodic:  // from the opposite side's outermost nodes to these
            return is_low ? 1 : 0;
        default:
            return 1;
    }
}

/// Throws SceneError of what no other lattice has.
void require_for_any_lattice(const PlaneScene& scene) {
    const bool is_asked_for = std::ranges::any_of(
        scene.sides, [](const PlaneSideChoice& side) { return is_artificial(side.kind); });
    const char* const compared = is_asked_for ? "--finer compares with a finer lattice"
                                              : "physical sides are compared with a finer lattice";
    if (scene.fracture) {
        throw SceneError(fmt::format(
            "{}, and there is none of a scene with a table fracture: where bonds break "
            "depends on dX. Compare runs of several domain.spacing, or {}",
            compared,
            is_asked_for ? "artificial sides alone, without --finer" : "artificial sides"));
    }
    if (scene.initial && scene.initial->shape == PlaneShape::file) {
        throw SceneError(
            fmt::format("{}, and initial.file has u at the nodes of this one only: take another "
                        "initial.shape, or start by a force or a load",
                        compared));
    }
    for (const PlaneLoad& load : scene.loads) {
        if (!load.side || load.is_traction) {
            continue;
        }
        const SideKind beside = scene.sides[*load.side].kind;
        if (load.given == Given::force) {
            throw SceneError(fmt::format(
                "{}, where {} acts on a thinner line of nodes, as a force/volume of a side: take a "
                "traction, or a rectangle",
                compared, load.name));
        }
        if (!ends_body(beside)) {
            throw SceneError(fmt::format(
                "{}, whose outermost nodes at a side of kind \"{}\" are others than those that {} "
                "moves: take a rectangle",
                compared, name_of(beside), load.name));
        }
    }
}

std::array<double, 4> ends_of(const PlaneScene& scene, const std::array<std::size_t, 4>& lines) {
    std::array<double, 4> ends{};
    for (std::size_t i = 0; i < ends.size(); ++i) {
        ends[i] = beyond(scene.sides[i].kind, lines[i], i % 2 == 0);
    }
    return ends;
}

std::array<std::size_t, 4> lines_of(const nmbc::PlaneSides& sides, std::size_t horizon) {
    std::array<std::size_t, 4> lines{};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        lines[i] = nmbc::detail::own_layers(sides.at(nmbc::plane_sides[i])) + horizon;
    }
    return lines;
}

/// The scene's nodes along an axis where the body is so long [dX of the original] and its sides
/// take so much of it [dX of the scene]. Throws SceneError where there are no such.
std::size_t nodes_along(const PlaneScene& scene, std::size_t axis, double length,
                        const std::array<double, 4>& ends) {
    const std::size_t low = 2 * axis;
    const std::size_t high = low + 1;
    const std::size_t ratio = scene.original->ratio;
    const double nodes = double(ratio) * length - ends[low] - ends[high] + 1;
    const std::string body =
        fmt::format("the body is {:g} dX long along {}", length, axis == 0 ? 'x' : 'y');
    if (nodes != std::floor(nodes)) {
        throw SceneError(fmt::format(
            "{}, which nodes {:g} apart do not fill between sides of the kinds {} and {}", body,
            scene.spacing, name_of(scene.sides[low].kind), name_of(scene.sides[high].kind)));
    }
    if (nodes < 1) {  // so one of them has lines of its own
        const std::size_t thick = ends[low] > ends[high] ? low : high;
        throw SceneError(fmt::format("{}, too thin {} {} sides have {:g} lines each", body,
                                     ratio > 1 ? "for the reference, whose" : "where",
                                     name_of(scene.sides[thick].kind), ends[thick]));
    }
    return std::size_t(nodes);
}

/// Where the sources act is said in nodes of the original; the field begins in places.
void move_start(PlaneScene& scene) {
    if (!scene.initial) {
        return;
    }
    const PlaneOriginal& from = *scene.original;
    const double dX = from.scene->spacing;
    for (const std::size_t axis : {0U, 1U}) {
        scene.initial->centre[axis] += scene.spacing - dX * (1 + from.first[axis]);
    }
    scene.initial->wave_number /= double(from.ratio);
}

std::array<double, 2> first_of(const PlaneScene& scene) {
    return scene.original ? scene.original->first : std::array<double, 2>{};
}
std::size_t ratio_of(const PlaneScene& scene) {
    return scene.original ? scene.original->ratio : 1;
}

}  // namespace

SameBody same_body(const PlaneScene& original, const nmbc::PlaneSides& own,
                   const std::array<PlaneSideChoice, 4>& sides, std::size_t ratio) {
    require_for_any_lattice(original);
    SameBody same{.scene = original, .sides = {}};
    PlaneScene& scene = same.scene;
    scene.sides = sides;
    scene.spacing = original.spacing / double(ratio);
    scene.step.reset();
    scene.cfl.reset();
    scene.probes.clear();
    same.sides = sides_of(scene, true).all;
    const std::size_t horizon = nmbc::horizon_of(original.radius_squared);
    const auto before = ends_of(original, lines_of(own, horizon));
    const auto after = ends_of(scene, lines_of(same.sides, horizon));
    scene.original = {.scene = std::make_shared<const PlaneScene>(original), .ratio = ratio};
    for (const std::size_t axis : {0U, 1U}) {
        const std::size_t low = 2 * axis;
        const double length = double(original.nodes[axis]) - 1 + before[low] + before[low + 1];
        scene.nodes[axis] = nodes_along(scene, axis, length, after);
        scene.original->first[axis] = after[low] / double(ratio) - before[low];
    }
    require_room(scene);
    move_start(scene);
    for (PlaneLoad& load : scene.loads) {
        load.amplitude *= load.is_traction ? double(ratio) : 1;  // of a whole cell
    }
    return same;
}

CommonNodes::CommonNodes(const PlaneSimulation& one, const PlaneSimulation& other)
    : stride_(ratio_of(other.scene()) / ratio_of(one.scene())) {
    const auto own = first_of(one.scene());
    const auto others = first_of(other.scene());
    for (const std::size_t axis : {0U, 1U}) {
        const double place = double(ratio_of(other.scene())) * (own[axis] - others[axis]);
        const double whole = std::round(place);
        constexpr double roundings = 1e-6;
        if (std::abs(place - whole) > roundings) {
            throw SceneError("its nodes lie midway between those of the reference");
        }
        first_[axis] = std::ptrdiff_t(whole);
    }
}

CommonNodes::Difference CommonNodes::between(const PlaneSimulation& one,
                                             const PlaneSimulation& other) const {
    const PlaneBody body = one.body();
    const auto stride = std::ptrdiff_t(stride_);
    Difference found;
    for (std::size_t j = 0; j < body.nodes[1]; ++j) {
        const std::ptrdiff_t y = std::ptrdiff_t(j) - std::ptrdiff_t(body.before[1]);
        for (std::size_t i = 0; i < body.nodes[0]; ++i) {
            const std::ptrdiff_t x = std::ptrdiff_t(i) - std::ptrdiff_t(body.before[0]);
            const std::size_t here = one.entry(std::size_t(x), std::size_t(y));
            const std::size_t there = other.entry(std::size_t(first_[0] + stride * x),
                                                  std::size_t(first_[1] + stride * y));
            for (const std::size_t a : {0U, 1U}) {
                const double u = other.plane().displacement(a)[there];
                const double difference = std::abs(one.plane().displacement(a)[here] - u);
                found.other = std::max(found.other, std::abs(u));
                // Once it is not a number it stays so.
                if (!(difference <= found.largest) && !std::isnan(found.largest)) {
                    found.largest = difference;
                    found.node = {x + 1, y + 1};
                }
            }
        }
    }
    return found;
}

}  // namespace nmbcrun
