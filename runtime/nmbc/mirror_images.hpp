// SPDX-License-Identifier: MIT
/// Squares of a lattice's energy and their mirror images.
#pragma once

#include <algorithm>
#include <iterator>
#include <nmbc/lattice.hpp>
#include <vector>

namespace nmbc {

namespace detail {

/// Whether one stencil is the other one read backwards, times this sign.
inline bool is_image(const Lattice::Square& a, const Lattice::Square& b, double sign) {
    return a.part == b.part && a.weight == b.weight &&
           std::equal(a.stencil.begin(), a.stencil.end(), b.stencil.rbegin(), b.stencil.rend(),
                      [=](double left, double right) { return left == sign * right; });
}

}  // namespace detail

/// The same lattice, each of whose squares has its mirror image among them. Where a bond is counted
/// at one of its ends alone, half of it is counted at each from now on.
inline Lattice with_mirror_images(Lattice lattice) {
    std::vector<Lattice::Square*> left;  // without an image so far
    for (Lattice::Square& square : lattice.energy) {
        const auto is_of = [&](const Lattice::Square* other) {
            return detail::is_image(square, *other, 1) || detail::is_image(square, *other, -1);
        };
        const auto image = std::ranges::find_if(left, is_of);
        if (image != left.end()) {
            left.erase(image);
        } else if (!is_of(&square)) {
            left.push_back(&square);
        }
    }
    std::vector<Lattice::Square> images;
    for (Lattice::Square* const square : left) {
        square->weight /= 2;
        images.push_back(*square);
        std::ranges::reverse(images.back().stencil);
    }
    std::ranges::move(images, std::back_inserter(lattice.energy));
    return lattice;
}

}  // namespace nmbc
