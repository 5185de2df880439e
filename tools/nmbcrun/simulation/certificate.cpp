// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/certificate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <nmbc/certificate.hpp>
#include <optional>

#include "generator/stability/discrete.hpp"
#include "generator/stability/round_trip.hpp"
#include "tools/nmbcrun/simulation/ends.hpp"
#include "tools/nmbcrun/simulation/half_space.hpp"

namespace nmbcrun {
namespace {

nmbcgen::ChainEnd end_of(const Boundary& boundary, const nmbc::MatchingTable& table, double G,
                         double time_step) {
    // A fixed or free end is the same in any steps, but in a damped lattice the waves are not.
    const auto half_space = in_steps(half_space_of(table, G), boundary.ghosts, time_step);
    switch (boundary.kind) {
        case BoundaryKind::fixed:
        case BoundaryKind::extended:
            return fixed_end(half_space);
        case BoundaryKind::free:
            return free_end(half_space);
        default:  // nmbc; decided_without_waves() knows the others
            break;
    }
    return {nmbcgen::EndKind::matching, half_space};
}

/// ln |zeta| of the factor zeta of one time step [dX/c], whose sigma this is (half_space.hpp).
double growth_per_step(const Boundary& boundary, std::complex<double> sigma, double time_step) {
    const std::complex<double> half = sigma * time_step / 2.0;
    return boundary.ghosts == nmbc::GhostRule::midpoint
               ? std::log(std::abs((1.0 + half) / (1.0 - half)))
               : std::log(std::abs(1.0 + sigma * time_step));
}

std::size_t moving_nodes(const Scene& scene) {
    std::size_t nodes = scene.nodes;
    for (const Boundary& boundary : {scene.left, scene.right}) {
        nodes += has_layer(boundary.kind) ? boundary.layer : 0;
    }
    return nodes;
}

/// Growth [c/dX] by the largest eigenvalue of one step, in chains so short that the half spaces do
/// not tell all; 0 in longer ones, or where nothing grows.
double short_chain_growth(const Scene& scene, const nmbc::MatchingTable& left,
                          const nmbc::MatchingTable& right, double time_step) {
    constexpr std::size_t longest = 60;  // tests/stability/exam_short_chains.cpp: 25 are short
    const std::size_t nodes = moving_nodes(scene);
    // One rule for both ends is what one_step_map() knows.
    const Boundary& ruling = scene.left.kind == BoundaryKind::nmbc ? scene.left : scene.right;
    const int matching =
        int(scene.left.kind == BoundaryKind::nmbc) + int(scene.right.kind == BoundaryKind::nmbc);
    const bool one_rule = matching == 1 || scene.left.ghosts == scene.right.ghosts;
    if (nodes > longest || matching == 0 || !one_rule || is_damped(scene)) {
        return 0;  // of a damped lattice round trips tell all
    }
    const double radius = nmbcgen::spectral_radius(
        end_of(scene.left, left, scene.G, time_step),
        end_of(scene.right, right, scene.G, time_step), nodes, time_step,
        ruling.ghosts == nmbc::GhostRule::midpoint ? nmbcgen::GhostLevel::midpoint
                                                   : nmbcgen::GhostLevel::old);
    constexpr double roundings = 1e-7;  // a double eigenvalue 1 splits by their square root
    return radius > 1 + roundings ? std::log(radius) / time_step : 0;
}

std::string name_of(const Boundary& boundary) {
    if (!takes_table(boundary.kind)) {
        const char* article = name_of(boundary.kind).starts_with('e') ? "an " : "a ";
        return article + std::string(name_of(boundary.kind)) + " end";
    }
    return fmt::format("{}{}{}{}", boundary.kind == BoundaryKind::mbc ? "MBC" : "NMBC",
                       boundary.order,
                       boundary.stride > 1 ? fmt::format(" of stride {}", boundary.stride) : "",
                       boundary.ghosts == nmbc::GhostRule::midpoint ? "" : " with explicit ghosts");
}

/// The objection where the waves of the two ends need not be looked at: none between ends that add
/// no energy, none to an nmbc at a step where it is certified for any such end. Nothing where they
/// have to be: between two nmbc, and against ends whose reflections are known.
std::optional<std::string> decided_without_waves(const Scene& scene,
                                                 const nmbc::MatchingTable& left,
                                                 const nmbc::MatchingTable& right, double cfl) {
    for (const Boundary& boundary : {scene.left, scene.right}) {
        if (!has_certificate(boundary.kind)) {
            return fmt::format("there is no certificate for a chain with {} end",
                               boundary.kind == BoundaryKind::mbc ? "an mbc" : "a higdon");
        }
    }
    if (adds_no_energy(scene.left.kind) && adds_no_energy(scene.right.kind)) {
        return "";
    }
    const auto has_known_waves = [](BoundaryKind kind) {
        return kind == BoundaryKind::nmbc || kind == BoundaryKind::fixed ||
               kind == BoundaryKind::free || kind == BoundaryKind::extended;
    };
    if (has_known_waves(scene.left.kind) && has_known_waves(scene.right.kind)) {
        return std::nullopt;
    }
    const bool on_the_left = scene.left.kind == BoundaryKind::nmbc;
    const Boundary& matching = on_the_left ? scene.left : scene.right;
    const double certified = nmbc::certified_cfl(on_the_left ? left : right, scene.G,
                                                 matching.ghosts, nmbc::Opposite::any);
    constexpr double roundings = 1e-12;  // cfl was a time step on its way here
    if (cfl <= certified * (1 + roundings)) {
        return "";
    }
    return fmt::format(
        "{} is certified against {} {} at n = {}, G = {}{}; cfl = {:.3g}", name_of(matching),
        name_of(on_the_left ? scene.right : scene.left),
        certified > 0 ? fmt::format("up to cfl = {:.3g} only", certified) : "at no time step",
        scene.horizon, scene.G, is_damped(scene) ? ", tau = " + scene.tau : "", cfl);
}

}  // namespace

std::string objection(const Scene& scene, const nmbc::MatchingTable& left,
                      const nmbc::MatchingTable& right, double time_step, double cfl) {
    if (const auto decided = decided_without_waves(scene, left, right, cfl)) {
        return *decided;
    }
    const double c = std::sqrt(scene.youngs_modulus / scene.density);
    const double step = time_step * c / scene.spacing;  // in dX/c
    const auto verdict =
        round_trip_verdict(end_of(scene.left, left, scene.G, step),
                           end_of(scene.right, right, scene.G, step), moving_nodes(scene));
    const Boundary& own = verdict.left ? scene.left : scene.right;
    const std::string alone = name_of(own) + " is not stable";
    const std::string together = scene.left == scene.right
                                     ? name_of(own) + " at both ends is not stable"
                                     : fmt::format(
                                           "{} on the left and {} on the right are not "
                                           "stable together",
                                           name_of(scene.left), name_of(scene.right));
    const std::string where =
        fmt::format(" at n = {}, G = {}{}, cfl = {:.3g}: ", scene.horizon, scene.G,
                    is_damped(scene) ? ", tau = " + scene.tau : "", cfl);
    switch (verdict.failure) {
        case nmbcgen::ModalFailure::growing_mode:
            return alone + where +
                   fmt::format("a mode at that end grows as exp({:.3g} t)",
                               growth_per_step(own, verdict.growth, step) / time_step);
        case nmbcgen::ModalFailure::resonance:
            return alone + where +
                   fmt::format("that end sends out a wave of xi dX = {:.3g} by itself",
                               verdict.wave_number);
        case nmbcgen::ModalFailure::amplified_wave:
            return together + where +
                   fmt::format(
                       "waves of the frequency of xi dX = {:.3g} can grow by {:.3g} % per round "
                       "trip{}",
                       verdict.wave_number, 100 * (verdict.amplification - 1),
                       is_damped(scene)
                           ? fmt::format(" in a chain of {} nodes", moving_nodes(scene))
                           : "");
        default:
            break;
    }
    const double rate = short_chain_growth(scene, left, right, step);
    return rate > 0 ? together + where +
                          fmt::format(
                              "in a chain of {} nodes, so short that decaying waves reach "
                              "the other end, it grows as exp({:.3g} t)",
                              moving_nodes(scene), rate * step / time_step)
                    : "";
}

}  // namespace nmbcrun
