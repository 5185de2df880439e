// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/cut_families.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace nmbcrun {
namespace {

using Square = nmbc::Lattice::Square;

/// A square's entries on offsets -n .. n from its node.
using Stencil = std::vector<double>;

/// The strain of a node whose family is the offsets first .. n.
Stencil strain_of(int first, int n) {
    double shape = 0;
    for (int j = first; j <= n; ++j) {
        shape += j * j;
    }
    Stencil strain(std::size_t(2 * n + 1));
    for (int j = first; j <= n; ++j) {
        strain[std::size_t(n + j)] += j / shape;
        strain[std::size_t(n)] -= j / shape;
    }
    return strain;
}

}  // namespace

std::vector<Square> squares_of(int first, int n, double G) {
    const Stencil strain = strain_of(first, n);
    std::vector<Square> squares{{nmbc::EnergyPart::strain, 1, strain}};
    for (int bond = first; bond <= n && G > 0; ++bond) {
        if (bond == 0) {
            continue;
        }
        Stencil state(strain.size());
        std::ranges::transform(strain, state.begin(), [&](double entry) { return -bond * entry; });
        state[std::size_t(n + bond)] += 1;
        state[std::size_t(n)] -= 1;
        squares.push_back({nmbc::EnergyPart::stabilisation, 2 * G / (n * n * n * double(n - first)),
                           std::move(state)});
    }
    return squares;
}

double stabilisation_of(const nmbc::Lattice& lattice) {
    const auto n = int(lattice.reach() / 2);
    double G = 0;
    for (const Square& square : lattice.energy) {
        if (square.part == nmbc::EnergyPart::stabilisation) {
            G = square.weight * std::pow(n, 4);
        }
    }
    const auto alike = [](double a, double b) {
        return std::abs(a - b) <= 1e-14 * std::abs(a) + 1e-15;
    };
    const auto squares = squares_of(-n, n, G);
    const bool known = lattice.reach() == std::size_t(2 * n) &&
                       std::ranges::is_permutation(
                           squares, lattice.energy, [&](const Square& one, const Square& other) {
                               return one.part == other.part && alike(one.weight, other.weight) &&
                                      std::ranges::equal(one.stencil, other.stencil, alike);
                           });
    if (!known || !lattice.damping.empty()) {
        throw std::invalid_argument(
            "boundary.kind \"truncated\" and \"passive\" know model.family = \"nopd1d\" of "
            "constant "
            "model.influence without damping, "
            "no other lattice");
    }
    return G;
}

}  // namespace nmbcrun
