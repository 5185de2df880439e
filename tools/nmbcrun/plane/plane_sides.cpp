// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nmbc/loss_layer.hpp>
#include <nmbc/plane_convex_kernel.hpp>
#include <nmbc/tables/tables.hpp>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "generator/closures/plane_summation_by_parts.hpp"
#include "generator/names/projected_family.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/plane/designed_side.hpp"
#include "tools/nmbcrun/plane/matched_layers.hpp"
#include "tools/nmbcrun/plane/plane_lattice.hpp"

namespace nmbcrun {
namespace {

/// (60) of this order for waves of each polarisation that meet the side head-on.
nmbc::MatchingSide matching_side_of(const PlaneScene& scene, const PlaneSideChoice& choice) {
    const nmbc::PlaneModel model = model_of(scene);
    if (scene.is_bond_based() && choice.order > 1) {
        throw SceneError("boundary.order above 1 needs a table, and there is none of bond2d");
    }
    if (!scene.influence.empty() && choice.order > 1) {
        throw SceneError(
            "boundary.order above 1 needs a table, and there is none with model.influence");
    }
    nmbc::MatchingSide side{
        .coefficients = {},
        .speeds = {model.speed_P(), choice.as_printed ? model.speed_P() : model.speed_S()}};
    for (const bool is_P : {true, false}) {
        nmbc::BoundaryCoefficients& coefficients = side.coefficients[is_P ? 0 : 1];
        if (choice.order == 1) {  // of any lattice
            coefficients = {.c = {1, 1}, .b = {-2, 2}, .stride = choice.stride};
            for (double& b : coefficients.b) {
                b /= choice.stride;
            }
            continue;
        }
        const nmbcgen::ProjectedFamily family{
            .family = "nopd2d",
            .model = {.radius_squared = scene.radius_squared,
                      .poisson = scene.nu,
                      .plane_strain = scene.state == nmbc::StressState::plane_strain},
            .polarisation = is_P ? nmbcgen::Polarisation::P : nmbcgen::Polarisation::S};
        const nmbc::MatchingTable* const table =
            nmbc::find_table(nmbc::generated::tables, nmbcgen::name_of(family),
                             int(model.horizon()), choice.order, choice.stride);
        if (table == nullptr) {
            throw SceneError(fmt::format(
                "there is no committed table of {}, order {}, stride {}: there are orders 1 and 2, "
                "the latter of stride n, at nu = 1/4 in plane stress and model.radius2 = 1, 4, 9",
                nmbcgen::name_of(family), choice.order, choice.stride));
        }
        coefficients =
            nmbc::boundary_coefficients(*table, scene.G / std::numbers::pi, nmbc::allow_unstable);
    }
    return side;
}

/// A factor for each wave, of its apparent speed across the side.
nmbc::HigdonSide higdon_side_of(const PlaneScene& scene, const PlaneSideChoice& choice) {
    const nmbc::PlaneModel model = model_of(scene);
    nmbc::HigdonSide side;
    for (const ObliqueWave& wave : choice.absorb) {
        side.speeds.push_back((wave.is_P ? model.speed_P() : model.speed_S()) /
                              std::cos(wave.degrees * std::numbers::pi / 180));
    }
    // Without decay a field that is linear in time satisfies a product, and roundings drift.
    constexpr double decay = 0.002;
    side.decay = choice.absorb.size() > 1 ? decay : 0;
    return side;
}

/// Of radius 1 gradients are those of a chain of n = 1 along each axis, and so their sums by parts:
/// half of the volume and mass on the surface, and products of these in the corners, as a passive
/// side has them, without dashpots. Others have a closure for all sides.
nmbc::PlaneSide sbp_side_of(const PlaneScene& scene) {
    if (scene.is_bond_based()) {
        throw SceneError(
            "a side of kind \"sbp\" is for nopd2d: of bonds, an even strain is not at rest in its "
            "corners. Take \"mirror\" where the body is symmetric, or \"free\", which is too soft");
    }
    if (scene.radius_squared == 1) {
        const std::vector<double> half{0.5};
        return nmbc::PassiveSide{.strain = half,
                                 .stabilisation = half,
                                 .mass = {half, half},
                                 .dashpots = {std::vector<double>{0}, std::vector<double>{0}}};
    }
    if (scene.radius_squared > nmbcgen::largest_closed_radius_squared) {
        throw SceneError(fmt::format("sides of kind \"sbp\" are for model.radius2 up to {}, not {}",
                                     nmbcgen::largest_closed_radius_squared, scene.radius_squared));
    }
    try {
        return nmbc::ClosedSide{std::make_shared<const nmbc::PlaneClosure>(
            nmbcgen::plane_summation_by_parts(nopd2d_of(scene)))};
    } catch (const std::domain_error& error) {
        throw SceneError(
            fmt::format("sides of kind \"sbp\" are not for this influence: {}", error.what()));
    }
}

nmbc::PlaneSide kernel_side_of(const PlaneScene& scene) {
    if (scene.is_bond_based()) {
        throw SceneError("a side of kind \"kernel\" is for nopd2d: bonds have no gradients");
    }
    try {
        return nmbc::ClosedSide{std::make_shared<const nmbc::PlaneClosure>(
            nmbc::convex_kernel_closure(nopd2d_of(scene)))};
    } catch (const std::invalid_argument& error) {
        throw SceneError(fmt::format(
            R"(a side of kind "kernel" needs model.influence = "spline": {})", error.what()));
    }
}

nmbc::SpongeSide sponge_side_of(const PlaneScene& scene, const PlaneSideChoice& choice) {
    const double speed = model_of(scene).speed_P();
    // Of steps of 2 dX sqrt(rho/E): gamma dt/2 is gamma then.
    std::vector<double> friction =
        nmbc::half_step_losses({choice.layer, choice.profile, choice.target}, 1,
                               {.youngs_modulus = speed * speed, .time_step = 2});
    friction.pop_back();
    std::ranges::reverse(friction);
    return {friction};
}

/// Beside a side that cuts the lattice off, the energy is a sum of squares where all weights are
/// above 0.
void require_proved(const PlaneScene& scene) {
    if (!scene.is_bond_based() || nmbc::is_positive(bonds_of(scene))) {
        return;
    }
    if (scene.has(SideKind::passive)) {
        throw Unstable(
            "a lattice with bond weights below 0 has no passive side: cut off there, its energy is "
            "no sum of squares and it may explode, whatever boundary.allow_unstable says. Take a "
            "set above 0 (nmbcgen bonds --positive), or sides of the kinds sponge, extended, fixed "
            "or "
            "periodic");
    }
    if (scene.has(SideKind::free) && !scene.allow_unstable) {
        throw Unstable(
            "this lattice has bond weights below 0: cut off by a free side, its energy is no sum "
            "of squares and it may explode. Take a set above 0 (nmbcgen bonds --positive), or run "
            "it all the same: boundary.allow_unstable = true");
    }
}

}  // namespace

SceneSides sides_of(const PlaneScene& scene, bool quiet) {
    if (const std::string lack = lack_of_matched_layers(scene); !lack.empty()) {
        throw SceneError(lack);
    }
    for (const PlaneSideChoice& side : scene.sides) {
        if (may_grow(side.kind) && !scene.allow_unstable) {
            const char* const known =
                side.kind == SideKind::pml
                    ? "such layers have no proof where their losses vary, and some grow: at G = 0 "
                      "with more than nearest neighbours, with profile 0, in plane strain near nu "
                      "= 1/2"
                    : "such sides amplify oblique waves of most lattices, and none is certified "
                      "with corners (nmbcgen recommend says what is known of this one, and which "
                      "model.damping ends it)";
            throw Unstable(
                fmt::format("{}: {}. Passive sides are stable by construction. To run it all the "
                            "same: boundary.allow_unstable = true",
                            heading_of(side), known));
        }
    }
    for (const PlaneSideChoice& side : scene.sides) {
        if (scene.fracture && side.kind == SideKind::mirror && side.is_odd) {
            throw SceneError(
                "beside an odd mirror no bonds break: the image of one that is pulled is pushed");
        }
    }
    SceneSides result;
    require_proved(scene);
    nmbc::PlaneSide closed;
    if (scene.has(SideKind::sbp) && scene.has(SideKind::kernel)) {
        throw SceneError(R"(beside sides of kind "sbp" there are none of kind "kernel")");
    }
    if (scene.has(SideKind::sbp)) {
        closed = sbp_side_of(scene);
    }
    if (scene.has(SideKind::kernel)) {
        closed = kernel_side_of(scene);
    }
    nmbc::PlaneSide passive;
    if (scene.has(SideKind::passive)) {  // last, as designs take seconds
        result.passive = designed_side_of(scene, quiet);
        passive = result.passive->side;
    }
    const auto side = [&](std::size_t number) -> nmbc::PlaneSide {
        switch (scene.sides[number].kind) {
            case SideKind::passive:
                return passive;
            case SideKind::free:
                return nmbc::FreeSide{};
            case SideKind::sbp:
            case SideKind::kernel:
                return closed;
            case SideKind::mirror:
                return nmbc::MirrorSide{scene.sides[number].is_odd};
            case SideKind::periodic:
                return nmbc::PeriodicSide{};
            case SideKind::nmbc:
                return matching_side_of(scene, scene.sides[number]);
            case SideKind::higdon:
                return higdon_side_of(scene, scene.sides[number]);
            case SideKind::sponge:
                return sponge_side_of(scene, scene.sides[number]);
            case SideKind::pml:
                return nmbc::SpongeSide{std::vector<double>(scene.sides[number].layer, 0)};
            case SideKind::fixed:
            case SideKind::extended:
                break;
        }
        return nmbc::FixedSide{};
    };
    result.all = {side(0), side(1), side(2), side(3)};
    return result;
}

}  // namespace nmbcrun
