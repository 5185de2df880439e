// SPDX-License-Identifier: MIT
#include "generator/stability/stable_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "generator/stability/discrete.hpp"

namespace nmbcgen {
namespace {

/// largest_cfl() at one G.
struct Sample {
    double G;
    double cfl;
};

class Steps {
  public:
    Steps(const Table& table, GhostRule ghosts, Grade least)
        : table_(table), ghosts_(ghosts), least_(least) {}

    void cover(const StabilityWindow& window) {
        constexpr double far = 8;
        constexpr double farthest = 1000;
        constexpr int pieces = 8;
        const double low = window.low.inner;
        if (window.high && window.high->inner == low) {
            append(low, low, cfl_at(low));
            return;
        }
        const double high = window.high ? window.high->inner : std::max(far, 2 * low);
        Sample begin{low, cfl_at(inside(low, high))};
        for (int piece = 1; piece <= pieces; ++piece) {
            const double G = piece == pieces ? high : low + (high - low) * piece / pieces;
            const Sample end{G, cfl_at(piece == pieces ? inside(high, low) : G)};
            cover(begin, end, 0);
            begin = end;
        }
        if (!window.high) {
            double least = begin.cfl;
            for (double G = 2 * high; G < farthest * high; G *= 2) {
                least = std::min(least, cfl_at(G));
            }
            append(high, std::numeric_limits<double>::infinity(), least);
        }
    }

    std::vector<StableStep> take() { return std::move(steps_); }

  private:
    double cfl_at(double G) const {
        return largest_cfl(make_half_space(table_, Rational(G)), ghosts_, least_);
    }

    /// At an edge sup rho is 1 or there is a pole; a millionth of the window off, neither.
    static double inside(double edge, double other) { return edge + 1e-6 * (other - edge); }

    void cover(const Sample& begin, const Sample& end, int depth) {
        constexpr double resolved = 0.06;
        constexpr int deepest = 4;
        const double middle_G = begin.G + (end.G - begin.G) / 2;
        const Sample middle{middle_G, cfl_at(middle_G)};
        const auto [least, most] = std::minmax({begin.cfl, middle.cfl, end.cfl});
        if (most - least > resolved && depth < deepest) {
            cover(begin, middle, depth + 1);
            cover(middle, end, depth + 1);
        } else {
            append(begin.G, end.G, least);
        }
    }

    void append(double low, double high, double least) {
        const double cfl = std::round(100 * least - 1) / 100;
        if (cfl <= 0) {
            return;
        }
        if (!steps_.empty() && steps_.back().window.high == low && steps_.back().cfl == cfl) {
            steps_.back().window.high = high;
        } else {
            steps_.push_back({{low, high}, cfl});
        }
    }

    const Table& table_;
    GhostRule ghosts_;
    Grade least_;
    std::vector<StableStep> steps_;
};

}  // namespace

std::vector<StableStep> stable_steps(const Table& table,
                                     const std::vector<StabilityWindow>& windows, GhostRule ghosts,
                                     Grade least) {
    Steps steps(table, ghosts, least);
    for (const StabilityWindow& window : windows) {
        steps.cover(window);
    }
    return steps.take();
}

}  // namespace nmbcgen
