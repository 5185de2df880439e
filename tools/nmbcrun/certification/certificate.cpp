// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/certification/certificate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <nmbc/certificate.hpp>
#include <nmbc/lattice.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "generator/stability/discrete.hpp"
#include "generator/stability/round_trip.hpp"
#include "tools/nmbcrun/certification/half_space.hpp"
#include "tools/nmbcrun/ends/half_line.hpp"

namespace nmbcrun {
namespace {

/// in_time: the end's table in continuous time.
nmbcgen::LatticeEnd end_of(const Boundary& boundary, const nmbcgen::HalfSpace& in_time,
                           double time_step) {
    // A fixed or free end is the same in any steps, but in a damped lattice the waves are not.
    const auto half_space = stepped(in_time, time_step);
    if (boundary.kind == BoundaryKind::fixed || boundary.kind == BoundaryKind::extended) {
        return fixed_end(half_space);
    }
    if (is_free(boundary)) {
        return free_end(half_space);
    }
    // nmbc; decided_without_waves() knows the others
    return {nmbcgen::LatticeEnd::Kind::matching, half_space};
}

struct Ends {
    nmbcgen::LatticeEnd left;
    nmbcgen::LatticeEnd right;
};

Ends ends_of(const Scene& scene, const nmbcgen::HalfSpace& left, const nmbcgen::HalfSpace& right,
             double time_step) {
    return {end_of(scene.left, left, time_step), end_of(scene.right, right, time_step)};
}

/// ln |zeta| of the factor zeta of one time step [dX/c], whose sigma this is (half_space.hpp).
double growth_per_step(std::complex<double> sigma, double time_step) {
    const std::complex<double> half = sigma * time_step / 2.0;
    return std::log(std::abs((1.0 + half) / (1.0 - half)));
}

std::size_t moving_nodes(const Scene& scene) {
    std::size_t nodes = scene.nodes;
    for (const Boundary& boundary : {scene.left, scene.right}) {
        nodes += has_layer(boundary.kind) ? boundary.layer : 0;
    }
    return nodes;
}

/// Of an end whose eigenvalues and round trips are looked at.
bool has_known_waves(const Boundary& boundary) {
    return boundary.kind == BoundaryKind::nmbc || boundary.kind == BoundaryKind::fixed ||
           boundary.kind == BoundaryKind::extended || is_free(boundary);
}

/// Growth [c/dX] by the largest eigenvalue of one step, in chains so short that the half spaces do
/// not tell all; 0 in longer ones, or where nothing grows.
double short_chain_growth(const Scene& scene, const Ends& ends, double time_step) {
    if (!has_eigenvalues(scene)) {
        return 0;
    }
    const double radius =
        nmbcgen::spectral_radius(ends.left, ends.right, moving_nodes(scene), time_step);
    constexpr double roundings = 1e-7;  // a double eigenvalue 1 splits by their square root
    return radius > 1 + roundings ? std::log(radius) / time_step : 0;
}

std::string name_of(const Boundary& boundary) {
    if (!takes_table(boundary.kind)) {
        const auto kind = name_of(boundary.kind);
        return fmt::format("{} {} end",
                           kind.starts_with('e') || kind == "snm" || kind == "sbp" ? "an" : "a",
                           kind);
    }
    return fmt::format(
        "{}{}{}", boundary.kind == BoundaryKind::truncated ? "truncated MBC" : "NMBC",
        boundary.order, boundary.stride > 1 ? fmt::format(" of stride {}", boundary.stride) : "");
}

/// " at n = .., G = .."
std::string place_of(const Scene& scene) {
    return fmt::format(" at n = {}, G = {}{}", scene.horizon, scene.G,
                       is_damped(scene) ? ", tau = " + scene.tau : "");
}

/// What an end does by itself, in words; empty where it does nothing.
std::string objection_to_one(const Boundary& boundary, nmbcgen::Failure failure,
                             std::complex<double> growth, double wave_number,
                             const std::string& place, double step, double time_step) {
    const std::string alone = name_of(boundary) + " is not stable" + place;
    switch (failure) {
        case nmbcgen::Failure::growing_mode:
            return alone + fmt::format("a mode at that end grows as exp({:.3g} t)",
                                       growth_per_step(growth, step) / time_step);
        case nmbcgen::Failure::resonance:
            return alone + fmt::format("that end sends out a wave of xi dX = {:.3g} by itself",
                                       wave_number);
        default:
            return "";
    }
}

/// What no waves have to be looked at for: explicit ghosts are not certified at all, and some
/// tables not in short steps.
std::string objection_to_tables(const Scene& scene, const nmbc::MatchingTable& left,
                                const nmbc::MatchingTable& right, double cfl) {
    for (const auto& [boundary, table] :
         {std::pair(&scene.left, &left), std::pair(&scene.right, &right)}) {
        if (boundary->kind != BoundaryKind::nmbc) {
            continue;
        }
        if (boundary->ghosts != nmbc::GhostRule::midpoint) {
            return "there is no certificate for explicit ghosts";
        }
        const nmbc::StableStep steps = nmbc::certified_steps(*table, scene.G);
        constexpr double roundings = 1e-12;  // cfl was a time step on its way here
        if (cfl < steps.from * (1 - roundings)) {
            return fmt::format(
                "{} is certified from cfl = {:.3g} to {:.3g}{}, since a mode of its own grows in "
                "some shorter steps; cfl = {:.3g}",
                name_of(*boundary), steps.from, steps.cfl, place_of(scene), cfl);
        }
    }
    return "";
}

/// A surface node sends a wave back whole where it is the only one of its frequency.
bool has_one_wave_everywhere(const nmbc::Lattice& lattice) {
    const std::size_t samples = 64 * lattice.reach();  // 64 to each maximum that there may be
    for (std::size_t i = 1; i < samples; ++i) {
        const double xi = std::numbers::pi * double(i) / double(samples);
        if (nmbc::omega_squared_slope(lattice, xi) <= 0) {
            return false;
        }
    }
    return true;
}

/// The objection where the waves of the two ends need not be looked at: none between ends that add
/// no energy, none to an nmbc at a step where it is certified for any such end. Nothing where they
/// have to be: between two nmbc, and against ends whose reflections are known.
std::optional<std::string> decided_without_waves(const Scene& scene, const nmbc::Lattice& lattice,
                                                 const nmbc::MatchingTable& left,
                                                 const nmbc::MatchingTable& right, double cfl) {
    const bool has_surface_node =
        scene.left.kind == BoundaryKind::snm || scene.right.kind == BoundaryKind::snm;
    if (has_surface_node && !has_one_wave_everywhere(lattice)) {
        return "there is no certificate for a surface node where several waves have one frequency";
    }
    for (const Boundary& boundary : {scene.left, scene.right}) {
        if (!has_certificate(boundary.kind)) {
            return fmt::format(
                "there is no certificate for a chain with {} end",
                boundary.kind == BoundaryKind::truncated ? "a truncated" : "a higdon");
        }
    }
    if (adds_no_energy(scene.left.kind) && adds_no_energy(scene.right.kind)) {
        return "";
    }
    if (has_known_waves(scene.left) && has_known_waves(scene.right)) {
        return std::nullopt;
    }
    const bool on_the_left = scene.left.kind == BoundaryKind::nmbc;
    const Boundary& matching = on_the_left ? scene.left : scene.right;
    const double certified =
        nmbc::certified_cfl(on_the_left ? left : right, scene.G, nmbc::Opposite::any);
    constexpr double roundings = 1e-12;  // cfl was a time step on its way here
    if (cfl <= certified * (1 + roundings)) {
        return "";
    }
    return fmt::format(
        "{} is certified against {} {}{}; the step has cfl = {:.3g}", name_of(matching),
        name_of(on_the_left ? scene.right : scene.left),
        certified > 0 ? fmt::format("up to cfl = {:.3g} only", certified) : "at no time step",
        place_of(scene), cfl);
}

/// The nmbc that stands alone on a half line, since what goes out at the other end does not come
/// back: waves are reflected by it once, however much it adds to them. nullptr where there is none.
const Boundary* alone_on_a_half_line(const Scene& scene, const nmbc::Lattice& lattice,
                                     double step) {
    for (const auto& [end, opposite] :
         {std::pair(&scene.left, &scene.right), std::pair(&scene.right, &scene.left)}) {
        if (end->kind == BoundaryKind::nmbc && is_half_line(scene, *opposite, lattice, step)) {
            return end;
        }
    }
    return nullptr;
}

}  // namespace

bool is_short(const Scene& scene) {
    constexpr std::size_t longest = 60;  // tests/stability/exam_short_chains.cpp: 25 are short
    return moving_nodes(scene) <= longest;
}

bool has_eigenvalues(const Scene& scene) {
    // Of a damped lattice round trips tell all.
    return is_short(scene) && !is_damped(scene) && has_known_waves(scene.left) &&
           has_known_waves(scene.right);
}

PairOfEnds::PairOfEnds(const Scene& scene, const nmbc::MatchingTable& left,
                       const nmbc::MatchingTable& right)
    : scene_(scene), left_{left, {}}, right_{right, {}}, lattice_(make_lattice(left, scene.G)) {}

const nmbcgen::HalfSpace& PairOfEnds::in_time(InTime& end) const {
    if (!end.half_space) {
        end.half_space = half_space_of(end.table, scene_.G);
    }
    return *end.half_space;
}

std::string PairOfEnds::objection(double time_step, double cfl) {
    const Scene& scene = scene_;
    const double step = time_step / unit_of_time(scene);  // in dX/c
    if (std::string known = objection_to_tables(scene, left_.table, right_.table, cfl);
        !known.empty()) {
        return known;
    }
    const std::string place = fmt::format("{}, cfl = {:.3g}: ", place_of(scene), cfl);
    if (const Boundary* own = alone_on_a_half_line(scene, lattice_, step)) {
        const auto verdict = verdict_without_incident_waves(
            end_of(*own, in_time(own == &scene.left ? left_ : right_), step).half_space);
        return objection_to_one(*own, verdict.failure, verdict.growth, verdict.wave_number, place,
                                step, time_step);
    }
    if (const auto decided =
            decided_without_waves(scene, lattice_, left_.table, right_.table, cfl)) {
        return *decided;
    }
    const double longer = step * (cfl < 0.999 ? nmbcgen::off_the_edge : 1);
    const Ends ends = ends_of(scene, in_time(left_), in_time(right_), longer);
    const auto verdict = round_trip_verdict(ends.left, ends.right, moving_nodes(scene));
    std::string alone =
        objection_to_one(verdict.left ? scene.left : scene.right, verdict.failure, verdict.growth,
                         verdict.wave_number, place, step, time_step);
    if (!alone.empty()) {
        return alone;
    }
    const std::string together = scene.left == scene.right
                                     ? name_of(scene.left) + " at both ends is not stable"
                                     : fmt::format(
                                           "{} on the left and {} on the right are not "
                                           "stable together",
                                           name_of(scene.left), name_of(scene.right));
    if (verdict.failure == nmbcgen::Failure::amplified_wave) {
        const double growth = 100 * (verdict.amplification - 1);
        constexpr double sampled = 1e-9;  // [%]
        return together + place +
               (growth > sampled
                    ? fmt::format(
                          "waves of the frequency of xi dX = {:.3g} can grow by {:.3g} % per round "
                          "trip",
                          verdict.wave_number, growth)
                    : "waves in less than a billionth of the band are not known not to grow") +
               (is_damped(scene) ? fmt::format(" in a chain of {} nodes", moving_nodes(scene))
                                 : "");
    }
    const double rate = short_chain_growth(scene, ends, step);
    return rate > 0 ? together + place +
                          fmt::format(
                              "in a chain of {} nodes, so short that decaying waves reach "
                              "the other end, it grows as exp({:.3g} t)",
                              moving_nodes(scene), rate * step / time_step)
                    : "";
}

}  // namespace nmbcrun
