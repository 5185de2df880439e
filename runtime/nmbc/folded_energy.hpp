// SPDX-License-Identifier: MIT
/// The squares of a lattice's energy, folded about their node: less work than their stencils.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nmbc/lattice.hpp>
#include <nmbc/mirror_images.hpp>
#include <span>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// How the two nodes at a distance go into a square: as their sum or their difference.
enum class Fold { even, odd };

/// (centre u_I + sum_k factors[k] w_k)^2/2 at node I, its weight multiplied in; w_k by the fold,
/// m = offsets[k] > 0: u_{I+m} + u_{I-m}, u_{I+m} - u_{I-m}.
struct FoldedSquare {
    EnergyPart part{};
    bool is_below_0 = false;  ///< to be taken off
    Fold fold = Fold::even;
    double centre = 0;
    std::vector<std::ptrdiff_t> offsets{};
    std::vector<double> factors{};
};

/// The even or odd part of a square of the energy.
inline FoldedSquare folded(const Lattice::Square& square, double weight, Fold fold) {
    const double root = std::sqrt(std::abs(weight));
    const auto reach = static_cast<std::ptrdiff_t>(square.stencil.size() / 2);
    const auto entry = [&](std::ptrdiff_t m) {
        return root * square.stencil[static_cast<std::size_t>(reach + m)];
    };
    FoldedSquare result{square.part, weight < 0, fold, fold == Fold::odd ? 0 : entry(0)};
    for (std::ptrdiff_t m = 1; m <= reach; ++m) {
        const double factor =
            (fold == Fold::even ? entry(m) + entry(-m) : entry(m) - entry(-m)) / 2;
        if (factor != 0) {
            result.offsets.push_back(m);
            result.factors.push_back(factor);
        }
    }
    return result;
}

/// Makes one square of two whose roots are multiples of each other, up to roundings; whether they
/// are.
inline bool joined(FoldedSquare& a, const FoldedSquare& b) {
    if (a.part != b.part || a.is_below_0 != b.is_below_0 || a.fold != b.fold ||
        a.offsets != b.offsets) {
        return false;
    }
    constexpr double roundings = 1e-14;
    const double ratio = b.factors[0] / a.factors[0];
    const auto is_multiple = [&](double of_a, double of_b) {
        return std::abs(of_b - ratio * of_a) <= roundings * std::abs(of_b);
    };
    if (!is_multiple(a.centre, b.centre) ||
        !std::equal(a.factors.begin(), a.factors.end(), b.factors.begin(), is_multiple)) {
        return false;
    }
    const double both = std::sqrt(1 + ratio * ratio);
    a.centre *= both;
    for (double& factor : a.factors) {
        factor *= both;
    }
    return true;
}

/// Of squares that come with their mirror images. One that is its own is even or odd. Of two images
/// e + o and e - o, e even and o odd, the sum of squares is 2 e^2 + 2 o^2.
inline std::vector<FoldedSquare> folded(std::span<const Lattice::Square> energy) {
    std::vector<FoldedSquare> squares;
    const auto add = [&](const FoldedSquare& square) {
        if (!square.offsets.empty() && std::ranges::none_of(squares, [&](FoldedSquare& other) {
                return joined(other, square);
            })) {
            squares.push_back(square);
        }
    };
    std::vector<const Lattice::Square*> left;
    for (const Lattice::Square& square : energy) {
        left.push_back(&square);
    }
    while (!left.empty()) {
        const Lattice::Square& square = *left.front();
        left.erase(left.begin());
        const auto image = std::ranges::find_if(left, [&](const Lattice::Square* other) {
            return is_image(square, *other, 1) || is_image(square, *other, -1);
        });
        if (is_image(square, square, 1)) {
            add(folded(square, square.weight, Fold::even));
        } else if (is_image(square, square, -1)) {
            add(folded(square, square.weight, Fold::odd));
        } else {
            left.erase(image);
            add(folded(square, 2 * square.weight, Fold::even));
            add(folded(square, 2 * square.weight, Fold::odd));
        }
    }
    return squares;
}

