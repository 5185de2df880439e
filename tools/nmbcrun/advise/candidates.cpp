// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/advise/candidates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "tools/nmbcrun/advise/search.hpp"
#include "tools/nmbcrun/advise/stabilisations.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/simulation/tables.hpp"

namespace nmbcrun {
namespace {

const LeftOut layers{"sponge, pml",
                     "a layer takes nodes and steps of its own: where a ghost rule will not "
                     "do, \"extended\" and \"exact\" have no error at all"};
const LeftOut without_certificate{"higdon, mbc", "not certified to be stable"};

/// One horizon of a scene that leaves its lattice open.
struct OfHorizon {
    std::vector<Candidate> meet;
    std::string why_none;
};

OfHorizon candidates_of(const Scene& scene, int horizon, double tolerance) {
    const Scene of_horizon = with_lattice(scene, horizon, scene.G);
    const std::vector<double> stabilisations =
        scene.auto_G ? stabilisations_to_try(of_horizon) : std::vector{scene.G};
    OfHorizon result;
    double least_error = std::numeric_limits<double>::infinity();
    double best_G = 0;
    for (const double G : stabilisations) {
        const Scene settled = with_lattice(scene, horizon, G);
        Search search(settled, tolerance, Reference::continuum);
        Candidates found = search.all();
        std::ranges::move(found.meet, std::back_inserter(result.meet));
        if (search.least_interior_error() < least_error) {
            least_error = search.least_interior_error();
            best_G = G;
        }
    }
    result.why_none =
        least_error > tolerance
            ? fmt::format("dispersion and steps make an error of {:.2g} at least, at G = {}",
                          least_error, best_G)
            : fmt::format("no end meets it in steps in which the interior does, at G = {}",
                          fmt::join(stabilisations, ", "));
    return result;
}

Candidates open_lattice_candidates(const Scene& scene, double tolerance) {
    Candidates result;
    const std::vector<int> horizons =
        scene.auto_horizon ? horizons_of(scene) : std::vector{scene.horizon};
    for (const int horizon : horizons) {
        OfHorizon found = candidates_of(scene, horizon, tolerance);
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

Candidates find_candidates(const Scene& scene, double tolerance) {
    Candidates result = has_open_lattice(scene)
                            ? open_lattice_candidates(scene, tolerance)
                            : Search(scene, tolerance, Reference::lattice).all();
    result.left_out.push_back(layers);
    result.left_out.push_back(without_certificate);
    return result;
}

}  // namespace nmbcrun
