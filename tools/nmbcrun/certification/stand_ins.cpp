// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/certification/stand_ins.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nmbc/coefficients.hpp>
#include <nmbc/table.hpp>
#include <vector>

#include "generator/exact/rounded_text.hpp"
#include "tools/nmbcrun/certification/time_step.hpp"
#include "tools/nmbcrun/ends/passive_design.hpp"
#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {
namespace {

/// The scene with this end in the place of each nmbc.
Scene with_in_place(const Scene& scene, const Boundary& boundary) {
    Scene other = scene;
    for (Boundary* end : {&other.left, &other.right}) {
        *end = end->kind == BoundaryKind::nmbc ? boundary : *end;
    }
    return other;
}

/// The orders and strides that are certified in the place of the scene's nmbc, with their cfl.
std::string certified_orders(const Scene& scene, const Suits& suits) {
    std::string choices;
    for (const nmbc::MatchingTable* table : tables_of(scene)) {
        const Scene other = with_in_place(scene, {.order = table->order, .stride = table->stride});
        const double cfl = table->time_step == "0"
                               ? largest_certified_cfl(other, make_lattice(*table, scene.G))
                               : 0;
        if (cfl > 0 && (!suits || suits(other))) {
            choices += fmt::format("{}order {}, stride {} up to cfl = {:.3g}",
                                   choices.empty() ? "" : "; ", table->order, table->stride, cfl);
        }
    }
    return choices;
}

/// Whether passive ends, which are stable by construction, can be designed and suit.
bool has_passive(const Scene& scene, const Suits& suits) {
    if (!why_not_designed(scene).empty()) {
        return false;
    }
    const Scene other = with_in_place(scene, {.kind = BoundaryKind::passive});
    if (suits) {
        return suits(other);
    }
    const nmbc::Lattice lattice = lattice_of(scene);
    const double cfl = largest_certified_cfl(other, lattice);
    if (cfl == 0) {
        return false;
    }
    try {
        sent_back_by_passive_end(lattice, 2 * cfl / nmbc::maximum_frequency(lattice));
    } catch (const SceneError&) {  // no design for these steps
        return false;
    }
    return true;
}

/// Nodes from which on the certificates of both ends hold.
unsigned least_nodes_of(const Scene& scene) {
    unsigned least = 0;
    for (const Boundary* end : {&scene.left, &scene.right}) {
        if (end->kind == BoundaryKind::nmbc) {
            least = std::max(least, unsigned(table_of(scene, *end).least_nodes));
        }
    }
    return least;
}

}  // namespace

std::string choices_in_place(const Scene& scene, const Suits& suits) {
    std::vector<std::string> choices;
    const std::string own = certified_orders(scene, suits);
    if (!own.empty()) {
        choices.push_back("at this G: " + own);
    }
    if (has_passive(scene, suits)) {
        choices.push_back((own.empty() ? "at this G: " : "") +
                          std::string(R"(boundary.kind = "passive" without order and stride)"));
    }
    const std::string G = best_G(scene.horizon);
    Scene other = scene;
    other.G = nmbc::detail::nearest_to_fraction(G);
    const bool is_best = has_constant_influence(scene) && other.G != scene.G;
    const std::string there = own.empty() && is_best ? certified_orders(other, suits) : "";
    if (!there.empty()) {
        choices.push_back(
            fmt::format(R"(at model.G = "{}", which suits long waves best: {})", G, there));
    }
    return choices.empty() ? ""
                           : fmt::format("Certified{} {}", suits ? " and absorbing" : "",
                                         fmt::join(choices, ";\n  "));
}

std::string what_is_certified(const Scene& scene, const nmbc::Lattice& lattice) {
    const double omega_max = highest_frequency(scene, lattice);
    if (const double own = largest_certified_cfl(scene, lattice); own > 0) {
        const unsigned least = least_nodes_of(scene);
        if (scene.nodes < least) {
            return fmt::format(
                "The certificate of these ends, up to cfl = {:.3g}, holds from {} nodes on", own,
                least);
        }
        return fmt::format("Certified for these ends is cfl = {:.3g}, time.step = {}", own,
                           nmbcgen::rounded_down(2 * own / omega_max, 4));
    }
    const std::string choices = choices_in_place(scene);
    return choices.empty() ? "No other end that there is a table of is certified here; "
                             R"(boundary.kind = "extended", "exact" and "sponge" are)"
                           : choices;
}

}  // namespace nmbcrun
