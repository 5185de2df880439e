// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/plane_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/plane/plane_extension.hpp"
#include "tools/nmbcrun/plane/plane_initial.hpp"
#include "tools/nmbcrun/plane/plane_lattice.hpp"
#include "tools/nmbcrun/plane/plane_sides.hpp"
#include "tools/nmbcrun/simulation/memory.hpp"

namespace nmbcrun {
namespace {

/// Along x and y, those of extended sides included.
std::array<std::size_t, 2> extended_nodes(const PlaneScene& scene,
                                          const std::array<std::size_t, 4>& extension) {
    return {scene.nodes[0] + extension[0] + extension[1],
            scene.nodes[1] + extension[2] + extension[3]};
}

nmbc::Plane plane_of(const PlaneScene& scene, const nmbc::PlaneSides& sides,
                     const std::array<std::size_t, 2>& nodes, double time_step) {
    require_memory_of_plane(nodes, physical_memory());
    return {model_of(scene),
            sides,
            {.nx = nodes[0],
             .ny = nodes[1],
             .spacing = scene.spacing,
             .youngs_modulus = scene.youngs_modulus,
             .density = scene.density,
             .time_step = time_step}};
}

/// Of initial fields.
SceneError moves_nothing(const PlaneScene& scene) {
    if (scene.initial->shape == PlaneShape::file) {
        return SceneError(scene.initial->file.string() + " moves no node: it has no energy");
    }
    const double width = scene.initial->width;
    return SceneError(
        width > scene.spacing
            ? fmt::format("initial has no energy: its width is {:g}, and the body {:g} x {:g}",
                          width, scene.spacing * double(scene.nodes[0]),
                          scene.spacing * double(scene.nodes[1]))
            : fmt::format("initial moves no node: its width is {:g}, and nodes are {:g} apart",
                          width, scene.spacing));
}

bool is_at_rest(const nmbc::Plane& plane) {
    const auto is_zero = [](double entry) { return entry == 0; };
    return std::ranges::all_of(std::array<std::size_t, 2>{0, 1}, [&](std::size_t a) {
        return std::ranges::all_of(plane.displacement(a), is_zero) &&
               std::ranges::all_of(plane.velocity(a), is_zero);
    });
}

}  // namespace

PlaneSimulation::PlaneSimulation(const PlaneScene& scene, bool quiet)
    : PlaneSimulation(scene, sides_of(scene, quiet).all) {}

PlaneSimulation::PlaneSimulation(const PlaneScene& scene, const nmbc::PlaneSides& sides)
    : PlaneSimulation(scene, sides, extension_of(scene)) {}

PlaneSimulation::PlaneSimulation(PlaneScene scene, const nmbc::PlaneSides& sides,
                                 const std::array<std::size_t, 4>& extension)
    : scene_(std::move(scene)),
      extension_(extension),
      plan_(plan_of(scene_, sides, extended_nodes(scene_, extension_))),
      plane_(plane_of(scene_, sides, extended_nodes(scene_, extension_), plan_.time_step)),
      sources_(scene_, plane_, {extension_[0], extension_[2]}, plan_.time_step) {
    bool is_staggered = false;
    if (scene_.initial) {
        is_staggered = set_initial_fields(scene_, extension_, plane_);
        if (!is_staggered) {  // else it goes on as another run left it, and may be going out
            initial_at_sides_ = nmbcrun::initial_at_sides(scene_, extension_, plane_);
        }
    }
    cut();
    if (is_staggered) {
        plane_.start_staggered();
    } else {
        if (scene_.initial) {  // a body at rest begins to move when it is loaded
            if (is_at_rest(plane_)) {
                throw moves_nothing(scene_);
            }
            sources_.push(plane_, 0, -plan_.time_step / 2);
        }
        plane_.start();
    }
    if (scene_.has(SideKind::pml)) {
        std::array<nmbc::LossLayer, 4> layers;
        std::ranges::transform(scene_.sides, layers.begin(), [](const PlaneSideChoice& side) {
            return side.kind == SideKind::pml
                       ? nmbc::LossLayer{side.layer, side.profile, side.target}
                       : nmbc::LossLayer{};
        });
        pml_.emplace(std::get<nmbc::CorrespondenceModel>(plane_.model().law()), layers,
                     plane_.grid(), plane_.parameters());
    }
    let_break();
    sources_.start(plane_);
    at_start_ = plane_.energies().staggered;
    if (scene_.initial && at_start_ == 0) {
        throw moves_nothing(scene_);
    }
}

/// Among the nodes of the interior [dX].
nmbc::PlanePoint PlaneSimulation::node_at(double X, double Y) const {
    return {X / scene_.spacing - 1 + double(extension_[0]),
            Y / scene_.spacing - 1 + double(extension_[2])};
}

void PlaneSimulation::cut() {
    if (scene_.fracture) {
        for (const auto& [X1, Y1, X2, Y2] : scene_.fracture->cracks) {
            plane_.cut(node_at(X1, Y1), node_at(X2, Y2));
        }
    }
}

void PlaneSimulation::let_break() {
    const std::optional<double> stretch = critical_stretch(scene_);
    if (!stretch) {
        return;
    }
    const PlaneFracture& fracture = *scene_.fracture;
    constexpr double roundings = 1e-9;  // [dX]
    const auto is_outside = [&](std::size_t axis, std::ptrdiff_t node) {
        const auto& p = plane_.parameters();
        return node < 0 || node >= std::ptrdiff_t(axis == 0 ? p.nx : p.ny);
    };
    const auto is_kept = [&](std::ptrdiff_t x, std::ptrdiff_t y) {
        // Layers and ghosts of sides are no material: their stretches mean nothing.
        return is_outside(0, x) || is_outside(1, y) ||
               std::ranges::any_of(fracture.kept, [&](const std::array<double, 4>& rectangle) {
                   const nmbc::PlanePoint low = node_at(rectangle[0], rectangle[1]);
                   const nmbc::PlanePoint high = node_at(rectangle[2], rectangle[3]);
                   const nmbc::PlanePoint here{double(x), double(y)};
                   return here[0] >= low[0] - roundings && here[0] <= high[0] + roundings &&
                          here[1] >= low[1] - roundings && here[1] <= high[1] + roundings;
               });
    };
    if (fracture.allow_unstable) {
        plane_.break_above(*stretch, is_kept, nmbc::allow_unstable);
        return;
    }
    try {
        plane_.break_above(*stretch, is_kept);
    } catch (const std::invalid_argument& error) {
        throw Unstable(
            fmt::format("fracture: {}. Take a set above 0 (nmbcgen bonds --positive), or "
                        "run it all the same: fracture.allow_unstable = true",
                        error.what()));
    }
}

void PlaneSimulation::advance(std::size_t steps) {
    const auto prescribe = [this](nmbc::Plane& plane, double time) {
        if (pml_) {
            pml_->kick({plane.displacement(0), plane.displacement(1)},
                       {plane.velocity(0), plane.velocity(1)});
        }
        sources_(plane, time);
    };
    plane_.advance(steps, prescribe);
}

std::array<std::ptrdiff_t, 4> PlaneSimulation::range_of_body() const {
    const PlaneBody whole = body();
    const auto first = [&](std::size_t axis) {
        return std::ptrdiff_t(extension_[2 * axis]) - std::ptrdiff_t(whole.before[axis]);
    };
    return {first(0), first(0) + std::ptrdiff_t(whole.nodes[0]), first(1),
            first(1) + std::ptrdiff_t(whole.nodes[1])};
}

nmbc::PlaneEnergies PlaneSimulation::energies() const {
    const auto [first_x, last_x, first_y, last_y] = range_of_body();
    return plane_.energies(first_x, last_x, first_y, last_y);
}

std::vector<double> PlaneSimulation::energy_density() const {
    const auto [first_x, last_x, first_y, last_y] = range_of_body();
    std::vector<double> density = plane_.energies_of_nodes(first_x, last_x, first_y, last_y);
    std::size_t node = 0;
    for (std::ptrdiff_t y = first_y; y < last_y; ++y) {
        for (std::ptrdiff_t x = first_x; x < last_x; ++x) {
            density[node++] /= plane_.volume(x, y) * scene_.spacing * scene_.spacing;
        }
    }
    return density;
}

double PlaneSimulation::times_supplied() const {
    return plane_.energies().staggered / (at_start_ + std::max(0.0, sources_.work()));
}

double PlaneSimulation::largest_strain() const {
    if (scene_.fracture) {
        return HeldBonds(scene_, plane_).largest_strain();
    }
    double largest = 0;
    const auto look = [&](std::size_t x, std::size_t y, std::size_t beside_x,
                          std::size_t beside_y) {
        if (beside_x >= scene_.nodes[0] || beside_y >= scene_.nodes[1]) {
            return;
        }
        for (const std::size_t a : {0U, 1U}) {
            const auto u = plane_.displacement(a);
            largest = std::max(largest, std::abs(u[entry(beside_x, beside_y)] - u[entry(x, y)]));
        }
    };
    for (std::size_t y = 0; y < scene_.nodes[1]; ++y) {
        for (std::size_t x = 0; x < scene_.nodes[0]; ++x) {
            look(x, y, x + 1, y);
            look(x, y, x, y + 1);
        }
    }
    return largest / scene_.spacing;
}

PlaneBalance PlaneSimulation::balance() const {
    PlaneBalance balance{.energy = plane_.energies().staggered,
                         .work = sources_.work(),
                         .left = plane_.left(),
                         .drift = 0};
    double left = 0;
    for (std::size_t i = 0; i < balance.left.size(); ++i) {
        if (may_grow(scene_.sides[i].kind)) {
            balance.left[i] = std::numeric_limits<double>::quiet_NaN();
        }
        left += balance.left[i];
    }
    balance.fracture = scene_.is_bond_based() ? plane_.released() : 0;
    balance.damped = plane_.damped();
    balance.drift =
        balance.energy - (at_start_ + balance.work - left - balance.fracture - balance.damped);
    return balance;
}

std::vector<std::vector<double>> PlaneSimulation::state() const {
    nmbc::PlaneState<double> plane = plane_.state();
    return {std::move(plane.displacement[0]),
            std::move(plane.displacement[1]),
            std::move(plane.velocity[0]),
            std::move(plane.velocity[1]),
            std::move(plane.ghosts),
            {plane.gone.begin(), plane.gone.end()},
            {sources_.work(), at_start_},
            {plane.bonds.begin(), plane.bonds.end()},
            {plane.broken, plane.released, plane.damped},
            pml_ ? std::vector<double>{pml_->memory().begin(), pml_->memory().end()}
                 : std::vector<double>{}};
}

void PlaneSimulation::resume(std::size_t steps, const std::vector<std::vector<double>>& state) {
    if (state.size() != 10 || state[5].size() != 4 || state[6].size() != 2 ||
        state[8].size() != 3) {
        throw FileError("the checkpoint is none of a plane");
    }
    try {
        plane_.resume({.steps = steps,
                       .displacement = {state[0], state[1]},
                       .velocity = {state[2], state[3]},
                       .ghosts = state[4],
                       .gone = {state[5][0], state[5][1], state[5][2], state[5][3]},
                       .bonds = {state[7].begin(), state[7].end()},
                       .broken = state[8][0],
                       .released = state[8][1],
                       .damped = state[8][2]});
    } catch (const std::invalid_argument& error) {
        throw FileError(fmt::format("the checkpoint is {}", error.what()));
    }
    if (state[9].size() != (pml_ ? pml_->memory().size() : 0)) {
        throw FileError("the checkpoint is one of other layers");
    }
    if (pml_) {
        pml_->remember(state[9]);
    }
    at_start_ = state[6][1];
    sources_.start(plane_, state[6][0]);
}

}  // namespace nmbcrun