/// How far the squares reach to each side.
inline std::size_t reach_of(std::span<const FoldedSquare> squares) {
    std::size_t reach = 0;
    for (const FoldedSquare& square : squares) {
        for (const std::ptrdiff_t offset : square.offsets) {
            reach = std::max(reach, static_cast<std::size_t>(std::abs(offset)));
        }
    }
    return reach;
}

/// u^{k+1} + u^k and u^{k+1} - u^k about some nodes.
class FoldedBlock {
  public:
    static constexpr std::size_t nodes = 64;
    /// Sums for each node: compilers vectorise over them, and many short sums round less than a
    /// long one.
    using Sum = std::array<double, nodes>;

    explicit FoldedBlock(std::size_t reach)
        : reach_(reach), fields_(std::make_unique_for_overwrite<double[]>(2 * entries())) {}

    /// u and v: of all nodes, the first of so many to be read with the reach about them.
    template <class Real>
    void read(std::span<const Real> u, std::span<const Real> v, double dt, std::size_t first,
              std::size_t count) {
        count_ = count;
        double* __restrict sums = fields_.get();
        double* __restrict changes = sums + entries();
        const Real* const from_u = &u[first - reach_];
        const Real* const from_v = &v[first - reach_];
        for (std::size_t i = 0; i < count + 2 * reach_; ++i) {
            changes[i] = dt * static_cast<double>(from_v[i]);
            sums[i] = 2 * static_cast<double>(from_u[i]) - changes[i];
        }
    }

    /// Adds the square's (now + before)^2 and (now - before)^2 at each node.
    void add(const FoldedSquare& square, Sum& middle, Sum& change) const {
        switch (square.fold) {
            case Fold::even:
                return add_fixed<Fold::even, 1>(square, middle, change);
            case Fold::odd:
                return add_fixed<Fold::odd, 1>(square, middle, change);
        }
    }

  private:
    /// Squares of so many factors have a loop of their own.
    static constexpr std::size_t most_fixed = 6;

    std::size_t entries() const { return nodes + 2 * reach_; }

    template <Fold Way, std::size_t Size>
    void add_fixed(const FoldedSquare& square, Sum& middle, Sum& change) const {
        if constexpr (Size > most_fixed) {
            add_roots<Way>(square, square.factors, square.offsets, middle, change);
        } else if (square.factors.size() == Size) {
            std::array<double, Size> factors{};
            std::array<std::ptrdiff_t, Size> offsets{};
            std::ranges::copy(square.factors, factors.begin());
            std::ranges::copy(square.offsets, offsets.begin());
            add_roots<Way>(square, factors, offsets, middle, change);
        } else {
            add_fixed<Way, Size + 1>(square, middle, change);
        }
    }

    template <Fold Way, class Factors, class Offsets>
    void add_roots(const FoldedSquare& square, const Factors& factors, const Offsets& offsets,
                   Sum& middle, Sum& change) const {
        const double centre = square.centre;
        const auto root_at = [&](const double* node) {
            const auto term = [&](std::size_t k) {
                const double right = node[offsets[k]];
                const double left = node[-offsets[k]];
                return factors[k] * (Way == Fold::even ? right + left : right - left);
            };
            double root = term(0);
            if constexpr (Way != Fold::odd) {
                root += centre * *node;
            }
            for (std::size_t k = 1; k < factors.size(); ++k) {
                root += term(k);
            }
            return root;
        };
        double* __restrict middles = middle.data();
        double* __restrict changes = change.data();
        const double* const sums = fields_.get() + reach_;
        const double* const rates = sums + entries();
        for (std::size_t i = 0; i < count_; ++i) {
            const double both = root_at(sums + i);
            const double rate = root_at(rates + i);
            middles[i] += both * both;
            changes[i] += rate * rate;
        }
    }

    std::size_t reach_;
    std::size_t count_ = 0;
    std::unique_ptr<double[]> fields_;
};

}  // namespace nmbc::detail
