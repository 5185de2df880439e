// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <stdexcept>

#include "generator/exact/symbol.hpp"
#include "generator/families/family.hpp"

namespace nmbcgen {

std::span<const Family> families() {
    static constexpr std::array list{
        Family{"nopd1d", nopd1d},
    };
    return list;
}

Model make_model(std::string_view family, unsigned horizon) {
    const auto known = families();
    const auto found = std::ranges::find(known, family, &Family::name);
    if (found == known.end()) {
        throw std::invalid_argument("there is no family '" + std::string(family) + "'");
    }
    Model model = found->describe(horizon);
    model.symbol = symbol_of(model.energy);
    return model;
}

}  // namespace nmbcgen
