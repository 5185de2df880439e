// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/commands/require_stable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "generator/commands/ghost_side.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rounded_text.hpp"
#include "generator/families/vector_family.hpp"
#include "generator/names/names.hpp"
#include "generator/names/projected_family.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/discrete.hpp"
#include "generator/stability/modal.hpp"

namespace nmbcgen {
namespace {

constexpr int digits_of_edge = 7;

std::string how_it_fails(const Table& table, const Rational& G) {
    const ModalVerdict verdict = modal_verdict(make_half_space(table, G));
    switch (verdict.failure) {
        case Failure::growing_mode:
            return fmt::format("a boundary mode grows, Re s = {:.3g} c/dX", verdict.growth.real());
        case Failure::resonance:
            return fmt::format("it sends out a wave of its own at xi = {:.3g}/dX",
                               verdict.wave_number);
        default:
            return fmt::format(
                "waves are amplified by up to {:.6g} a reflection, most at the frequency of xi = "
                "{:.3g}/dX{}",
                verdict.supremum, verdict.wave_number,
                verdict.backward ? ", where backward waves travel" : "");
    }
}

/// Of a window, rounded into it.
std::string lower_edge(double edge) {
    constexpr double next_to_zero = 1e-300;  // where 0 itself is a pole
    if (edge < next_to_zero) {
        return edge > 0 ? "above 0" : "0";
    }
    return rounded_up(edge, digits_of_edge);
}

std::string text_of(const std::vector<StabilityWindow>& windows) {
    std::string text;
    for (const StabilityWindow& window : windows) {
        text += fmt::format(
            "{}{} {}", text.empty() ? "" : "; ", lower_edge(window.low.inner),
            window.high ? "to " + rounded_down(window.high->inner, digits_of_edge) : "and above");
    }
    return text.empty() ? "none" : text;
}

/// Waves at normal incidence are in the table's certificate; these are the oblique ones.
PlaneGrade require_stable_in_plane(const Specification& what, const ProjectedFamily& projected) {
    const SideTask model{.family = projected.family,
                         .choice = projected.model,
                         .g = what.stabilisation.value_or(0),
                         .time_step = 0};
    const VectorFamily& family = find_vector_family(model.family);
    if (family.dimensions == 3) {
        throw NotStable(fmt::format(
            "sides of the cubic lattice of {} are not examined for oblique waves: what is "
            "certified is the chain that waves at normal incidence see. Nothing was written; "
            "without "
            "--require-stable the table is.",
            model.family));
    }
    if (what.damping != 0) {  // tau is in units of one polarisation, and the plane has both
        throw NotStable(
            "conditions of damped lattices are not examined for oblique waves: what is certified "
            "is the chain that waves at normal incidence see. nmbcgen recommend has the damping "
            "with which undamped conditions do not grow. Nothing was written; without "
            "--require-stable the table is.");
    }
    const PlaneLattice lattice = plane_lattice(family.describe(model.choice), model.g, 0);
    const auto condition = component_condition(model, lattice, what);
    if (!condition) {
        throw NotStable(fmt::format(
            "a side of the plane takes conditions of both polarisations, and NMBC{} of {} waves, "
            "stride {}, has no solution at g = {}. Nothing was written; without --require-stable "
            "the table is.",
            what.order, projected.polarisation == Polarisation::P ? "S" : "P", what.stride,
            to_string(model.g)));
    }
    GhostSide side{.name = component_name(what.order, what.stride), .condition = *condition};
    examine(side, model, lattice);
    const std::string grade = grade_of(side);
    if (side.is_stable()) {
        return {.grade = grade,
                .samples = samples_text(),
                .steps = side.steps,
                .grows_opposite = side.grows_opposite};
    }
    const auto& [what_grows, rate] = std::ranges::max(
        std::array{std::pair("modes of such a side", side.growth_of_modes),
                   std::pair("strips between such sides", side.growth_in_strips),
                   std::pair("boxes with corners between such sides", side.growth_with_corners)},
        {}, &std::pair<const char*, double>::second);
    std::string sides;
    if (family.at_edge != nullptr) {
        std::string options = options_of(projected);
        options.erase(options.find(" --polarisation"));
        sides = fmt::format(
            "\nnmbcgen recommend {} --G {} shows the sides there are; the passive one is stable by "
            "construction",
            options, to_string(model.g));
    }
    const bool only_in_continuous_time = grade == "contractive" || grade == "paired";
    throw NotStable(fmt::format(
        "{} is not stable {}as a side of the plane, g = {}, though it is for waves at normal "
        "incidence: {}. Nothing was written.{}",
        side.name, only_in_continuous_time ? "in leapfrog steps " : "", to_string(model.g),
        side.grows() ? fmt::format("{} grow, Re s = {:.2g} sqrt(E/density)/dX", what_grows, rate)
        : only_in_continuous_time
            ? fmt::format("it is {} in continuous time, and not in steps of a tenth of the longest",
                          grade)
            : fmt::format("of {} wave vectors some are amplified, {} times a reflection "
                          "between like sides",
                          side.amplification.samples, amplification_of(side)),
        sides));
}

/// A family without G has one of 0.
HalfSpace half_space_of(const Table& table) {
    return make_half_space(table, table.specification.stabilisation.value_or(0));
}

bool only_in_too_long_steps(const Table& table) {
    return table.specification.time_step != 0 &&
           stability_grade(half_space_of(table)) != Grade::none;
}

}  // namespace

std::string why_uncertified(const Table& table) {
    const Specification& what = table.specification;
    const Rational G = what.stabilisation.value_or(0);
    return fmt::format(
        "NMBC{} at horizon {}, stride {},{}{}{} {} = {} is not {}", what.order, what.horizon,
        what.stride,
        what.points.empty() ? std::string() : " matched at " + matching_text(what) + ",",
        what.damping != 0 ? " damping " + to_string(what.damping) + "," : std::string(),
        what.time_step != 0 ? " steps of " + to_string(what.time_step) + "," : std::string(),
        projected_family(what.family) ? "g" : "G", to_string(G),
        only_in_too_long_steps(table)
            ? fmt::format("certified in these steps, of cfl {:.3f}: {:.2f} is the largest one",
                          cfl_of(half_space_of(table), nearest_double(what.time_step)),
                          stable_range(half_space_of(table)).largest)
            : "stable: " + how_it_fails(table, G));
}

std::optional<PlaneGrade> require_stable(const Table& table) {
    if (!table.certificate->modal.empty()) {
        if (const auto projected = projected_family(table.specification.family)) {
            return require_stable_in_plane(table.specification, *projected);
        }
        return std::nullopt;
    }
    const Specification& what = table.specification;
    std::string message = why_uncertified(table) + ". Nothing was written.";
    if (!what.points.empty() || only_in_too_long_steps(table)) {
        throw NotStable(message);
    }
    constexpr unsigned quick = 5;  // above, windows take minutes
    if (what.order > quick) {
        throw NotStable(message);
    }
    message += projected_family(what.family)
                   ? "\ng where it is stable for waves at normal incidence; oblique ones may grow:"
                   : "\nG where it is stable:";
    std::vector<Table> open;
    for (const unsigned stride : std::set{1U, what.horizon, what.stride}) {
        Specification other = what;
        other.stride = stride;
        other.stabilisation.reset();
        open.push_back(derive(other));
    }
    certify_all(open);
    for (const Table& other : open) {
        message += fmt::format("\n  stride {}: {}", other.specification.stride,
                               text_of(other.certificate->modal));
    }
    throw NotStable(message);
}

}  // namespace nmbcgen
