// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/ends.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <memory>
#include <nmbc/coefficients.hpp>
#include <nmbc/ends.hpp>
#include <type_traits>

#include "tools/nmbcrun/ends/exact.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/tables.hpp"
#include "tools/nmbcrun/simulation/time_step.hpp"

namespace nmbcrun {

namespace {

/// An exact end for the steps of the scene's run, which the chain's own time step tells.
struct ExactEndOfRun {
    double end = 0;  ///< [time]

    std::unique_ptr<nmbc::EndCondition<double>> make(const nmbc::Lattice& lattice,
                                                     const nmbc::ChainParameters& parameters,
                                                     std::type_identity<double> precision) const {
        const std::size_t steps = steps_until(end, parameters.time_step);
        if (steps > ExactEnd::most_steps) {
            throw SceneError(
                fmt::format("a run of {} steps is too long for an \"exact\" end, which is made for "
                            "{} at most: take a longer time step, or kind \"extended\" with a "
                            "layer so wide that nothing returns",
                            steps, ExactEnd::most_steps));
        }
        return ExactEnd{steps}.make(lattice, parameters, precision);
    }
};

}  // namespace

bool takes_table(BoundaryKind kind) {
    return kind == BoundaryKind::nmbc;
}

bool adds_no_energy(BoundaryKind kind) {
    switch (kind) {
        case BoundaryKind::fixed:
        case BoundaryKind::free:
        case BoundaryKind::extended:
        case BoundaryKind::exact:
            return true;
        case BoundaryKind::nmbc:
            break;
    }
    return false;
}

nmbc::ChainEnd chain_end(const Scene& scene, const Boundary& boundary) {
    switch (boundary.kind) {
        case BoundaryKind::fixed:
            return nmbc::FixedEnd{};
        case BoundaryKind::free:
            return nmbc::FreeEnd{};
        case BoundaryKind::extended:
            return nmbc::FixedEnd{boundary.layer};
        case BoundaryKind::exact:
            return ExactEndOfRun{scene.end};
        case BoundaryKind::nmbc:
            break;
    }
    return nmbc::MatchingEnd{
        nmbc::boundary_coefficients(table_of(scene, boundary), scene.G, nmbc::allow_unstable),
        boundary.ghosts};
}

}  // namespace nmbcrun
