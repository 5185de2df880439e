// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/side_prospect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "tools/nmbcrun/plane/plane_lattice.hpp"

namespace nmbcrun {
namespace {

/// The kinds of the scene's sides that are such, each once.
template <class IsSuch>
std::vector<std::string_view> kinds_of(const PlaneScene& scene, const IsSuch& is_such) {
    std::vector<std::string_view> names;
    for (const auto& [name, kind] : side_kinds()) {
        if (scene.has(kind) && is_such(kind)) {
            names.push_back(name);
        }
    }
    return names;
}

/// What a straight passive side sends back of long waves; empty where that is not known.
std::string return_from(const DesignedPassiveSide& passive) {
    constexpr std::array degrees{0., 5., 10., 15., 20., 25., 30., 35., 40., 45., 60.};
    try {
        const auto parts = nmbcgen::reflected_by_side(passive.task, passive.design, degrees);
        return fmt::format(
            "about {:.1g} of the energy of long waves (xi dX = {:g} to {:g}) that reach passive "
            "sides head-on comes back, {:.1g} at most up to {:g} degrees, {:.1g} at {:g}",
            parts.front(), nmbcgen::long_waves.front(), nmbcgen::long_waves.back(),
            *std::max_element(parts.begin(), parts.end() - 1), degrees[degrees.size() - 2],
            parts.back(), degrees.back());
    } catch (const std::domain_error&) {  // waves that cannot be told from each other
        return "";
    }
}

/// Whether two passive sides meet.
bool has_passive_corner(const PlaneScene& scene) {
    const auto is_passive = [&](std::size_t side) {
        return scene.sides[side].kind == SideKind::passive;
    };
    return (is_passive(0) || is_passive(1)) && (is_passive(2) || is_passive(3));
}

/// The fewest nodes of an extended side that is given them; 0: none is.
std::size_t least_layer(const PlaneScene& scene) {
    std::size_t least = 0;
    for (const PlaneSideChoice& side : scene.sides) {
        if (side.kind == SideKind::extended && side.layer > 0) {
            least = least == 0 ? side.layer : std::min(least, side.layer);
        }
    }
    return least;
}

std::string return_from_far_ends(const PlaneScene& scene, std::size_t layer) {
    const double speed = rate_of(scene) * model_of(scene).speed_P();  // [dX/time]
    const double there_and_back = 2 * double(layer) / speed;
    if (layer == 0 || there_and_back >= scene.end) {
        return "nothing comes back from extended sides before time.end";
    }
    return fmt::format(
        "all comes back from the far ends of extended sides, P waves {:.3g} after "
        "they have passed the side",
        there_and_back);
}

}  // namespace

std::string evidence_of(const PlaneScene& scene) {
    if (const auto kinds = kinds_of(scene, may_grow); !kinds.empty()) {
        return fmt::format("not proved: sides of kind {} may feed energy in",
                           fmt::join(kinds, ", "));
    }
    if (scene.is_bond_based() && !nmbc::is_positive(bonds_of(scene)) &&
        (scene.has(SideKind::free) || scene.fracture)) {
        return "not proved: where bonds with weights below 0 end or break, energy is no sum of "
               "squares";
    }
    return "by construction";
}

std::string prospect_of(const PlaneScene& scene,
                        const std::optional<DesignedPassiveSide>& passive) {
    std::vector<std::string> parts;
    // It is not known what damping does to passive sides.
    const std::string from_passive = passive && scene.tau == 0 ? return_from(*passive) : "";
    if (!from_passive.empty()) {
        parts.push_back(from_passive + (has_passive_corner(scene) ? ", more near corners" : ""));
    }
    const std::size_t layer = least_layer(scene);
    const bool fades = layer > 0 && scene.tau != 0;  // on its way there and back
    if (scene.has(SideKind::extended) && !fades) {
        parts.push_back(return_from_far_ends(scene, layer));
    }
    const auto is_unknown = [&](SideKind kind) {
        return is_artificial(kind) && !(kind == SideKind::extended && !fades) &&
               !(kind == SideKind::passive && !from_passive.empty());
    };
    if (const auto kinds = kinds_of(scene, is_unknown); !kinds.empty()) {
        parts.push_back(
            fmt::format("nothing is predicted of sides of kind {}: nmbcrun verify measures it",
                        fmt::join(kinds, ", ")));
    }
    return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace nmbcrun
