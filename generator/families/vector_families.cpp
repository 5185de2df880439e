// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "generator/families/family.hpp"
#include "generator/families/vector_family.hpp"

namespace nmbcgen {

std::span<const VectorFamily> vector_families() {
    static constexpr std::array list{
        VectorFamily{.name = "nopd2d",
                     .has_poisson = true,
                     .has_weights = false,
                     .has_stabilisation = true,
                     .describe = nopd2d,
                     .at_edge = nopd2d_at_edge,
                     .largest_beta = nopd2d_largest_beta,
                     .limit = nopd2d_limit},
        VectorFamily{.name = "bond2d",
                     .has_poisson = false,
                     .has_weights = true,
                     .has_stabilisation = false,
                     .describe = bond2d,
                     .at_edge = bond2d_at_edge,
                     .largest_beta = [](const VectorChoice&) { return Rational(0); }},
        VectorFamily{.name = "lps2d",
                     .has_poisson = true,
                     .has_weights = true,
                     .has_stabilisation = false,
                     .describe = lps2d},
        VectorFamily{.name = "bond3d",
                     .dimensions = 3,
                     .has_poisson = false,
                     .has_weights = true,
                     .has_stabilisation = false,
                     .describe = bond3d},
        VectorFamily{.name = "lps3d",
                     .dimensions = 3,
                     .has_poisson = true,
                     .has_weights = true,
                     .has_stabilisation = false,
                     .largest_radius_squared = 12,
                     .describe = lps3d},
    };
    return list;
}

const VectorFamily* vector_family(std::string_view name) {
    const auto known = vector_families();
    const auto found = std::ranges::find(known, name, &VectorFamily::name);
    return found == known.end() ? nullptr : &*found;
}

const VectorFamily& find_vector_family(std::string_view name) {
    const VectorFamily* const found = vector_family(name);
    if (found == nullptr) {
        throw NoSuchModel("there is no plane family '" + std::string(name) + "'");
    }
    return *found;
}

std::vector<Offset> neighbours(unsigned radius_squared, std::size_t dimensions) {
    const auto bound = int(std::sqrt(double(radius_squared)));
    const int bound_z = dimensions == 3 ? bound : 0;
    std::vector<Offset> offsets;
    unsigned farthest = 0;
    for (int i = -bound; i <= bound; ++i) {
        for (int j = -bound; j <= bound; ++j) {
            for (int k = -bound_z; k <= bound_z; ++k) {
                const unsigned square = length_squared({i, j, k});
                if (square > 0 && square <= radius_squared) {
                    offsets.push_back({i, j, k});
                    farthest = std::max(farthest, square);
                }
            }
        }
    }
    if (farthest != radius_squared) {
        throw NoSuchModel(
            fmt::format("no node of the {} lattice is at a distance of {} squared: it is no sum "
                        "of {} squares. The radius below is {}",
                        dimensions == 3 ? "cubic" : "square", radius_squared,
                        dimensions == 3 ? "three" : "two", farthest));
    }
    return offsets;
}

std::vector<Offset> neighbours_in_plane(unsigned radius_squared) {
    return neighbours(radius_squared, 2);
}

unsigned length_squared(const Offset& offset) {
    return unsigned(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
}

Offset class_of(const Offset& bond) {
    Offset sorted{std::abs(bond[0]), std::abs(bond[1]), std::abs(bond[2])};
    std::ranges::sort(sorted, std::greater<>());
    return sorted;
}

std::vector<Offset> bond_classes(unsigned radius_squared, std::size_t dimensions) {
    std::vector<Offset> classes = neighbours(radius_squared, dimensions);
    std::erase_if(classes, [](const Offset& bond) { return bond != class_of(bond); });
    std::ranges::sort(classes, [](const Offset& one, const Offset& other) {
        return length_squared(one) != length_squared(other)
                   ? length_squared(one) < length_squared(other)
                   : one > other;
    });
    return classes;
}

std::vector<Offset> bond_classes_in_plane(unsigned radius_squared) {
    return bond_classes(radius_squared, 2);
}

const Rational& weight_of(const Offset& bond, std::span<const Offset> classes,
                          std::span<const Rational> weights) {
    return weights[std::size_t(std::ranges::find(classes, class_of(bond)) - classes.begin())];
}

void require_weights(std::span<const Offset> classes, std::span<const Rational> weights,
                     bool may_be_negative) {
    const bool fit = weights.size() == classes.size() &&
                     std::ranges::none_of(weights, [&](const Rational& weight) {
                         return weight == 0 || (weight < 0 && !may_be_negative);
                     });
    if (fit) {
        return;
    }
    std::string list;
    for (const Offset& bond : classes) {
        const bool in_plane = bond[2] == 0 && classes.back()[2] == 0;
        list += list.empty() ? "" : ", ";
        list += in_plane ? fmt::format("({}, {})", bond[0], bond[1])
                         : fmt::format("({}, {}, {})", bond[0], bond[1], bond[2]);
    }
    throw NoSuchModel(fmt::format("{} weights are needed, {}: of the bonds {}", classes.size(),
                                  may_be_negative ? "none of them 0" : "all above 0", list));
}

}  // namespace nmbcgen
