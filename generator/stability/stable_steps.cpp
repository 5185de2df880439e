// SPDX-License-Identifier: MIT
#include "generator/stability/stable_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nmbcgen {
namespace {

/// stable_range() at one G.
struct SteppedSample {
    double G = 0;
    StepRange steps;
};

/// The range that all of several ranges have, and how far apart they are.
class Common {
  public:
    explicit Common(const std::vector<StepRange>& ranges) {
        for (const StepRange& steps : ranges) {
            least_ = std::min(least_, steps.largest);
            most_ = std::max(most_, steps.largest);
            lowest_ = std::min(lowest_, steps.from);
            highest_ = std::max(highest_, steps.from);
        }
    }

    bool is_resolved() const {
        constexpr double resolved = 0.06;
        return most_ - least_ <= resolved && highest_ - lowest_ <= hundredth;
    }

    /// Less for what may lie between the samples.
    StepRange with_margins() const {
        const double margin = std::max(hundredth, highest_ - lowest_);
        return {highest_ > 0 ? std::ceil(100 * (highest_ + margin)) / 100 : 0,
                std::round(100 * least_ - 1) / 100};
    }

  private:
    static constexpr double hundredth = 0.01;
    double least_ = 1;
    double most_ = 0;
    double lowest_ = 1;
    double highest_ = 0;
};

}  // namespace

/// The pieces of one grade.
class StableSteps::Pieces {
  public:
    Pieces(StableSteps& all, Grade least) : all_(all), least_(least) {}

    void cover(const StabilityWindow& window) {
        constexpr double far = 8;
        constexpr double farthest = 1000;
        constexpr int pieces = 8;
        const double low = window.low.inner;
        if (window.high && window.high->inner == low) {
            append(low, low, Common({steps_at(low)}));
            return;
        }
        const double high = window.high ? window.high->inner : std::max(far, 2 * low);
        SteppedSample begin{low, steps_at(inside(low, high))};
        for (int piece = 1; piece <= pieces; ++piece) {
            const double G = piece == pieces ? high : low + (high - low) * piece / pieces;
            const SteppedSample end{G, steps_at(piece == pieces ? inside(high, low) : G)};
            cover(begin, end, 0);
            begin = end;
        }
        if (!window.high) {
            std::vector<StepRange> beyond{begin.steps};
            for (double G = 2 * high; G < farthest * high; G *= 2) {
                beyond.push_back(steps_at(G));
            }
            append(high, std::numeric_limits<double>::infinity(), Common(beyond));
        }
    }

    std::vector<StableStep> take() { return std::move(steps_); }

  private:
    StepRange steps_at(double G) const {
        const Ranges& ranges = all_.ranges_at(G);
        return least_ == Grade::contractive ? ranges.contractive : ranges.paired;
    }

    /// At an edge sup rho is 1 or there is a pole; a millionth of the window off, neither.
    static double inside(double edge, double other) { return edge + 1e-6 * (other - edge); }

    void cover(const SteppedSample& begin, const SteppedSample& end, int depth) {
        constexpr int deepest = 4;
        const double middle_G = begin.G + (end.G - begin.G) / 2;
        const SteppedSample middle{middle_G, steps_at(middle_G)};
        std::vector<StepRange> ranges{begin.steps, middle.steps, end.steps};
        add_beside_critical(begin.G, end.G, ranges);
        const Common common(ranges);
        if (!common.is_resolved() && depth < deepest) {
            cover(begin, middle, depth + 1);
            cover(middle, end, depth + 1);
        } else {
            append(begin.G, end.G, common);
        }
    }

    /// At the critical values between them a range may have its least value.
    void add_beside_critical(double low, double high, std::vector<StepRange>& ranges) {
        for (const double critical : all_.critical_) {
            constexpr double aside = 1e-5;
            for (const double G : {critical * (1 - aside), critical * (1 + aside)}) {
                if (low < G && G < high) {
                    ranges.push_back(steps_at(G));
                }
            }
        }
    }

    void append(double low, double high, const Common& common) {
        const auto [from, cfl] = common.with_margins();
        if (cfl <= from) {
            return;
        }
        if (!steps_.empty() && steps_.back().window.high == low && steps_.back().cfl == cfl &&
            steps_.back().from == from) {
            steps_.back().window.high = high;
        } else {
            steps_.push_back({{low, high}, cfl, from});
        }
    }

    StableSteps& all_;
    Grade least_;
    std::vector<StableStep> steps_;
};

StableSteps::StableSteps(const Table& table, const std::vector<double>& critical)
    : table_(table), critical_(critical) {}

const StableSteps::Ranges& StableSteps::ranges_at(double G) {
    const auto [entry, is_new] = known_.try_emplace(G);
    if (is_new) {
        StepGrades grades(make_half_space(table_, Rational(G)));
        entry->second.paired = stable_range(grades, Grade::paired);
        if (table_.model.damping.empty()) {
            entry->second.contractive = stable_range(grades, Grade::contractive);
        }
    }
    return entry->second;
}

std::vector<StableStep> StableSteps::over(const std::vector<StabilityWindow>& windows,
                                          Grade least) {
    Pieces pieces(*this, least);
    for (const StabilityWindow& window : windows) {
        pieces.cover(window);
    }
    return pieces.take();
}

}  // namespace nmbcgen
