// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/chart/boundaries.hpp"

#include <fmt/format.h>

#include "tools/nmbcrun/tables/tables.hpp"

namespace nmbcrun {

namespace {

std::vector<NamedBoundary> closures_of(const Scene& scene) {
    std::vector<BoundaryKind> kinds{BoundaryKind::mirror, BoundaryKind::node_mirror};
    const bool has_strains = scene.family.starts_with("nopd");
    kinds.push_back(BoundaryKind::cut);
    kinds.push_back(BoundaryKind::sbp);
    if (has_strains) {
        kinds.push_back(BoundaryKind::kernel);
    } else if (!is_damped(scene)) {
        kinds.push_back(BoundaryKind::snm);
    }
    std::vector<NamedBoundary> all;
    all.reserve(kinds.size());
    for (const BoundaryKind kind : kinds) {
        all.push_back({std::string(name_of(kind)), {.kind = kind}});
    }
    return all;
}

}  // namespace

bool is_closed(const Scene& scene) {
    return is_physical(scene.left.kind) && is_physical(scene.right.kind) &&
           (is_surface(scene.left.kind) || is_surface(scene.right.kind));
}

std::vector<NamedBoundary> boundaries_of(const Scene& scene) {
    if (is_closed(scene)) {
        return closures_of(scene);
    }
    std::vector<NamedBoundary> all{{"fixed", {.kind = BoundaryKind::fixed}},
                                   {"free", {.kind = BoundaryKind::free}}};
    for (const nmbc::MatchingTable* table : tables_of(scene)) {
        if (table->time_step == "0") {
            all.push_back({fmt::format("NMBC{} s{}", table->order, table->stride),
                           {.order = table->order, .stride = table->stride}});
        }
    }
    if (has_constant_influence(scene) && !is_damped(scene)) {
        all.push_back({"passive", {.kind = BoundaryKind::passive}});
        all.push_back({"truncated 1", {.kind = BoundaryKind::truncated, .order = 1}});
    }
    for (const int order : {1, 2, 3, 4}) {
        all.push_back(
            {fmt::format("higdon {}", order), {.kind = BoundaryKind::higdon, .order = order}});
    }
    for (const BoundaryKind kind :
         {BoundaryKind::sponge, BoundaryKind::pml, BoundaryKind::extended}) {
        for (const std::size_t layer : {5U, 10U, 20U, 50U, 100U, 250U}) {
            all.push_back(
                {fmt::format("{} {}", name_of(kind), layer), {.kind = kind, .layer = layer}});
        }
    }
    all.push_back({"extended", {.kind = BoundaryKind::extended}});
    if (!scene.incoming && !scene.preload) {
        all.push_back({"exact", {.kind = BoundaryKind::exact}});
    }
    return all;
}

Scene with_ends(Scene scene, const Boundary& boundary) {
    if (is_closed(scene)) {
        for (Boundary* const end : {&scene.left, &scene.right}) {
            end->kind = is_surface(end->kind) ? boundary.kind : end->kind;
        }
        return scene;
    }
    scene.allow_unstable = true;
    return with_artificial_ends(std::move(scene), boundary);
}

}  // namespace nmbcrun
