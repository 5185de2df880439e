// SPDX-License-Identifier: MIT
#include "generator/passive/side_layers.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "generator/families/vector_family.hpp"

namespace nmbcgen {

std::size_t least_side_layers(const VectorChoice& choice) {
    return 2 * std::size_t(horizon_of(choice));
}

std::size_t side_layers_checked(const VectorChoice& choice, std::size_t layers) {
    const std::size_t least = least_side_layers(choice);
    constexpr std::size_t quick = 16;
    const std::size_t most = std::max(least, quick);
    if (layers < least || layers > most) {
        std::ostringstream text;
        text << "a passive side of this family has " << least << " to " << most << " layers, not "
             << layers;
        throw std::invalid_argument(text.str());
    }
    return layers;
}

}  // namespace nmbcgen
