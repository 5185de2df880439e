// SPDX-License-Identifier: MIT
#include "generator/enclosures/band_grade.hpp"

#include <algorithm>

#include "generator/enclosures/real_zeros.hpp"
#include "generator/enclosures/wave_grade.hpp"

namespace nmbcgen {
namespace {

class Sweep {
  public:
    Sweep(const EnclosedCondition& condition, Grade least, int most_boxes)
        : c_(condition),
          least_(least),
          finest_(std::max(1e-10, spread_of(condition.band) / 4)),
          boxes_left_(most_boxes) {}

    bool holds(const Interval& square, const Interval& tau, double top) {
        if (boxes_left_ == 0) {
            return false;
        }
        --boxes_left_;
        EnclosedPolynomial waves = c_.band;
        waves[0] -= square;
        const auto clusters = real_zeros(waves);
        if (clusters && holds_in_one(square, tau, *clusters)) {
            return true;
        }
        const double in_time = width(tau) * square.upper();
        const double in_band = width(square) / top;
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
    bool holds_in_one(const Interval& square, const Interval& tau,
                      const std::vector<ZeroCluster>& clusters) const {
        const Interval slowed = 1.0 - tau * square;
        return slowed.lower() > 0 && holds_for_all(clusters, 0, {}, c_.scale * rise(square, tau));
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
    Grade least_;
    double finest_;  ///< of the band; in smaller boxes roundings decide
    int boxes_left_;
};

}  // namespace

Interval highest_square(const EnclosedPolynomial& band) {
    constexpr int parts = 256;
    Interval highest = 0;
    for (int i = 0; i < parts; ++i) {
        const Interval x(-1 + 2.0 * i / parts, -1 + 2.0 * (i + 1) / parts);
        const Interval middle = median(x);
        highest = Interval(std::max(highest.lower(), value_at(band, middle).lower()),
                           std::max(highest.upper(), value_at(band, x).upper()));
    }
    return highest;
}

double spread_of(const EnclosedPolynomial& band) {
    constexpr int parts = 16;
    double spread = 0;
    double top = 0;
    for (int i = 0; i < parts; ++i) {
        const Interval value = value_at(band, Interval(-1 + 2.0 * i / parts));
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
