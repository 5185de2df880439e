// SPDX-License-Identifier: MIT
#include "generator/enclosures/band_grade.hpp"

#include <algorithm>

#include "generator/enclosures/real_zeros.hpp"
#include "generator/enclosures/triangular.hpp"

namespace nmbcgen {
namespace {

using Points = std::vector<Interval>;

/// Some of the waves of one frequency, next to each other.
struct Group {
    Interval where;
    std::size_t count;
};

/// The forms [x_1 .. x_m] f Z^{i+k}, i and k below the size.
class Forms {
  public:
    explicit Forms(const Points& points)
        : even_(points.size() % 2 == 0),
          of_q_((points.size() - 1) / 2 + 1),
          of_r_(points.size() / 2),
          one_(points.size(), 1),
          Z_(Triangular::of(points)),
          one_plus_x_(one_ + Z_),
          one_minus_x_(one_ + Interval(-1) * Z_) {}

    std::size_t size() const { return of_q_ + of_r_; }
    std::size_t size_of_q() const { return of_q_; }
    bool even() const { return even_; }
    const Triangular& Z() const { return Z_; }
    Triangular p() const { return even_ ? one_plus_x_ : one_; }
    Triangular q() const { return even_ ? one_minus_x_ : one_minus_x_ * one_plus_x_; }
    const Triangular& one_plus_x() const { return one_plus_x_; }
    const Triangular& one_minus_x() const { return one_minus_x_; }

    /// Corners of first, then, then factor, then factor^2, ..
    std::vector<Interval> moments(const Triangular& first, Triangular then,
                                  const Triangular& factor) const {
        std::vector<Interval> found{first.corner()};
        for (std::size_t power = 1; power < 2 * size(); ++power) {
            found.push_back(then.corner());
            then = then * factor;
        }
        return found;
    }

    /// corner(f Z^power), power from 0 on
    std::vector<Interval> moments(const Triangular& f) const { return moments(f, f * Z_, Z_); }

  private:
    bool even_;
    std::size_t of_q_;
    std::size_t of_r_;
    Triangular one_;
    Triangular Z_;
    Triangular one_plus_x_;
    Triangular one_minus_x_;
};

std::vector<std::vector<Interval>> hankel(const std::vector<Interval>& moments, std::size_t size) {
    std::vector<std::vector<Interval>> matrix(size, std::vector<Interval>(size));
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t k = 0; k < size; ++k) {
            matrix[i][k] = moments[i + k];
        }
    }
    return matrix;
}

Points points_of(const std::vector<Group>& groups) {
    Points points;
    for (const Group& group : groups) {
        points.insert(points.end(), group.count, group.where);
    }
    return points;
}

bool is_contractive(const EnclosedCondition& c, const std::vector<Group>& groups,
                    const Interval& seen_squared) {
    const Points points = points_of(groups);
    const Forms forms(points);
    const Triangular T = Triangular::of(c.product, points);
    const auto of_qq = forms.moments(forms.p() * T);
    if (points.size() == 1) {
        return of_qq[0].lower() >= 0;
    }
    const auto of_rr = forms.moments(forms.q() * T);
    const auto of_qr = forms.moments(seen_squared * Triangular::of(c.square_of_C, points) +
                                     Triangular::of(c.square_of_B, points));
    // Q by Omega^(1/2) larger, R by as much smaller
    const std::size_t first = forms.size_of_q();
    std::vector<std::vector<Interval>> matrix(forms.size(), std::vector<Interval>(forms.size()));
    for (std::size_t i = 0; i < forms.size(); ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
            matrix[i][k] = i < first    ? seen_squared * of_qq[i + k]
                           : k >= first ? of_rr[i + k - 2 * first]
                                        : -of_qr[i - first + k] / 2.0;
        }
    }
    return is_positive(std::move(matrix));
}

/// Which of C~^2 and B~^2/Omega^2 is the greater one at all waves of a group.
enum class Greater { C, B, unknown };

class Pairing {
  public:
    Pairing(const EnclosedCondition& condition, const std::vector<Group>& groups,
            const Interval& seen_squared)
        : c_(condition), seen_squared_(seen_squared), all_(groups) {
        for (const Group& group : groups) {
            greater_.push_back(greater_at(group.where));
        }
    }

    bool holds() const {
        if (all_.size() == 1 && all_.front().count == 1) {
            return value_at(c_.product, all_.front().where).lower() >= 0;
        }
        if (greater_.front() != Greater::unknown &&
            std::ranges::all_of(greater_, [&](Greater one) { return one == greater_.front(); })) {
            return holds_with_one();
        }
        const Forms forms(points_of(all_));
        std::vector<Interval> of_qq(2 * forms.size());
        std::vector<Interval> of_rr(2 * forms.size());
        for (const auto& part : parts()) {
            if (!add(part, forms.even(), of_qq, of_rr)) {
                return false;
            }
        }
        return is_positive(hankel(of_qq, forms.size_of_q())) &&
               is_positive(hankel(of_rr, forms.size() - forms.size_of_q()));
    }

  private:
    /// Indices of groups that share one function h.
    using Part = std::vector<std::size_t>;

    Greater greater_at(const Interval& x) const {
        const Interval difference =
            seen_squared_ * value_at(c_.square_of_C, x) - value_at(c_.square_of_B, x);
        return difference.lower() > 0   ? Greater::C
               : difference.upper() < 0 ? Greater::B
                                        : Greater::unknown;
    }

