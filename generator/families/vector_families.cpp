// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>

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

std::vector<Offset> neighbours_in_plane(unsigned radius_squared) {
    const auto bound = int(radius_squared);
    std::vector<Offset> offsets;
    bool is_reached = false;
    for (int i = -bound; i <= bound; ++i) {
        for (int j = -bound; j <= bound; ++j) {
            const int square = i * i + j * j;
            if (square > 0 && square <= bound) {
                offsets.push_back({i, j, 0});
                is_reached = is_reached || square == bound;
            }
        }
    }
    if (!is_reached) {
        unsigned lower = 0;
        for (const Offset& offset : offsets) {
            lower = std::max(lower, unsigned(offset[0] * offset[0] + offset[1] * offset[1]));
        }
        throw NoSuchModel(fmt::format(
            "no node of the square lattice is at a distance of {} squared: it is no sum "
            "of two squares. The radius below is {}",
            radius_squared, lower));
    }
    return offsets;
}

std::vector<Offset> bond_classes_in_plane(unsigned radius_squared) {
    std::vector<Offset> classes = neighbours_in_plane(radius_squared);
    std::erase_if(classes, [](const Offset& bond) { return bond[1] < 0 || bond[0] < bond[1]; });
    std::ranges::sort(classes, [](const Offset& one, const Offset& other) {
        const auto length = [](const Offset& bond) {
            return bond[0] * bond[0] + bond[1] * bond[1];
        };
        return length(one) != length(other) ? length(one) < length(other) : one[0] > other[0];
    });
    return classes;
}

}  // namespace nmbcgen
