// SPDX-License-Identifier: MIT
#include "generator/enclosures/band_grade.hpp"

#include <algorithm>
#include <optional>

#include "generator/enclosures/real_zeros.hpp"
#include "generator/enclosures/wave_grade.hpp"

namespace nmbcgen {
namespace {

/// (f(x) - f(at))/(x - at)
EnclosedPolynomial without_zero(const EnclosedPolynomial& f, const Interval& at) {
    EnclosedPolynomial quotient(f.empty() ? 0 : f.size() - 1);
    Interval carry = 0;
    for (std::size_t power = quotient.size(); power > 0; --power) {
        carry = carry * at + f[power];
        quotient[power - 1] = carry;
    }
    return quotient;
}

Expansion without_zero(const Expansion& f, const Interval& at) {
    return {.value = without_zero(f.value, at),
            .slope = without_zero(f.slope, at),
            .rest = without_zero(f.rest, at),
            .offset = f.offset};
}

class Sweep {
  public:
    Sweep(const EnclosedCondition& condition, Grade least, int most_boxes)
        : c_(condition),
          slope_(derivative(condition.band)),
          least_(least),
          finest_(std::max(1e-10, spread_of(condition.band) / 64)),  // 16 to 256 do as well
          boxes_left_(most_boxes) {}

    bool holds(const Interval& square, const Interval& tau, double top) {
        if (boxes_left_ == 0) {
            return false;
        }
        --boxes_left_;
        Expansion waves = c_.band;
        waves.value[0] -= square;
        const auto clusters = real_zeros(waves);
        if (clusters && holds_in_one(square, tau, *clusters)) {
            return true;
        }
        const double in_time = width(tau) * square.upper();
        const double in_band = width(square) / top;
        constexpr double near_the_finest = 256;  // two waves that meet blur these boxes, too
        const auto meeting = clusters ? meeting_in(*clusters) : std::nullopt;
        if (meeting && in_band < near_the_finest * finest_ &&
            holds_where_two_meet(square, tau, *clusters, *meeting)) {
            return true;
        }
        // Next to an extremum of the band the waves are known to the root of in_band only.
        constexpr double as_good = 30;
        const bool waves_blur = !clusters || in_time <= as_good * widest(*clusters);
        if (waves_blur && in_band >= finest_) {
            const double middle = median(square);
            return holds(Interval(square.lower(), middle), tau, top) &&
                   holds(Interval(middle, square.upper()), tau, top);
        }
        if (clusters && in_time >= finest_) {
            const double middle = median(tau);
            return holds(square, Interval(tau.lower(), middle), top) &&
                   holds(square, Interval(middle, tau.upper()), top);
        }
        return false;
    }

  private:
    /// known: waves that travel whether or not there are those of the clusters.
    bool holds_in_one(const Interval& square, const Interval& tau,
                      const std::vector<ZeroCluster>& clusters,
                      const std::vector<WaveGroup>& known = {}) const {
        const Interval slowed = 1.0 - tau * square;
        return slowed.lower() > 0 &&
               holds_for_all(clusters, 0, known, c_.scale * rise(square, tau));
    }

    /// Which cluster has two waves that may meet.
    static std::optional<std::size_t> meeting_in(const std::vector<ZeroCluster>& clusters) {
        const auto found = std::ranges::find_if(
            clusters, [](const ZeroCluster& cluster) { return cluster.counts.back() == 2; });
        return found == clusters.end() ? std::nullopt
                                       : std::optional(std::size_t(found - clusters.begin()));
    }

    /// Next to an extremum of the band an interval d of G blurs two waves by the root of d, at a
    /// frequency. At the x of one of them it blurs the other one by d. Either there is none of
    /// them, or there is one at an x in their cluster.
    bool holds_where_two_meet(const Interval& square, const Interval& tau,
                              std::vector<ZeroCluster> clusters, std::size_t meeting) {
        constexpr int most_halvings = 8;
        const ZeroCluster two = clusters[meeting];
        clusters.erase(clusters.begin() + std::ptrdiff_t(meeting));
        return (two.counts.front() > 0 || holds_in_one(square, tau, clusters)) &&
               holds_with_one_at(two.where, square, tau, most_halvings);
    }

    /// At all frequencies of the box that have a wave in x.
    bool holds_with_one_at(const Interval& x, const Interval& square, const Interval& tau,
                           int halvings_left) {
        if (boxes_left_ == 0) {
            return false;
        }
        --boxes_left_;
        const double middle = median(x);
        const Interval own = intersect(square, values_on(x, c_.band, slope_.at(x)));
        if (empty(own)) {
            return true;
        }
        const auto others = real_zeros(without_zero(c_.band, x));
        if (others && holds_in_one(own, tau, *others, {{x, 1}})) {
            return true;
        }
        return halvings_left > 0 &&
               holds_with_one_at(Interval(x.lower(), middle), square, tau, halvings_left - 1) &&
               holds_with_one_at(Interval(middle, x.upper()), square, tau, halvings_left - 1);
    }

    static double widest(const std::vector<ZeroCluster>& clusters) {
        double widest = 0;
        for (const ZeroCluster& cluster : clusters) {
            widest = std::max(widest, width(cluster.where));
        }
        return widest;
    }

    /// omega^2/(1 - omega^2 dt^2/4), which rises with both.
    static Interval rise(const Interval& square, const Interval& tau) {
        const auto at = [](double one, double other) {
            return Interval(one) / (1.0 - Interval(one) * other);
        };
        return hull(at(square.lower(), tau.lower()), at(square.upper(), tau.upper()));
    }

    bool holds_for_all(const std::vector<ZeroCluster>& clusters, std::size_t next,
                       std::vector<WaveGroup> chosen, const Interval& seen_squared) const {
        if (next == clusters.size()) {
            return chosen.empty() || is_contractive(c_, chosen, seen_squared) ||
                   (least_ == Grade::paired && is_paired(c_, chosen, seen_squared));
        }
        return std::ranges::all_of(clusters[next].counts, [&](int count) {
            std::vector<WaveGroup> more = chosen;
            if (count > 0) {
                more.push_back({clusters[next].where, std::size_t(count)});
            }
            return holds_for_all(clusters, next + 1, std::move(more), seen_squared);
        });
    }

    const EnclosedCondition& c_;
    Expansion slope_;
    Grade least_;
    double finest_;  ///< of the band; in smaller boxes roundings, or the interval of G, decide
    int boxes_left_;
};

}  // namespace

Interval highest_square(const Expansion& band) {
    constexpr int parts = 256;
    Interval highest = 0;
    for (int i = 0; i < parts; ++i) {
        const Interval x(-1 + 2.0 * i / parts, -1 + 2.0 * (i + 1) / parts);
        const Interval middle = median(x);
        highest = Interval(std::max(highest.lower(), band.at(middle).lower()),
                           std::max(highest.upper(), band.at(x).upper()));
    }
    return highest;
}

double spread_of(const Expansion& band) {
    constexpr int parts = 16;
    double spread = 0;
    double top = 0;
    for (int i = 0; i < parts; ++i) {
        const Interval value = band.at(Interval(-1 + 2.0 * i / parts));
        spread = std::max(spread, width(value));
        top = std::max(top, value.upper());
    }
    return spread / top;
}

bool waves_have_grade(const EnclosedCondition& condition, const Interval& tau, Grade least,
                      int most_boxes) {
    const double top = highest_square(condition.band).upper();
    return Sweep(condition, least, most_boxes).holds(Interval(0, top), tau, top);
}

}  // namespace nmbcgen