    /// (1+x) T/C~^2 is O/E, and (1-x) T/B~^2 is E/O: in powers of that factor, and reduced, so that
    /// a quotient that does not depend on x is known not to.
    bool holds_with_one() const {
        const Points points = points_of(all_);
        const Forms forms(points);
        const bool of_C = greater_.front() == Greater::C;
        const auto reciprocal =
            Triangular::of(of_C ? c_.square_of_C : c_.square_of_B, points).inverse();
        const auto divisor = Triangular::of(of_C ? c_.E : c_.O, points).inverse();
        if (!reciprocal || !divisor) {
            return false;
        }
        const Triangular& factor = of_C ? forms.one_plus_x() : forms.one_minus_x();
        const Triangular& other = of_C ? forms.one_minus_x() : forms.one_plus_x();
        const Triangular f = Triangular::of(c_.product, points) * *reciprocal;
        const Triangular reduced = Triangular::of(of_C ? c_.O : c_.E, points) * *divisor;
        const auto holds_of = [&](const Triangular& first, const Triangular& then,
                                  std::size_t size) {
            return is_positive(hankel(forms.moments(first, then, factor), size));
        };
        const std::size_t of_q = forms.size_of_q();
        const std::size_t of_r = forms.size() - of_q;
        if (!forms.even()) {
            return holds_of(f, reduced, of_q) &&
                   holds_of(other * reduced, other * reduced * factor, of_r);
        }
        return holds_of(reduced, reduced * factor, of_C ? of_q : of_r) &&
               holds_of(other * f, other * reduced, of_C ? of_r : of_q);
    }

    std::vector<Part> parts() const {
        Part of_C;
        Part of_B;
        std::vector<Part> found;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (greater_[i] == Greater::unknown) {
                found.push_back({i});
            } else {
                (greater_[i] == Greater::C ? of_C : of_B).push_back(i);
            }
        }
        for (Part& part : {std::ref(of_C), std::ref(of_B)}) {
            if (!part.empty()) {
                found.push_back(part);
            }
        }
        return found;
    }

    /// What some of the waves are of the sum that a divided difference is.
    bool add(const Part& part, bool even, std::vector<Interval>& of_qq,
             std::vector<Interval>& of_rr) const {
        std::vector<Group> mine;
        std::vector<Group> others;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            (std::ranges::count(part, i) > 0 ? mine : others).push_back(all_[i]);
        }
        const Points points = points_of(mine);
        const Points distant = points_of(others);
        const auto h = weights(part, points);
        if (!h) {
            return false;
        }
        const Forms forms(points);
        Triangular f = Triangular::of(c_.product, points) * *h;
        for (const Interval& other : distant) {
            const auto factor = (forms.Z() + Triangular(points.size(), -other)).inverse();
            if (!factor) {
                return false;
            }
            f = f * *factor;
        }
        const Triangular one(points.size(), 1);
        const Triangular plus = one + forms.Z();
        Triangular first = (even ? plus : one) * f;
        Triangular second = forms.one_minus_x() * (even ? one : plus) * f;
        for (std::size_t power = 0; power < of_qq.size(); ++power) {
            of_qq[power] += first.corner();
            of_rr[power] += second.corner();
            first = first * forms.Z();
            second = second * forms.Z();
        }
        return true;
    }

    std::optional<Triangular> weights(const Part& part, const Points& points) const {
        const Greater greater = greater_[part.front()];
        if (greater == Greater::C) {
            return Triangular::of(c_.square_of_C, points).inverse();
        }
        if (greater == Greater::B) {
            const auto inverse = Triangular::of(c_.square_of_B, points).inverse();
            return inverse ? std::optional(seen_squared_ * *inverse) : std::nullopt;
        }
        if (points.size() > 1 || seen_squared_.lower() <= 0) {
            return std::nullopt;
        }
        const Interval larger = max(value_at(c_.square_of_C, points.front()),
                                    value_at(c_.square_of_B, points.front()) / seen_squared_);
        return Triangular(1, larger).inverse();
    }

    const EnclosedCondition& c_;
    const Interval& seen_squared_;
    const std::vector<Group>& all_;
    std::vector<Greater> greater_{};
};

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
        if (holds_in_one(square, tau)) {
            return true;
        }
        const double in_time = width(tau) * square.upper();
        const double in_band = width(square) / top;
        if (std::max(in_time, in_band) < finest_) {
            return false;
        }
        if (in_time > in_band) {
            const double middle = median(tau);
            return holds(square, Interval(tau.lower(), middle), top) &&
                   holds(square, Interval(middle, tau.upper()), top);
        }
        const double middle = median(square);
        return holds(Interval(square.lower(), middle), tau, top) &&
               holds(Interval(middle, square.upper()), tau, top);
    }

  private:
    bool holds_in_one(const Interval& square, const Interval& tau) const {
        const Interval slowed = 1.0 - tau * square;
        if (slowed.lower() <= 0) {
            return false;
        }
        EnclosedPolynomial waves = c_.band;
        waves[0] -= square;
        const auto clusters = real_zeros(waves);
        return clusters && holds_for_all(*clusters, 0, {}, c_.scale * rise(square, tau));
    }

    /// omega^2/(1 - omega^2 dt^2/4), which rises with both.
    static Interval rise(const Interval& square, const Interval& tau) {
        const auto at = [](double one, double other) {
            return Interval(one) / (1.0 - Interval(one) * other);
        };
        return hull(at(square.lower(), tau.lower()), at(square.upper(), tau.upper()));
    }

    bool holds_for_all(const std::vector<ZeroCluster>& clusters, std::size_t next,
                       std::vector<Group> chosen, const Interval& seen_squared) const {
        if (next == clusters.size()) {
            return chosen.empty() || is_contractive(c_, chosen, seen_squared) ||
                   (least_ == Grade::paired && Pairing(c_, chosen, seen_squared).holds());
        }
        return std::ranges::all_of(clusters[next].counts, [&](int count) {
            std::vector<Group> more = chosen;
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
