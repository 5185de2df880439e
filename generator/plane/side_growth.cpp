// SPDX-License-Identifier: MIT
#include "generator/plane/side_growth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "generator/dense/decompositions.hpp"
#include "generator/plane/plane_modes.hpp"
#include "generator/plane/side_reflection.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;

constexpr double least_told = 1e-6;   // of the highest frequency
constexpr double most_untold = 1e-3;  // of the same

/// No frequency of the chain is higher.
double highest_frequency(const LateralChain& chain) {
    double sum = 0;
    for (const Eigen::MatrixXd& entry : chain.stiffness) {
        sum += entry.norm();
    }
    return std::sqrt(sum);
}

/// f over what it is where s is large, so that it tends to 1: each ghost row has c (s + scale)^p of
/// the condition's highest power p, c being its constant coefficient.
class ScaledDeterminant {
  public:
    ScaledDeterminant(const LateralChain& chain, const SideCondition& condition)
        : chain_(chain), condition_(condition), scale_(highest_frequency(chain)) {}

    double scale() const { return scale_; }

    Complex operator()(Complex s) const {
        Complex value = growth_determinant(chain_, condition_, s);
        for (Index a = 0; a < chain_.components(); ++a) {
            const ShiftPolynomial& residual = condition_.residual[std::size_t(a)];
            Complex row = residual.back().front();
            for (std::size_t p = 1; p < residual.size(); ++p) {
                row *= s + scale_;
            }
            for (std::size_t layer = 0; layer < chain_.reach(); ++layer) {
                value /= row;
            }
        }
        return value;
    }

  private:
    const LateralChain& chain_;
    const SideCondition& condition_;
    double scale_;
};

/// The change of the argument along a part of the line s = rate + i scale tan(angle), between
/// angles where the values are known.
class Turn {
  public:
    Turn(const ScaledDeterminant& value, double rate) : value_(value), rate_(rate) {}

    Complex at(double angle) const { return value_({rate_, value_.scale() * std::tan(angle)}); }

    std::optional<double> between(double low, Complex at_low, double high, Complex at_high) const {
        constexpr double little = 0.5;     // of the logarithm, between neighbours
        constexpr double alike = 0.25;     // and its halves
        constexpr double closest = 1e-13;  // angles
        const double middle = (low + high) / 2;
        const Complex at_middle = at(middle);
        const Complex first = std::log(at_middle / at_low);
        const Complex second = std::log(at_high / at_middle);
        if (std::abs(first) < little && std::abs(second) < little &&
            std::abs(first - second) < alike) {
            return first.imag() + second.imag();
        }
        if (!(high - low > closest)) {
            return std::nullopt;
        }
        const auto lower = between(low, at_low, middle, at_middle);
        const auto upper = lower ? between(middle, at_middle, high, at_high) : std::nullopt;
        return upper ? std::optional(*lower + *upper) : std::nullopt;
    }

  private:
    const ScaledDeterminant& value_;
    double rate_;
};

}  // namespace

Complex growth_determinant(const LateralChain& chain, const SideCondition& condition, Complex s) {
    const std::vector<PlaneMode> modes = decaying_plane_modes(chain, s);
    // u = 0, not v = 0 as fixed_condition() has it, which would divide f by powers of s.
    const SideCondition at_rest{{ShiftPolynomial{{1}}, ShiftPolynomial{{1}}}};
    const MatrixXcd own = conditions_on(modes, condition, chain.reach(), s);
    const MatrixXcd fixed = conditions_on(modes, at_rest, chain.reach(), s);
    // The determinant of a quotient rather than the quotient of determinants: both may be small.
    return determinant_of(solution_of(fixed.transpose(), own.transpose()));
}

std::optional<std::size_t> growing_modes(const LateralChain& chain, const SideCondition& condition,
                                         double rate) {
    constexpr int parts = 32;  // f is real at real s, and has conjugate values at conjugate s
    const ScaledDeterminant value(chain, condition);
    const Turn turn(value, rate);
    double change = 0;
    double low = 0;
    Complex at_low = turn.at(low);
    for (int i = 1; i <= parts; ++i) {
        constexpr double last = 1 - 1e-3;  // of a right angle: 600 times the highest frequency
        const double high = last * std::numbers::pi / 2 * i / parts;
        const Complex at_high = turn.at(high);
        const auto part = turn.between(low, at_low, high, at_high);
        if (!part) {
            return std::nullopt;
        }
        change += *part;
        low = high;
        at_low = at_high;
    }
    // Beyond, the value tends to 1.
    change -= std::arg(at_low);
    const long count = -std::lround(change / std::numbers::pi);
    constexpr double near = 0.5;
    if (count < 0 || !(std::abs(at_low - 1.0) < near)) {
        return std::nullopt;
    }
    return std::size_t(count);
}

std::optional<double> growth_of_side(const LateralChain& chain, const SideCondition& condition,
                                     double least) {
    const double highest = highest_frequency(chain);
    double below = std::max(least, least_told * highest);
    auto count = growing_modes(chain, condition, below);
    while (!count && below < most_untold * highest) {
        below *= 4;
        count = growing_modes(chain, condition, below);
    }
    if (!count) {
        return std::nullopt;
    }
    if (*count == 0) {
        return least;
    }
    const auto is_faster = [&](double rate) {
        constexpr double aside = 1.002;
        const auto there = growing_modes(chain, condition, rate);
        return (there ? there : growing_modes(chain, condition, aside * rate)).value_or(0) > 0;
    };
    double above = 2 * below;
    while (is_faster(above)) {
        below = above;
        above *= 2;
    }
    constexpr double enough = 5e-3;
    while (above - below > enough * below) {
        const double middle = std::sqrt(below * above);
        (is_faster(middle) ? below : above) = middle;
    }
    return below;
}

}  // namespace nmbcgen
