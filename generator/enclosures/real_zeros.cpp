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
        : f_(polynomial),
          slope_(derivative(f_)),
          curvature_(derivative(slope_)),
          third_(derivative(curvature_)) {}

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
    Interval slope_on(const Interval& x) const {
        const Interval plain = slope_.at(x);
        return sign(plain) != 0 ? plain : values_on(x, slope_, curvature_.at(x));
    }

    int sign_at(double x) const { return x == 1 ? -1 : sign(f_.at(Interval(x))); }

    bool rises_or_falls(double x) const { return sign(slope_.at(Interval(x))) != 0; }

    void search(const Interval& x, int depth) {
        constexpr int deepest = 24;
        const Interval slope = slope_on(x);
        if (sign(values_on(x, f_, slope)) != 0) {
            return;
        }
        if (sign(slope) != 0) {
            const Interval narrow = narrowed(x, sign(slope));
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
        const Interval& x = candidate.where;
        const bool one_at_most = sign(slope_on(x)) != 0;
        if (!one_at_most && sign(values_on(x, curvature_, third_.at(x))) == 0) {
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

    /// Without a half, or a quarter or an eighth, that has no zero; rise: the sign of f's slope.
    Interval without_an_end(const Interval& x, int rise) const {
        for (const double part : {0.5, 0.25, 0.125}) {
            const double low = x.lower() + part * width(x);
            const double high = x.upper() - part * width(x);
            if (in(low, x) && sign_at(low) == -rise) {
                return {low, x.upper()};
            }
            if (in(high, x) && sign_at(high) == rise) {
                return {x.lower(), high};
            }
        }
        return x;
    }

    /// By Newton's method, or end by end where that is slow; f is monotone in x, as `rise` says.
    Interval narrowed(Interval x, int rise) const {
        constexpr int most = 40;
        constexpr double worth_it = 0.9;  // a step that leaves more is the last
        for (int step = 0; step < most && !empty(x); ++step) {
            const double before = width(x);
            const Interval middle = median(x);
            x = intersect(x, middle - f_.at(middle) / slope_on(x));
            if (!empty(x) && width(x) > worth_it * before) {
                x = without_an_end(x, rise);
                if (width(x) > worth_it * before) {
                    break;
                }
            }
        }
        return x;
    }

    const Expansion& f_;
    Expansion slope_;
    Expansion curvature_;
    Expansion third_;
    std::vector<Candidate> candidates_{};
};

}  // namespace

std::optional<std::vector<ZeroCluster>> real_zeros(const Expansion& polynomial) {
    return Isolation(polynomial).clusters();
}

}  // namespace nmbcgen
