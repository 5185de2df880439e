// SPDX-License-Identifier: MIT
/// Squares of a lattice's energy and their mirror images.
#pragma once

#include <algorithm>
#include <iterator>
#include <nmbc/lattice.hpp>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// Whether one stencil is the other one read backwards, times this sign.
inline bool is_image(const Lattice::Square& a, const Lattice::Square& b, double sign) {
    return a.part == b.part && a.weight == b.weight &&
           std::equal(a.stencil.begin(), a.stencil.end(), b.stencil.rbegin(), b.stencil.rend(),
                      [=](double left, double right) { return left == sign * right; });
}

/// The same lattice, each of whose squares has its mirror image among them. Where a bond is counted
/// at one of its ends alone, half of it is counted at each from now on.
inline Lattice with_mirror_images(Lattice lattice) {
    std::vector<Lattice::Square> images;
    for (Lattice::Square& square : lattice.energy) {
        const bool has_image = std::ranges::any_of(lattice.energy, [&](const auto& other) {
            return is_image(square, other, 1) || is_image(square, other, -1);
        });
        if (!has_image) {
            square.weight /= 2;
            images.push_back(
                {square.part, square.weight, {square.stencil.rbegin(), square.stencil.rend()}});
        }
    }
    std::ranges::move(images, std::back_inserter(lattice.energy));
    return lattice;
}

}  // namespace nmbc::detail
