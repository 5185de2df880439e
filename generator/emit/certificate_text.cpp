// SPDX-License-Identifier: MIT
#include "generator/emit/certificate_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "generator/emit/cpp_source.hpp"
#include "generator/exact/algebraic_number.hpp"
#include "generator/names/projected_family.hpp"

namespace nmbcgen {
namespace {

std::string describe(const AlgebraicNumber& number) {
    const std::string exact = to_text(number);
    return exact.empty()
               ? fmt::format("an algebraic number of degree at most {}", number.polynomial.degree())
               : exact;
}

std::string describe(const Edge& edge) {
    const auto* exact = std::get_if<AlgebraicNumber>(&edge.where);
    std::string text;
    if (exact != nullptr) {
        text = describe(*exact);
    } else {
        const auto& bracket = std::get<Bracket>(edge.where);
        text = fmt::format("between {:.7f} and {:.7f}", bracket.low, bracket.high);
    }
    if (edge.beyond != Failure::none) {
        text += fmt::format(", beyond it: {}", name_of(edge.beyond));
    }
    if (edge.wave_number != 0) {
        text += fmt::format(" at xi = {:.2f}", edge.wave_number);
    }
    return text;
}

std::string double_literal(double value) {
    return std::isinf(value) ? "unbounded" : fmt::format("{}", value);
}

std::string entry(const ExactWindow& window) {
    const double low = nearest_double(window.low);
    const double high = window.high ? nearest_double(*window.high) : HUGE_VAL;
    return fmt::format("    // {} .. {}\n    {{{}, {}}},\n", describe(window.low),
                       window.high ? describe(*window.high) : "no end", double_literal(low),
                       double_literal(high));
}

std::string entry(const StabilityWindow& window) {
    const double high = window.high ? window.high->inner : HUGE_VAL;
    return fmt::format("    // low: {}\n    // high: {}\n    {{{}, {}}},\n", describe(window.low),
                       window.high ? describe(*window.high) : "none",
                       double_literal(window.low.inner), double_literal(high));
}

std::string entry(const StableStep& step) {
    return fmt::format("    {{{{{}, {}}}, {}{}}},\n", double_literal(step.window.low),
                       double_literal(step.window.high), step.cfl,
                       step.from > 0 ? fmt::format(", {}", step.from) : "");
}

constexpr auto line_of = [](const auto& item) { return entry(item); };

}  // namespace

std::string window_arrays(const Certificate& certificate) {
    return array("Window", "reflection", certificate.reflection, line_of) +
           array("Window", "modal", certificate.modal, line_of) +
           array("Window", "contractive", certificate.contractive, line_of) +
           array("StableStep", "max_cfl", certificate.max_cfl, line_of) +
           array("StableStep", "max_cfl_contractive", certificate.max_cfl_contractive, line_of);
}

std::string window_members(const std::string& table_name, const Certificate& certificate,
                           bool damped) {
    const auto member = [&table_name](const std::string& name, bool empty) {
        return fmt::format("    .{} = {},\n", name,
                           empty ? "{}" : fmt::format("{}_data::{}", table_name, name));
    };
    const auto undamped_member = [&](const std::string& name, bool empty) {
        return damped ? fmt::format("    .{} = {{}},  // not sought of a damped lattice\n", name)
                      : member(name, empty);
    };
    return undamped_member("reflection", certificate.reflection.empty()) +
           member("modal", certificate.modal.empty()) +
           undamped_member("contractive", certificate.contractive.empty()) +
           member("max_cfl", certificate.max_cfl.empty()) +
           undamped_member("max_cfl_contractive", certificate.max_cfl_contractive.empty());
}

namespace {

std::string undamped_statement() {
    return "reflection: scalar |R| <= 1 on the band, exact; modal: no growing boundary mode and "
           "sup over phases of rho(R D) <= 1 on the band, both ends alike; contractive: "
           "sigma_max(R) <= 1 as well, in "
           "continuous time, so that the other end may be any that adds no energy; max_cfl: as "
           "modal, of the leapfrog scheme, both ends alike; max_cfl_contractive: as contractive, "
           "of the leapfrog scheme; all of it for chains so long that decaying waves do not reach "
           "the other end, from least_nodes on; "
           "modal edges are exact where an exact value is given, else in the bracket";
}

std::string damped_statement() {
    return fmt::format(
        "modal, sought up to G = {}: no growing boundary mode and no growth by round trips on "
        "the band, both ends alike, in chains of {} interior nodes and more, on whose length the "
        "damping takes back what an end amplifies; max_cfl: the same of the leapfrog scheme, "
        "damping force "
        "from the old velocities; reflection, contractive and max_cfl_contractive: not sought, "
        "since waves lose energy on the way; modal edges are exact where an exact value is "
        "given, else in the bracket",
        highest_damped_G, least_damped_nodes);
}

/// What is proved and what is sampled, and how finely; by the names of the table's members.
std::string evidence_statement(const Table& table, const Certificate& certificate) {
    const bool at_one_G = table.specification.stabilisation || !has_stabilisation(table.model);
    const bool damped = table.specification.damping > 0;
    std::string proved = damped ? "poles" : "reflection, poles";
    std::string sampled;
    const auto add = [&](Evidence evidence, const std::string& names) {
        std::string& list = evidence == Evidence::proved ? proved : sampled;
        list += (list.empty() ? "" : ", ") + names;
    };
    if (damped) {
        add(certificate.paired, "growing modes of modal and max_cfl");
        add(Evidence::sampled, "round trips");
    } else {
        add(certificate.paired, "modal, max_cfl");
        add(certificate.with_any, "contractive, max_cfl_contractive");
    }
    add(Evidence::sampled, "least_nodes");
    const bool all_proved = !damped && certificate.paired == Evidence::proved &&
                            certificate.with_any == Evidence::proved;
    const char* spacing = at_one_G ? ""
                          : damped ? ", every 1/16 of G or closer"
                                   : ", 8 to 24 G between critical values";
    return fmt::format("; proved: {}; sampled: {}{}{}", proved, sampled, spacing,
                       all_proved ? "" : ", steps every 0.05 of cfl");
}

std::string plane_statement(const Table& table) {
    if (!projected_family(table.specification.family)) {
        return "";
    }
    if (!table.in_plane) {
        return "for waves at normal incidence, oblique ones may grow. ";
    }
    const PlaneGrade& found = *table.in_plane;
    return fmt::format(
        "as a side of the plane, with its like for the other polarisation: {} in leapfrog steps up "
        "to {:.1f} of the longest of the lattice{}, sampled: {}; all else for waves at normal "
        "incidence. ",
        found.grade, found.steps,
        found.grows_opposite.empty()
            ? ""
            : fmt::format(", growing opposite {} sides", fmt::join(found.grows_opposite, " and ")),
        found.samples);
}

}  // namespace

std::string certificate_statement(const Table& table) {
    if (!table.certificate) {
        return "not examined";
    }
    const Specification& what = table.specification;
    return plane_statement(table) + (what.damping > 0 ? damped_statement() : undamped_statement()) +
           evidence_statement(table, *table.certificate) +
           (what.time_step > 0
                ? "; matched in time steps: modal, contractive and steps are for the G at which "
                  "its own step is certified"
                : "");
}

}  // namespace nmbcgen
