// SPDX-License-Identifier: MIT
#include "generator/families/projected.hpp"

#include <fmt/format.h>

#include <cmath>

#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/lattice/projection.hpp"

namespace nmbcgen {

Model projected_model(const ProjectedFamily& projected) {
    const bool is_P = projected.polarisation == Polarisation::P;
    try {
        Model model =
            project(find_vector_family(projected.family).describe(projected.model), is_P ? 0 : 1);
        model.description =
            fmt::format("{} waves along x in {}", is_P ? "P" : "S", model.description);
        model.source += fmt::format(
            "; at normal incidence; c is the speed of long {} waves{}", is_P ? "P" : "S",
            has_stabilisation(model) ? ", its G is the plane's g = G/pi" : "");
        return model;
    } catch (const NoProjection& reason) {
        throw NoSuchModel(reason.what());
    }
}

unsigned horizon_of(const VectorChoice& choice) {
    return unsigned(std::sqrt(double(choice.radius_squared)));
}

}  // namespace nmbcgen
