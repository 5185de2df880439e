// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <nmbc/lattice.hpp>
#include <utility>

#include "tools/nmbcrun/advise/search.hpp"
#include "tools/nmbcrun/advise/stabilisations.hpp"
#include "tools/nmbcrun/certification/time_step.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

const LeftOut layers{"sponge, pml",
                     "a layer takes nodes and steps of its own: where a ghost rule will not "
                     "do, \"extended\" and \"exact\" have no error at all"};
const LeftOut without_certificate{"higdon, truncated", "not certified to be stable"};

/// One horizon of a scene that leaves its lattice open.
struct OfHorizon {
    std::vector<Candidate> meet;
    std::string why_none;
};

/// What a run's interior multiplies, for each node.
double work_of(const Candidate& candidate) {
    return double(candidate.steps) * (4 * candidate.horizon + 1);
}

/// In words, where the steps that the scene gives are too long for its lattice or a true end; empty
/// where they are not, or it gives none.
std::string objection_to_given_steps(const Scene& scene) {
    if (!scene.step && !scene.cfl) {
        return "";
    }
    const nmbc::Lattice lattice = lattice_of(scene);
    const double given =
        scene.step ? *scene.step : 2 * *scene.cfl / highest_frequency(scene, lattice);
    return objection_to_steps(scene, lattice, given, surface_limits(scene, lattice), OfEnds::any);
}

/// least_work: of the candidates so far, but those whose ends cost as much as an interior.
OfHorizon candidates_of(const Scene& scene, int horizon, double tolerance, double& least_work,
                        const Pause& pause) {
    constexpr double far_dearer = 4;  // twice as much is told from as much by measuring it
    const Scene of_horizon = with_lattice(scene, horizon, scene.G);
    const auto stabilisations = scene.auto_G ? stabilisations_to_try(of_horizon, pause)
                                             : std::vector{Stabilisation{scene.G, 0}};
    OfHorizon result;
    bool interior_meets = false;
    double least_error = std::numeric_limits<double>::infinity();
    double best_G = 0;
    for (const auto& [G, cfl] : stabilisations) {
        const Scene settled = with_lattice(scene, horizon, G);
        if (const std::string objection = objection_to_given_steps(settled); !objection.empty()) {
            result.why_none = objection;
            continue;
        }
        Search search(
            settled, tolerance, Reference::continuum, pause,
            {.favoured_cfl = cfl, .most_steps = far_dearer * least_work / (4 * horizon + 1)});
        for (Candidate& one : search.all().meet) {
            if (one.boundary.kind != BoundaryKind::exact &&
                one.boundary.kind != BoundaryKind::extended) {
                least_work = std::min(least_work, work_of(one));
            }
            result.meet.push_back(std::move(one));
        }
        interior_meets = interior_meets || search.interior_meets();
        const double least = search.interior_meets() ? tolerance : search.least_interior_error();
        if (least < least_error) {
            least_error = least;
            best_G = G;
        }
    }
    if (interior_meets) {
        result.why_none = fmt::format(
            "no end meets it, or in four times the work at least, such as at G = {}", best_G);
    } else if (least_error < std::numeric_limits<double>::infinity()) {
        result.why_none =
            fmt::format("dispersion and steps make an error of {:.2g}, at the best G of {}",
                        least_error, best_G);
    }
    return result;
}

Candidates open_lattice_candidates(const Scene& scene, double tolerance, const Pause& pause) {
    Candidates result;
    double least_work = std::numeric_limits<double>::infinity();
    const std::vector<int> horizons =
        scene.auto_horizon ? horizons_of(scene) : std::vector{scene.horizon};
    if (horizons.empty()) {
        lattice_of(with_lattice(scene, scene.horizon, 0));  // throws: says what there is
    }
    for (const int horizon : horizons) {
        OfHorizon found = candidates_of(scene, horizon, tolerance, least_work, pause);
        if (found.meet.empty()) {
            result.left_out.push_back({fmt::format("horizon {}", horizon), found.why_none});
        }
        std::ranges::move(found.meet, std::back_inserter(result.meet));
    }
    return result;
}

}  // namespace

bool has_open_lattice(const Scene& scene) {
    return scene.auto_horizon || scene.auto_G;
}

Scene with_lattice(Scene scene, int horizon, double G) {
    scene.horizon = horizon;
    scene.G = G;
    scene.auto_horizon = false;
    scene.auto_G = false;
    return scene;
}

Candidates find_candidates(const Scene& scene, double tolerance, const Pause& pause) {
    if (!has_open_lattice(scene)) {
        if (const std::string objection = objection_to_given_steps(scene); !objection.empty()) {
            throw Unstable(objection);
        }
    }
    Candidates result = has_open_lattice(scene)
                            ? open_lattice_candidates(scene, tolerance, pause)
                            : Search(scene, tolerance, Reference::lattice, pause).all();
    result.left_out.push_back(layers);
    result.left_out.push_back(without_certificate);
    return result;
}

}  // namespace nmbcrun
