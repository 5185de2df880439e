// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/source_region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tools/nmbcrun/errors.hpp"
#include "tools/nmbcrun/plane/source_shares.hpp"
#include "tools/nmbcrun/sources/nodes_within.hpp"
#include "tools/nmbcrun/sources/two_digits.hpp"

namespace nmbcrun {

std::vector<std::size_t> PickedNodes::whole(const std::string& table) const {
    if (shares.empty()) {
        return entries;
    }
    constexpr double roundings = 1e-9;
    std::vector<std::size_t> of_all;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (shares[i] > 1 - roundings && between[i]) {
            of_all.push_back(entries[i]);
        }
    }
    if (of_all.empty()) {
        throw SceneError(table + " moves nodes between which those of this lattice lie");
    }
    return of_all;
}

/// A node on the edge of a region is in it.
double SourceRegion::more() const {
    constexpr double roundings = 1e-9;
    return roundings * scene_.spacing;
}

/// is_within(x, y): so far from the centre along the axes. half_width(x, y): in words, one that
/// reaches so far.
template <class IsWithin, class HalfWidth>
PickedNodes SourceRegion::nodes_where(const IsWithin& is_within, const std::string& table,
                                      const std::array<double, 2>& centre,
                                      const HalfWidth& half_width) const {
    std::vector<bool> chosen;
    for (std::size_t y = 0; y < scene_.nodes[1]; ++y) {
        for (std::size_t x = 0; x < scene_.nodes[0]; ++x) {
            const std::array<double, 2> X = position_of(scene_, x, y);
            chosen.push_back(is_within(X[0] - centre[0], X[1] - centre[1]));
        }
    }
    if (std::ranges::find(chosen, true) == chosen.end()) {
        const NearestNode x = nearest_node(centre[0], scene_.nodes[0], scene_.spacing);
        const NearestNode y = nearest_node(centre[1], scene_.nodes[1], scene_.spacing);
        if (std::max(x.off, y.off) > scene_.spacing) {
            const auto last = position_of(scene_, scene_.nodes[0] - 1, scene_.nodes[1] - 1);
            throw SceneError(
                fmt::format("{} acts on no node of the scene: its nodes are at [{:g}, {:g}] to "
                            "[{:g}, {:g}]",
                            table, scene_.spacing, scene_.spacing, last[0], last[1]));
        }
        throw SceneError(
            fmt::format("{0} acts on no node of the scene: the nearest is at [{1:g}, {2:g}], and "
                        "{0}.half_width = {3} would select it",
                        table, x.at, y.at, half_width(x.off, y.off)));
    }
    return picked(chosen);
}

PickedNodes SourceRegion::within(const std::string& table, const std::array<double, 2>& centre,
                                 double radius) const {
    return nodes_where([&](double x, double y) { return std::hypot(x, y) <= radius + more(); },
                       table, centre,
                       [](double x, double y) {
                           return fmt::format("{:g}", two_digits(std::hypot(x, y), false));
                       });
}

PickedNodes SourceRegion::within(const std::string& table, const std::array<double, 2>& centre,
                                 const std::array<double, 2>& half_width) const {
    const auto reaches = [](double off, double present) {
        return off > present ? two_digits(off, false) : present;
    };
    return nodes_where(
        [&](double x, double y) {
            return std::abs(x) <= half_width[0] + more() && std::abs(y) <= half_width[1] + more();
        },
        table, centre,
        [&](double x, double y) {
            return fmt::format("[{}, {}]", reaches(x, half_width[0]), reaches(y, half_width[1]));
        });
}

/// The nodes chosen, row by row.
PickedNodes SourceRegion::picked(const std::vector<bool>& chosen) const {
    PickedNodes found;
    if (own_.original) {
        const PlaneBody body = body_of(own_, plane_.layers());
        for (const auto& [x, y, share, is_between] : shares_of(own_, body, chosen)) {
            found.entries.push_back(
                plane_.entry(std::size_t(x) + extension_[0], std::size_t(y) + extension_[1]));
            found.shares.push_back(share);
            found.between.push_back(is_between);
        }
        return found;
    }
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (chosen[i]) {
            found.entries.push_back(
                plane_.entry(i % own_.nodes[0] + extension_[0], i / own_.nodes[0] + extension_[1]));
        }
    }
    return found;
}

}  // namespace nmbcrun
