// SPDX-License-Identifier: MIT
#include "generator/families/bond_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nmbcgen {
namespace {

void add(SymmetricMatrix& sum, double factor, double i, double j) {
    sum.xx += factor * i * i;
    sum.xy += factor * i * j;
    sum.yy += factor * j * j;
}

}  // namespace

std::vector<Offset> members_of_class(const Offset& bond) {
    std::vector<Offset> members;
    const auto [i, j, none] = bond;
    for (const auto& [x, y] : {std::array{i, j}, std::array{j, i}}) {
        for (const int right : {1, -1}) {
            for (const int up : {1, -1}) {
                members.push_back({right * x, up * y, 0});
            }
        }
    }
    std::ranges::sort(members);
    members.erase(std::unique(members.begin(), members.end()), members.end());
    return members;
}

std::array<double, 2> SymmetricMatrix::eigenvalues() const {
    const double middle = (xx + yy) / 2;
    const double half = std::hypot((xx - yy) / 2, xy);
    return {middle + half, middle - half};
}

BondLattice::BondLattice(std::span<const Offset> classes, std::span<const double> weights) {
    for (std::size_t a = 0; a < classes.size(); ++a) {
        for (const auto& [i, j, none] : members_of_class(classes[a])) {
            bonds_.push_back({weights[a], double(i), double(j)});
        }
    }
}

SymmetricMatrix BondLattice::at(double k_x, double k_y) const {
    SymmetricMatrix sum;
    for (const auto& [weight, i, j] : bonds_) {
        add(sum, weight * (1 - std::cos(k_x * i + k_y * j)), i, j);
    }
    return sum;
}

SymmetricMatrix BondLattice::of_long_waves(double radians) const {
    SymmetricMatrix sum;
    for (const auto& [weight, i, j] : bonds_) {
        const double along = i * std::cos(radians) + j * std::sin(radians);
        add(sum, weight * along * along / 2, i, j);
    }
    return sum;
}

double BondLattice::least_squared_speed() const {
    constexpr int steps = 128;
    constexpr double spacing = std::numbers::pi / steps;
    double least = HUGE_VAL;
    for (int y = 0; y <= steps; ++y) {
        least = std::min(least, of_long_waves(spacing * y / 4).eigenvalues()[1]);  // to 45 degrees
        for (int x = std::max(y, 1); x <= steps; ++x) {
            const double k_x = spacing * x;
            const double k_y = spacing * y;
            least = std::min(least, at(k_x, k_y).eigenvalues()[1] / (k_x * k_x + k_y * k_y));
        }
    }
    return least;
}

}  // namespace nmbcgen
