// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/settle_plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "generator/families/family.hpp"
#include "generator/families/projected.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {
namespace {

/// What there is no model of is the fault of this option.
template <class Make>
void require_model(const char* option, Make make) {
    try {
        make();
    } catch (const NoSuchModel& reason) {
        throw CLI::ValidationError(option, reason.what());
    }
}

bool is_given(const CLI::App& used, const char* option) {
    const CLI::Option* const known = used.get_option_no_throw(option);
    return known != nullptr && known->count() > 0;
}

void refuse_options(const std::string& family, const CLI::App& used) {
    for (const char* option : {"--radius2", "--nu", "--state", "--polarisation", "--angle"}) {
        if (is_given(used, option)) {
            throw CLI::ValidationError(option, family + " is no plane family");
        }
    }
}

/// A side of the plane is not one condition in steps of its own.
void refuse_options_of_chains(const CLI::App& used) {
    for (const char* option : {"--order", "--tolerance", "--cfl", "--band"}) {
        if (is_given(used, option)) {
            throw CLI::ValidationError(option,
                                       "is of the waves of one polarisation: --polarisation");
        }
    }
}

ChainModel settled_end(const Question& question, const Pending& pending) {
    const bool is_closed = question.family == "chain1d";
    if (question.family != "nopd1d" && !is_closed) {
        throw CLI::ValidationError("--family",
                                   "passive designs are of nopd1d, chain1d, nopd2d, bond2d");
    }
    if (is_closed && question.horizon != 1) {
        throw CLI::ValidationError("--horizon", "chain1d has neighbours at 1 alone");
    }
    if (is_closed && pending.passive_step != 0) {
        throw CLI::ValidationError("--time-step",
                                   "the end of chain1d is a closed form in continuous time");
    }
    if (pending.weights) {
        throw CLI::ValidationError("--weights", "passive ends have constant influence");
    }
    if (pending.layers) {
        throw CLI::ValidationError("--layers", "is of a side of the plane");
    }
    return {.family = question.family,
            .horizon = question.horizon,
            .G = question.G,
            .time_step = pending.passive_step};
}

void require_fit(const VectorFamily& family, const PlaneOptions& plane,
                 const std::optional<WeightChoice>& weights) {
    const std::string name(family.name);
    if (!plane.radius_squared) {
        throw CLI::RequiredError("--radius2");
    }
    if (const unsigned largest = family.largest_radius_squared;
        largest > 0 && *plane.radius_squared > largest) {
        throw CLI::ValidationError(
            "--radius2", fmt::format("{} takes family radii up to {} (squared), not {}", name,
                                     largest, *plane.radius_squared));
    }
    if (family.has_poisson && !plane.poisson) {
        throw CLI::RequiredError("--nu");
    }
    if (plane.poisson && !family.has_poisson) {
        throw CLI::ValidationError("--nu", name + " has no Poisson's ratio to choose");
    }
    if (plane.plane_strain && (!family.has_poisson || family.dimensions == 3)) {
        throw CLI::ValidationError("--state", name + " has no plane stress or strain");
    }
    const bool needs_weights = family.has_weights && !family.has_poisson;
    if ((weights && !family.has_weights) || (!weights && needs_weights) ||
        (weights && weights->named != nullptr)) {
        throw CLI::ValidationError(
            "--weights", family.has_weights
                             ? name +
                                   " takes w_1,w_2,.., one for each class of bonds, shortest "
                                   "first: of (1, 0), (1, 1), (2, 0), (2, 1), .., in space of (1, "
                                   "0, 0), (1, 1, 0), (1, 1, 1), .."
                             : name + " has constant influence");
    }
}

/// Over the size of the first one: in units of a polarisation's own speed a factor > 0 of all says
/// nothing.
std::vector<Rational> relative(std::vector<Rational> weights) {
    std::ranges::transform(weights, weights.begin(),
                           [first = weights.empty() ? Rational(1) : Rational(abs(weights.front()))](
                               const Rational& weight) { return weight / first; });
    return weights;
}

/// 0: not given.
std::size_t settled_layers(const VectorChoice& choice, const std::optional<unsigned>& layers) {
    try {
        return layers ? side_layers_checked(choice, *layers) : 0;
    } catch (const std::invalid_argument& reason) {
        throw CLI::ValidationError("--layers", reason.what());
    }
}

/// What is at fault where P or S waves do not travel: the radius, where they do not in the plainest
/// model of it either.
const char* blamed_for_waves(const VectorFamily& family, const VectorChoice& choice,
                             Polarisation polarisation, const char* otherwise) {
    VectorChoice plainest = choice;
    if (plainest.poisson) {
        plainest.poisson = Rational(1, 4);
    }
    std::ranges::fill(plainest.weights, Rational(1));
    try {
        projected_model(
            {.family = std::string(family.name), .model = plainest, .polarisation = polarisation});
        return otherwise;
    } catch (const NoSuchModel&) {
        return "--radius2";
    }
}

/// recommend and passive of a side of the plane.
void settle_side(Request& request, const VectorFamily& family, const VectorChoice& choice,
                 const Pending& pending, const CLI::App& used, const char* blamed) {
    refuse_options_of_chains(used);
    const bool passive = request.action == Action::passive;
    if (family.dimensions == 3 || (family.at_edge == nullptr && passive)) {
        throw CLI::ValidationError("--family",
                                   fmt::format("{}; tables of {} are of one --polarisation",
                                               passive ? "passive sides are of nopd2d and bond2d"
                                                       : "sides are of nopd2d, bond2d and lps2d",
                                               family.name));
    }
    if (choice.radius_squared > largest_side_radius_squared) {
        throw CLI::ValidationError(
            "--radius2",
            fmt::format(
                "sides of families above {} take too long: {}", largest_side_radius_squared,
                passive ? "take a smaller family" : "give a --polarisation, or a smaller family"));
    }
    for (const Polarisation polarisation : {Polarisation::P, Polarisation::S}) {
        try {
            projected_model({.family = std::string(family.name),
                             .model = choice,
                             .polarisation = polarisation});
        } catch (const NoSuchModel& reason) {
            throw CLI::ValidationError(blamed_for_waves(family, choice, polarisation, blamed),
                                       reason.what());
        }
    }
    if (family.at_edge != nullptr &&
        std::ranges::any_of(choice.weights, [](const Rational& w) { return w < 0; })) {
        throw CLI::ValidationError(
            "--weights",
            fmt::format("sides that are stable by construction need weights above 0{}",
                        passive ? ""
                                : ". For the waves of one polarisation at normal incidence add "
                                  "--polarisation P or S"));
    }
    request.side = {.family = std::string(family.name),
                    .choice = choice,
                    .g = request.question.G,
                    .time_step = pending.passive_step,
                    .layers = settled_layers(choice, pending.layers)};
}

/// A table, or what is said of one: of the chain that one polarisation sees. horizon: of the
/// request, to be set.
void settle_polarisation(Request& request, const VectorFamily& known, VectorChoice choice,
                         const std::optional<Polarisation>& polarisation, unsigned& horizon) {
    if (!request.absorbed.empty()) {
        throw CLI::ValidationError("--absorb", "is of all waves, without --polarisation");
    }
    if (request.as_csv) {
        throw CLI::ValidationError("--csv", "is of all waves, without --polarisation");
    }
    if (!polarisation) {
        throw CLI::ValidationError("--polarisation",
                                   "is required: a table is of the P or the S waves. Sides for all "
                                   "waves: nmbcgen recommend, and nmbcgen passive, whose sides are "
                                   "stable by construction");
    }
    choice.weights = relative(choice.weights);
    if (known.has_poisson &&
        std::ranges::count(choice.weights, Rational(1)) == std::ptrdiff_t(choice.weights.size())) {
        choice.weights.clear();  // constant influence has one name
    }
    const ProjectedFamily projected{
        .family = std::string(known.name), .model = choice, .polarisation = *polarisation};
    require_model("--polarisation", [&] { projected_model(projected); });
    family_of(request) = name_of(projected);
    horizon = horizon_of(choice);
}

}  // namespace

