// SPDX-License-Identifier: MIT
#include "generator/stability/stable_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/support/on_all_cores.hpp"

namespace nmbcgen {
namespace {

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
        constexpr std::size_t pieces = 8;
        const double low = window.low.inner;
        if (window.high && window.high->inner == low) {
            append(piece_of(low, low, Common({steps_at(low)})));
            return;
        }
        const double high = window.high ? window.high->inner : std::max(far, 2 * low);
        std::vector<SteppedSample> ends(pieces + 1);
        on_all_cores(ends.size(), [&](std::size_t i) {
            const double G = i == pieces ? high : low + (high - low) * double(i) / pieces;
            ends[i] = {G, steps_at(i == 0        ? inside(low, high)
                                   : i == pieces ? inside(high, low)
                                                 : G)};
        });
        std::vector<std::vector<StableStep>> found(pieces);
        on_all_cores(pieces, [&](std::size_t i) { cover(ends[i], ends[i + 1], 0, found[i]); });
        for (const std::vector<StableStep>& between : found) {
            std::ranges::for_each(between, [this](const StableStep& step) { append(step); });
        }
        if (!window.high) {
            append(piece_of(high, std::numeric_limits<double>::infinity(),
                            Common(beyond(ends.back()))));
        }
    }

    std::vector<StableStep> take() { return std::move(steps_); }

  private:
    /// stable_range() at one G.
    struct SteppedSample {
        double G = 0;
        StepRange steps;
    };

    StepRange steps_at(double G) const {
        const Ranges& ranges = all_.ranges_at(G);
        return least_ == Grade::contractive ? ranges.contractive : ranges.paired;
    }

    /// At an edge sup rho is 1 or there is a pole; a millionth of the window off, neither.
    static double inside(double edge, double other) { return edge + 1e-6 * (other - edge); }

    void cover(const SteppedSample& begin, const SteppedSample& end, int depth,
               std::vector<StableStep>& found) const {
        constexpr int deepest = 4;
        const double middle_G = begin.G + (end.G - begin.G) / 2;
        const SteppedSample middle{middle_G, steps_at(middle_G)};
        std::vector<StepRange> ranges{begin.steps, middle.steps, end.steps};
        add_beside_critical(begin.G, end.G, ranges);
        const Common common(ranges);
        if (!common.is_resolved() && depth < deepest) {
            cover(begin, middle, depth + 1, found);
            cover(middle, end, depth + 1, found);
        } else {
            found.push_back(piece_of(begin.G, end.G, common));
        }
    }

    /// At the critical values between them a range may have its least value.
    void add_beside_critical(double low, double high, std::vector<StepRange>& ranges) const {
        for (const double critical : all_.critical_) {
            constexpr double aside = 1e-5;
            for (const double G : {critical * (1 - aside), critical * (1 + aside)}) {
                if (low < G && G < high) {
                    ranges.push_back(steps_at(G));
                }
            }
        }
    }

    /// At the last sample of a window without an end, and at twice its G and so on.
    std::vector<StepRange> beyond(const SteppedSample& last) const {
        constexpr double farthest = 1000;
        std::vector<double> values;
        for (double G = 2 * last.G; G < farthest * last.G; G *= 2) {
            values.push_back(G);
        }
        std::vector<StepRange> ranges(values.size());
        on_all_cores(values.size(), [&](std::size_t i) { ranges[i] = steps_at(values[i]); });
        ranges.push_back(last.steps);
        return ranges;
    }

    static StableStep piece_of(double low, double high, const Common& common) {
        const auto [from, cfl] = common.with_margins();
        return {{low, high}, cfl, from};
    }

    void append(const StableStep& piece) {
        if (piece.cfl <= piece.from) {
            return;
        }
        if (!steps_.empty() && steps_.back().window.high == piece.window.low &&
            steps_.back().cfl == piece.cfl && steps_.back().from == piece.from) {
            steps_.back().window.high = piece.window.high;
        } else {
            steps_.push_back(piece);
        }
    }

    StableSteps& all_;
    Grade least_;
    std::vector<StableStep> steps_;
};

StableSteps::StableSteps(const Table& table, const std::vector<double>& critical)
    : table_(table), critical_(critical) {}

const StableSteps::Ranges& StableSteps::ranges_at(double G) {
    {
        const std::lock_guard lock(guard_);
        if (const auto known = known_.find(G); known != known_.end()) {
            return known->second;
        }
    }
    StepGrades grades(make_half_space(table_, Rational(G)));
    Ranges ranges{.paired = stable_range(grades, Grade::paired), .contractive = {}};
    if (table_.model.damping.empty()) {
        ranges.contractive = stable_range(grades, Grade::contractive);
    }
    const std::lock_guard lock(guard_);
    return known_.try_emplace(G, ranges).first->second;
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
