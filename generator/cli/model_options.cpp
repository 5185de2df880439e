// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/model_options.hpp"

#include "generator/cli/option_values.hpp"
#include "generator/cli/parsed_option.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {

CLI::Option* add_plane_model(CLI::App& app, PlaneOptions& plane) {
    CLI::Option* const radius =
        add_parsed(app, "--radius2", plane.radius_squared, parse_radius_squared,
                   "of a plane family, in place of --horizon: square of a node's family radius "
                   "delta in units of dX^2, a sum of two squares such as 1, 2, 4, 5, 8, 9");
    add_parsed(app, "--nu", plane.poisson, parse_signed_rational,
               "of nopd2d: Poisson's ratio, an exact number such as 1/4")
        ->needs(radius);
    add_parsed(app, "--state", plane.plane_strain, parse_plane_state,
               "of nopd2d: plane stress or strain (default stress)")
        ->needs(radius);
    return radius;
}

CLI::Option* add_plane(CLI::App& app, PlaneOptions& plane) {
    CLI::Option* const radius = add_plane_model(app, plane);
    add_parsed(app, "--polarisation", plane.polarisation, parse_polarisation,
               "of a plane family: P or S waves, at normal incidence")
        ->needs(radius);
    return radius;
}

CLI::Option* add_weights(CLI::App& app, std::optional<WeightChoice>& weights) {
    return add_parsed(app, "--weights", weights, parse_weights,
                      "influence function: w_1,w_2,.. of bonds of 1, 2, .. dX, exact numbers, or " +
                          influence_names() +
                          " (default constant); of bond2d: w of the energy w (R . du)^2/2 of each "
                          "class of bonds R, shortest first");
}

}  // namespace nmbcgen
