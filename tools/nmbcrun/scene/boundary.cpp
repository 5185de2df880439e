// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/scene/boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace nmbcrun {
namespace {

constexpr double sponge_target = 1e-2;
constexpr double pml_target = 1e-4;

const std::vector<std::pair<BoundaryKind, nmbc::Closure>> surfaces{
    {BoundaryKind::mirror, nmbc::Closure::mirror},
    {BoundaryKind::snm, nmbc::Closure::surface_node},
    {BoundaryKind::sbp, nmbc::Closure::sbp},
    {BoundaryKind::kernel, nmbc::Closure::kernel},
    {BoundaryKind::cut, nmbc::Closure::cut},
    {BoundaryKind::node_mirror, nmbc::Closure::node_mirror}};

/// In words.
std::string_view name_of(nmbc::Closure closure) {
    switch (closure) {
        case nmbc::Closure::surface_node:
            return "surface node";
        case nmbc::Closure::sbp:
            return "summation by parts";
        case nmbc::Closure::kernel:
            return "convex kernels";
        case nmbc::Closure::cut:
            return "cut";
        case nmbc::Closure::node_mirror:
            return "mirror through the outermost node";
        case nmbc::Closure::mirror:
            break;
    }
    return "mirror";
}

}  // namespace

const std::vector<std::pair<std::string_view, BoundaryKind>>& boundary_kinds() {
    static const std::vector<std::pair<std::string_view, BoundaryKind>> kinds{
        {"nmbc", BoundaryKind::nmbc},
        {"fixed", BoundaryKind::fixed},
        {"free", BoundaryKind::free},
        {"mirror", BoundaryKind::mirror},
        {"node_mirror", BoundaryKind::node_mirror},
        {"snm", BoundaryKind::snm},
        {"sbp", BoundaryKind::sbp},
        {"kernel", BoundaryKind::kernel},
        {"cut", BoundaryKind::cut},
        {"extended", BoundaryKind::extended},
        {"exact", BoundaryKind::exact},
        {"sponge", BoundaryKind::sponge},
        {"pml", BoundaryKind::pml},
        {"passive", BoundaryKind::passive},
        {"higdon", BoundaryKind::higdon},
        {"truncated", BoundaryKind::truncated}};
    return kinds;
}

std::vector<std::string_view> keys_of(BoundaryKind kind) {
    switch (kind) {
        case BoundaryKind::nmbc:
        case BoundaryKind::truncated:
            return {"order", "stride", "ghosts", "matched_step"};
        case BoundaryKind::higdon:
            return {"order"};
        case BoundaryKind::extended:
            return {"layer"};
        case BoundaryKind::sponge:
        case BoundaryKind::pml:
            return {"layer", "profile", "target"};
        case BoundaryKind::mirror:
        case BoundaryKind::snm:
        case BoundaryKind::sbp:
        case BoundaryKind::kernel:
        case BoundaryKind::cut:
        case BoundaryKind::node_mirror:
            return {"given"};
        case BoundaryKind::fixed:
        case BoundaryKind::free:
        case BoundaryKind::exact:
        case BoundaryKind::passive:
            break;
    }
    return {};
}

bool counts(std::string_view key, BoundaryKind kind) {
    const auto keys = keys_of(kind);
    return std::ranges::find(keys, key) != keys.end();
}

std::string_view name_of(BoundaryKind kind) {
    return std::ranges::find(boundary_kinds(), kind,
                             &std::pair<std::string_view, BoundaryKind>::second)
        ->first;
}

bool is_physical(BoundaryKind kind) {
    return kind == BoundaryKind::fixed || kind == BoundaryKind::free || is_surface(kind);
}

bool is_surface(BoundaryKind kind) {
    return std::ranges::find(surfaces, kind, &std::pair<BoundaryKind, nmbc::Closure>::first) !=
           surfaces.end();
}

bool is_closure(BoundaryKind kind) {
    return is_surface(kind) && kind != BoundaryKind::mirror && kind != BoundaryKind::node_mirror;
}

bool is_free(const Boundary& boundary) {
    return boundary.kind == BoundaryKind::free ||
           (boundary.kind == BoundaryKind::mirror && boundary.given == nmbc::OnSurface::traction);
}

nmbc::Closure closure_of(BoundaryKind kind) {
    const auto found =
        std::ranges::find(surfaces, kind, &std::pair<BoundaryKind, nmbc::Closure>::first);
    if (found == surfaces.end()) {
        throw std::logic_error("this end is no surface");
    }
    return found->second;
}

bool has_layer(BoundaryKind kind) {
    return counts("layer", kind);
}

bool has_profile(BoundaryKind kind) {
    return counts("profile", kind);
}

bool adds_no_energy(BoundaryKind kind) {
    return !takes_table(kind) && kind != BoundaryKind::higdon;
}

bool takes_table(BoundaryKind kind) {
    return kind == BoundaryKind::nmbc || kind == BoundaryKind::truncated;
}

bool has_certificate(BoundaryKind kind) {
    return kind == BoundaryKind::nmbc || adds_no_energy(kind);
}

double target_of(const Boundary& boundary) {
    return boundary.target.value_or(boundary.kind == BoundaryKind::sponge ? sponge_target
                                                                          : pml_target);
}

std::string heading_of(const Boundary& boundary) {
    switch (boundary.kind) {
        case BoundaryKind::extended:
            return boundary.layer > 0 ? fmt::format("extended by {} nodes", boundary.layer)
                                      : "extended until nothing returns";
        case BoundaryKind::sponge:
        case BoundaryKind::pml:
            return fmt::format("{} of {} nodes, profile {}, target {}", name_of(boundary.kind),
                               boundary.layer, boundary.profile, target_of(boundary));
        case BoundaryKind::higdon:
            return fmt::format("higdon of order {}", boundary.order);
        case BoundaryKind::mirror:
        case BoundaryKind::snm:
        case BoundaryKind::sbp:
        case BoundaryKind::kernel:
        case BoundaryKind::cut:
        case BoundaryKind::node_mirror:
            return fmt::format("{} {}{}", name_of(closure_of(boundary.kind)),
                               boundary.given == nmbc::OnSurface::traction ? "under a traction"
                                                                           : "at a displacement",
                               boundary.value ? " in time" : " of 0");
        case BoundaryKind::fixed:
        case BoundaryKind::free:
        case BoundaryKind::exact:
        case BoundaryKind::passive:
            return std::string(name_of(boundary.kind));
        case BoundaryKind::nmbc:
        case BoundaryKind::truncated:
            break;
    }
    const bool midpoint = boundary.ghosts == nmbc::GhostRule::midpoint;
    return fmt::format("{}{}, stride {}, {} ghosts{}",
                       boundary.kind == BoundaryKind::nmbc ? "NMBC" : "truncated MBC",
                       boundary.order, boundary.stride, midpoint ? "midpoint" : "explicit",
                       boundary.matched_step == "0"
                           ? std::string()
                           : ", matched in steps of " + boundary.matched_step + " dX/c");
}

}  // namespace nmbcrun
