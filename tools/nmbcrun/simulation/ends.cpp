// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/ends.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <nmbc/coefficients.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/surface.hpp>
#include <type_traits>

#include "tools/nmbcrun/certification/half_space.hpp"
#include "tools/nmbcrun/certification/stand_ins.hpp"
#include "tools/nmbcrun/ends/exact.hpp"
#include "tools/nmbcrun/ends/higdon.hpp"
#include "tools/nmbcrun/ends/passive_design.hpp"
#include "tools/nmbcrun/ends/pml.hpp"
#include "tools/nmbcrun/ends/silent_layer.hpp"
#include "tools/nmbcrun/ends/sponge.hpp"
#include "tools/nmbcrun/ends/truncated.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/scene/step_plan.hpp"
#include "tools/nmbcrun/sources/force_in_time.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {

namespace {

/// An end for the steps of the scene's run, which the chain's own time step tells: exact, or
/// extended so wide that nothing returns.
struct EndOfRun {
    bool is_exact = false;
    double end = 0;  ///< [time]

    std::unique_ptr<nmbc::BoundaryCondition<double>> make(
        const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
        std::type_identity<double> precision) const {
        if (is_exact) {
            const std::size_t steps = steps_until(end, parameters.time_step);
            if (steps > ExactEnd::most_steps) {
                throw SceneError(fmt::format(
                    "a run of {} steps is too long for an \"exact\" end, which is made for {} at "
                    "most: take a longer time step, or kind \"extended\" with a layer so wide that "
                    "nothing returns",
                    steps, ExactEnd::most_steps));
            }
            return ExactEnd{steps}.make(lattice, parameters, precision);
        }
        const double unit = parameters.spacing / parameters.wave_speed();
        const std::size_t layer = silent_layer(lattice, parameters.time_step / unit, end / unit);
        if (layer > most_layer) {
            throw SceneError(
                fmt::format("nothing would return from {} nodes beyond the end, and {} "
                            "are allowed: give boundary.layer, or another kind",
                            layer, most_layer));
        }
        return nmbc::FixedEnd{layer}.make(lattice, parameters, precision);
    }
};

nmbc::SurfaceEnd surface_of(const Scene& scene, const Boundary& boundary) {
    if (boundary.kind == BoundaryKind::snm && scene.family.starts_with("nopd")) {
        throw SceneError(
            fmt::format("a surface node ends chains of bonds, such as bond1d, and model.family is "
                        "{}: take \"mirror\"",
                        scene.family));
    }
    if (ends_on_node(closure_of(boundary.kind)) && scene.preload) {
        throw SceneError(fmt::format(
            R"(preload is not known beside an end of kind "{}": take "mirror", or give a traction)",
            name_of(boundary.kind)));
    }
    nmbc::SurfaceEnd surface{closure_of(boundary.kind), boundary.given, {}};
    if (boundary.value) {
        surface.value = [history = value_in_time(*boundary.value)](double time) {
            return history.at(time);
        };
    }
    return surface;
}

nmbc::BoundaryCoefficients coefficients_of(const Scene& scene, const Boundary& boundary) {
    return nmbc::boundary_coefficients(table_of(scene, boundary), scene.G, nmbc::allow_unstable);
}

}  // namespace

std::size_t most_steps(BoundaryKind kind) {
    return kind == BoundaryKind::exact ? ExactEnd::most_steps
                                       : std::numeric_limits<std::size_t>::max();
}

void require_no_pole(const Scene& scene, const Boundary& boundary) {
    if (!takes_table(boundary.kind)) {
        return;
    }
    const nmbc::MatchingTable& table = table_of(scene, boundary);
    if (has_pole_next_to(table, scene.G)) {
        const std::string choices = choices_in_place(scene);
        throw nmbc::CoefficientError(fmt::format(
            "{} does not exist here: {} has a pole of a coefficient at G = {}{}{}",
            heading_of(boundary), table.name, scene.G, choices.empty() ? "" : ".\n", choices));
    }
}

nmbc::ChainEnd chain_end(const Scene& scene, const Boundary& boundary) {
    switch (boundary.kind) {
        case BoundaryKind::fixed:
            return nmbc::FixedEnd{};
        case BoundaryKind::free:
            return nmbc::FreeEnd{};
        case BoundaryKind::mirror:
        case BoundaryKind::snm:
        case BoundaryKind::sbp:
        case BoundaryKind::kernel:
        case BoundaryKind::cut:
        case BoundaryKind::node_mirror:
            return surface_of(scene, boundary);
        case BoundaryKind::extended:
            return boundary.layer > 0 ? nmbc::ChainEnd(nmbc::FixedEnd{boundary.layer})
                                      : nmbc::ChainEnd(EndOfRun{false, scene.end});
        case BoundaryKind::exact:
            return EndOfRun{true, scene.end};
        case BoundaryKind::sponge:
            return SpongeEnd{{boundary.layer, boundary.profile, target_of(boundary)}};
        case BoundaryKind::pml:
            return PmlEnd{{boundary.layer, boundary.profile, target_of(boundary)}};
        case BoundaryKind::passive:
            return DesignedEnd{};
        case BoundaryKind::higdon:
            return HigdonEnd{boundary.order};
        case BoundaryKind::truncated:
            return TruncatedEnd{coefficients_of(scene, boundary), boundary.ghosts};
        case BoundaryKind::nmbc:
            break;
    }
    return nmbc::MatchingEnd{coefficients_of(scene, boundary), boundary.ghosts};
}

}  // namespace nmbcrun
