// SPDX-License-Identifier: MIT
#include "generator/enclosures/real_zeros.hpp"

namespace nmbcgen {
namespace {

/// -1 or 1: the sign of all numbers in the interval; 0: they have not one sign.
int sign(const Interval& interval) {
    return int(interval.lower() > 0) - int(interval.upper() < 0);
}

/// Where there may be zeros, and the signs beside it, 0 where they are not known.
struct Candidate {
    Interval where;
    int left;
    int right;
};

class Isolation {
  public:
    explicit Isolation(const Expansion& polynomial)
        : f_(polynomial), slope_(derivative(f_)), curvature_(derivative(slope_)) {}

    std::optional<std::vector<ZeroCluster>> clusters() {
        search(Interval(-1, 1), 0);
        std::vector<ZeroCluster> found;
        for (const Candidate& candidate : candidates_) {
            const std::optional<std::vector<int>> counts = counts_in(candidate);
            if (!counts) {
                return std::nullopt;
            }
            if (counts != std::vector{0}) {
                found.push_back({candidate.where, *counts});
            }
        }
        return found;
    }

  private:
    /// By value and slope in the middle, too.
    Interval values(const Interval& x, const Interval& slope) const {
        const Interval middle = median(x);
        return intersect(f_.at(x), f_.at(middle) + slope * (x - middle));
    }

    int sign_at(double x) const { return x == 1 ? -1 : sign(f_.at(Interval(x))); }

    bool rises_or_falls(double x) const { return sign(slope_.at(Interval(x))) != 0; }

    void search(const Interval& x, int depth) {
        constexpr int deepest = 24;
        const Interval slope = slope_.at(x);
        if (sign(values(x, slope)) != 0) {
            return;
        }
        if (sign(slope) != 0) {
            const Interval narrow = narrowed(x);
            if (!empty(narrow)) {
                keep({narrow, sign_at(x.lower()), sign_at(x.upper())});
            }
        } else if (depth < deepest && (rises_or_falls(x.lower()) || rises_or_falls(x.upper()))) {
            const double middle = median(x);
            search(Interval(x.lower(), middle), depth + 1);
            search(Interval(middle, x.upper()), depth + 1);
        } else {
            keep({x, sign_at(x.lower()), sign_at(x.upper())});
        }
    }

    void keep(const Candidate& next) {
        if (!candidates_.empty() && candidates_.back().where.upper() >= next.where.lower()) {
            candidates_.back().where = hull(candidates_.back().where, next.where);
            candidates_.back().right = next.right;
        } else {
            candidates_.push_back(next);
        }
    }

    /// Nothing where it cannot tell three zeros from one.
    std::optional<std::vector<int>> counts_in(const Candidate& candidate) const {
        const bool one_at_most = sign(slope_.at(candidate.where)) != 0;
        if (!one_at_most && sign(curvature_.at(candidate.where)) == 0) {
            return std::nullopt;
        }
        std::vector<int> counts;
        for (int count = 0; count <= (one_at_most ? 1 : 2); ++count) {
            const bool parity_known = candidate.left != 0 && candidate.right != 0;
            if (!parity_known || (count % 2 == 1) == (candidate.left != candidate.right)) {
                counts.push_back(count);
            }
        }
        return counts;
    }

    /// By Newton's method, or bisection where that is slow; f is monotone in x.
    Interval narrowed(Interval x) const {
        constexpr int most = 40;
        for (int step = 0; step < most && !empty(x); ++step) {
            const double before = width(x);
            const Interval middle = median(x);
            const Interval slope = slope_.at(x);
            const Interval value = f_.at(middle);
            x = intersect(x, middle - value / slope);
            constexpr double worth_it = 0.7;
            if (!empty(x) && width(x) > worth_it * before) {
                if (sign(value) == 0 || median(middle) <= x.lower() ||
                    median(middle) >= x.upper()) {
                    break;
                }
                x = sign(value) == sign(slope) ? Interval(x.lower(), median(middle))
                                               : Interval(median(middle), x.upper());
            }
        }
        return x;
    }

    const Expansion& f_;
    Expansion slope_;
    Expansion curvature_;
    std::vector<Candidate> candidates_{};
};

}  // namespace

std::optional<std::vector<ZeroCluster>> real_zeros(const Expansion& polynomial) {
    return Isolation(polynomial).clusters();
}

}  // namespace nmbcgen
