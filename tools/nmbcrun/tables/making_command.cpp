// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/tables/making_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"
#include "generator/names/names.hpp"

namespace nmbcrun {
namespace {

/// As short as it reads back as this double.
nmbcgen::Rational exact_G(double G) {
    try {
        return nmbcgen::parse_rational(fmt::format("{}", G));
    } catch (const std::invalid_argument&) {  // 1e-07
        return nmbcgen::Rational(G);
    }
}

bool is_known_lattice(const nmbcgen::Specification& what) {
    constexpr unsigned most = 99;  // that nmbcgen takes
    if (what.horizon > most || what.order > most || what.stride > most) {
        return false;
    }
    try {
        const auto model =
            nmbcgen::make_model(what.family, what.horizon, what.damping, what.weights);
        return what.stabilisation == 0 ||
               std::ranges::find(model.energy, nmbcgen::EnergyPart::stabilisation,
                                 &nmbcgen::ExactSquare::part) != model.energy.end();
    } catch (const nmbcgen::NoSuchModel&) {
        return false;
    }
}

}  // namespace

std::string how_to_make(const Scene& scene, const Boundary& boundary) {
    const bool matching = takes_table(boundary.kind);
    nmbcgen::Specification what{
        .family = scene.family,
        .horizon = unsigned(scene.horizon),
        .order = matching ? unsigned(boundary.order) : 1,
        .stride = matching ? unsigned(boundary.stride) : 1,
        .stabilisation = exact_G(scene.G),
        .damping = nmbcgen::parse_rational(scene.tau),
        .time_step = nmbcgen::parse_rational(matching ? boundary.matched_step : "0")};
    for (const std::string& weight : scene.weights) {
        what.weights.push_back(nmbcgen::parse_signed_rational(weight));
    }
    if (!is_known_lattice(what)) {
        return "";
    }
    if (what.order == 1 && what.time_step > 0) {
        return ". NMBC1 is the same in time steps of any length: leave out boundary.matched_step";
    }
    return fmt::format(
        ". To make it beside the scene: {} --format json --out FOLDER, and model.tables = "
        "[\"{}.json\"]",
        regenerating_command(what), table_name(what));
}

}  // namespace nmbcrun