std::string& family_of(Request& request) {
    switch (request.action) {
        case Action::recommend:
        case Action::passive:
            return request.question.family;
        case Action::dispersion:
            return request.curves.family;
        case Action::taylor:
            return request.series.family;
        case Action::oblique:
            return request.oblique.family;
        default:
            return request.specification.family;
    }
}

void settle_plane(Request& request, Pending& pending, const CLI::App& used) {
    const bool designs = request.action == Action::passive;
    const bool recommends = request.action == Action::recommend || designs;
    const bool disperses = request.action == Action::dispersion;
    std::string& family = family_of(request);
    if (is_given(used, "--radius2") && !is_given(used, "--family")) {
        family = "nopd2d";
    }
    const VectorFamily* const known = vector_family(family);
    if (known == nullptr) {
        refuse_options(family, used);
        if (designs) {
            request.end = settled_end(request.question, pending);
        }
        return;
    }
    const PlaneOptions& plane = pending.plane;
    require_fit(*known, plane, pending.weights);
    VectorChoice choice{
        .radius_squared = *plane.radius_squared,
        .poisson = plane.poisson,
        .plane_strain = plane.plane_strain.value_or(false),
        .weights = pending.weights ? pending.weights->values : std::vector<Rational>{}};
    pending.weights.reset();
    const char* const blamed = known->has_poisson ? "--nu" : "--weights";
    require_model("--radius2", [&] { neighbours(choice.radius_squared, known->dimensions); });
    require_model(blamed, [&] { known->describe(choice); });
    if (disperses) {
        const bool limit = std::exchange(request.curves.limit, false);
        if (limit && known->limit == nullptr) {
            throw CLI::ValidationError("--limit", family + " states no continuum limit");
        }
        request.plane_curves = {.model = choice,
                                .angles = plane.angles.value_or(std::vector<double>{0, 15, 30, 45}),
                                .samples = request.curves.samples,
                                .limit = limit};
        return;
    }
    if (request.action == Action::taylor) {
        if (!plane.polarisation) {
            throw CLI::RequiredError("--polarisation");
        }
        request.series.choice = choice;
        request.series.polarisation = *plane.polarisation;
        return;
    }
    if (request.action == Action::oblique) {
        if (known->dimensions == 3) {
            throw CLI::ValidationError("--family", family + " is no lattice of the plane");
        }
        request.oblique.choice = choice;
        return;
    }
    if (recommends && !plane.polarisation) {
        settle_side(request, *known, choice, pending, used, blamed);
        return;
    }
    settle_polarisation(request, *known, std::move(choice), plane.polarisation,
                        recommends ? request.question.horizon : request.specification.horizon);
}

}  // namespace nmbcgen
