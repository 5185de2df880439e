// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/tables/making_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nmbc/coefficients.hpp>
#include <stdexcept>

#include "generator/exact/rational.hpp"
#include "generator/families/family.hpp"
#include "generator/names/names.hpp"
#include "generator/names/projected_family.hpp"

namespace nmbcrun {
namespace {

/// As the scene states it, unless it has another by now; or as short as it reads back as this
/// double.
nmbcgen::Rational exact_G(const Scene& scene) {
    if (!scene.exact_G.empty() && nmbc::detail::nearest_to_fraction(scene.exact_G) == scene.G) {
        return nmbcgen::parse_rational(scene.exact_G);
    }
    try {
        return nmbcgen::parse_rational(fmt::format("{}", scene.G));
    } catch (const std::invalid_argument&) {  // 1e-07
        return nmbcgen::Rational(scene.G);
    }
}

std::vector<nmbcgen::Rational> weights_of(const Scene& scene) {
    std::vector<nmbcgen::Rational> weights;
    for (const std::string& weight : scene.weights) {
        weights.push_back(nmbcgen::parse_signed_rational(weight));
    }
    return weights;
}

}  // namespace

std::string why_no_G(std::string_view family, double G) {
    return fmt::format(
        "the lattice of family {} has no stabilisation: model.G must be absent or 0, not {}",
        family, G);
}

bool is_family(const std::string& name) {
    return nmbcgen::projected_family(name).has_value() ||
           std::ranges::find(nmbcgen::families(), name, &nmbcgen::Family::name) !=
               nmbcgen::families().end();
}

std::string why_no_lattice(const Scene& scene) {
    if (!is_family(scene.family)) {
        std::string names;
        for (const nmbcgen::Family& family : nmbcgen::families()) {
            names += fmt::format("\"{}\", ", family.name);
        }
        return fmt::format(
            "there is no family \"{}\": model.family is {}a wave of a plane such as "
            "\"nopd2d_r1_nu1o4_P\", or what a table of model.tables has",
            scene.family, names);
    }
    if (scene.G != 0 && !nmbcgen::is_stabilised(scene.family)) {
        return why_no_G(scene.family, scene.G);
    }
    try {
        nmbcgen::make_model(scene.family, unsigned(scene.horizon),
                            nmbcgen::parse_rational(scene.tau), weights_of(scene));
    } catch (const nmbcgen::NoSuchModel& error) {
        return fmt::format("there is no such model: {}", error.what());
    }
    return "";
}

std::string how_to_make(const Scene& scene, const Boundary& boundary) {
    const bool matching = takes_table(boundary.kind);
    const nmbcgen::Specification what{
        .family = scene.family,
        .horizon = unsigned(scene.horizon),
        .order = matching ? unsigned(boundary.order) : 1,
        .stride = matching ? unsigned(boundary.stride) : 1,
        .stabilisation = exact_G(scene),
        .damping = nmbcgen::parse_rational(scene.tau),
        .time_step = nmbcgen::parse_rational(matching ? boundary.matched_step : "0"),
        .weights = weights_of(scene)};
    if (what.order == 1 && what.time_step > 0) {
        return ". NMBC1 is the same in time steps of any length: leave out boundary.matched_step";
    }
    return fmt::format(
        ". To make it beside the scene: {} --format json --out FOLDER, and model.tables = "
        "[\"{}.json\"]",
        regenerating_command(what), table_name(what));
}

}  // namespace nmbcrun
