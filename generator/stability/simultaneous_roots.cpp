// SPDX-License-Identifier: MIT
#include "generator/stability/simultaneous_roots.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

/// Without the care of operator/ for what overflows: then the iteration does not settle.
Complex reciprocal(Complex z) {
    return std::conj(z) / std::norm(z);
}

std::vector<double> sizes_of(const std::vector<Complex>& a) {
    std::vector<double> sizes;
    sizes.reserve(a.size());
    for (const Complex coefficient : a) {
        sizes.push_back(std::abs(coefficient));
    }
    return sizes;
}

/// The corners of the least concave function above log |a_i|. sizes: |a_i|.
std::vector<std::size_t> newton_polygon(const std::vector<double>& sizes) {
    std::vector<double> heights;
    heights.reserve(sizes.size());
    for (const double size : sizes) {
        heights.push_back(std::log(size));
    }
    const auto slope = [&heights](std::size_t from, std::size_t to) {
        return (heights[to] - heights[from]) / double(to - from);
    };
    std::vector<std::size_t> corners;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (sizes[i] == 0) {
            continue;
        }
        while (corners.size() > 1 &&
               slope(corners[corners.size() - 2], corners.back()) <= slope(corners.back(), i)) {
            corners.pop_back();
        }
        corners.push_back(i);
    }
    return corners;
}

std::vector<Complex> first_guesses(const std::vector<double>& sizes) {
    std::vector<Complex> guesses;
    const std::vector<std::size_t> corners = newton_polygon(sizes);
    for (std::size_t side = 0; side + 1 < corners.size(); ++side) {
        const std::size_t low = corners[side];
        const auto count = double(corners[side + 1] - low);
        const double radius = std::pow(sizes[low] / sizes[corners[side + 1]], 1 / count);
        for (std::size_t i = low; i < corners[side + 1]; ++i) {
            constexpr double off_the_axes = 0.7;  // a real polynomial's guesses would stay mirrored
            guesses.push_back(std::polar(radius, 2 * std::numbers::pi * double(i - low) / count +
                                                     off_the_axes + double(low)));
        }
    }
    return guesses;
}

/// p and p' at x, and what roundings may make of p.
struct Value {
    Complex value = 0;
    Complex slope = 0;
    double roundings = 0;

    Value(const std::vector<Complex>& a, const std::vector<double>& sizes, Complex x) {
        const double size = std::sqrt(std::norm(x));  // too small a one to square is 0: as good
        for (std::size_t i = a.size(); i-- > 0;) {
            slope = {slope.real() * x.real() - slope.imag() * x.imag() + value.real(),
                     slope.real() * x.imag() + slope.imag() * x.real() + value.imag()};
            value = {value.real() * x.real() - value.imag() * x.imag() + a[i].real(),
                     value.real() * x.imag() + value.imag() * x.real() + a[i].imag()};
            roundings = roundings * size + sizes[i];
        }
        roundings *= std::numeric_limits<double>::epsilon();
    }
};

/// sizes: |a_i|
std::optional<std::vector<Complex>> improved(const std::vector<Complex>& a,
                                             const std::vector<double>& sizes,
                                             std::vector<Complex> roots) {
    constexpr int most = 100;
    constexpr double settled = 2 * std::numeric_limits<double>::epsilon();
    std::vector<bool> known(roots.size(), false);
    std::size_t unknown = roots.size();
    for (int iteration = 0; iteration < most && unknown > 0; ++iteration) {
        for (std::size_t i = 0; i < roots.size(); ++i) {
            if (known[i]) {
                continue;
            }
            const Value here(a, sizes, roots[i]);
            Complex others = 0;
            for (std::size_t l = 0; l < roots.size(); ++l) {
                others += l == i ? 0.0 : reciprocal(roots[i] - roots[l]);
            }
            // N/(1 - N S) = p/(p' - p S)
            const Complex step = here.value * reciprocal(here.slope - here.value * others);
            if (!std::isfinite(std::norm(step))) {
                return std::nullopt;
            }
            roots[i] -= step;
            if (std::norm(step) <= settled * settled * std::norm(roots[i]) ||
                std::norm(here.value) <= here.roundings * here.roundings) {
                known[i] = true;
                --unknown;
            }
        }
    }
    return unknown == 0 ? std::optional(roots) : std::nullopt;
}

}  // namespace

std::optional<std::vector<Complex>> simultaneous_roots(const std::vector<Complex>& a) {
    const std::vector<double> sizes = sizes_of(a);
    return improved(a, sizes, first_guesses(sizes));
}

std::optional<std::vector<Complex>> simultaneous_roots(const std::vector<Complex>& a,
                                                       std::vector<Complex> guesses) {
    return improved(a, sizes_of(a), std::move(guesses));
}

}  // namespace nmbcgen
