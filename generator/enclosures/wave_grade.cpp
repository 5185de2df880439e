// SPDX-License-Identifier: MIT
#include "generator/enclosures/wave_grade.hpp"

#include <algorithm>
#include <functional>
#include <optional>

#include "generator/enclosures/triangular.hpp"

namespace nmbcgen {
namespace {

using Points = std::vector<Interval>;

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

Points points_of(const std::vector<WaveGroup>& groups) {
    Points points;
    for (const WaveGroup& group : groups) {
        points.insert(points.end(), group.count, group.where);
    }
    return points;
}

/// Which of C~^2 and B~^2/Omega^2 is the greater one at all waves of a group.
enum class Greater { C, B, unknown };

class Pairing {
  public:
    Pairing(const EnclosedCondition& condition, const std::vector<WaveGroup>& groups,
            const Interval& seen_squared)
        : c_(condition), seen_squared_(seen_squared), all_(groups) {
        for (const WaveGroup& group : groups) {
            greater_.push_back(greater_at(group.where));
        }
    }

    bool holds() const {
        if (all_.size() == 1 && all_.front().count == 1) {
            return c_.product.at(all_.front().where).lower() >= 0;
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
        const Interval difference = seen_squared_ * c_.square_of_C.at(x) - c_.square_of_B.at(x);
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
        std::vector<WaveGroup> mine;
        std::vector<WaveGroup> others;
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
        const Interval larger = max(c_.square_of_C.at(points.front()),
                                    c_.square_of_B.at(points.front()) / seen_squared_);
        return Triangular(1, larger).inverse();
    }

    const EnclosedCondition& c_;
    const Interval& seen_squared_;
    const std::vector<WaveGroup>& all_;
    std::vector<Greater> greater_{};
};

}  // namespace

bool is_contractive(const EnclosedCondition& c, const std::vector<WaveGroup>& groups,
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

bool is_paired(const EnclosedCondition& condition, const std::vector<WaveGroup>& groups,
               const Interval& seen_squared) {
    return Pairing(condition, groups, seen_squared).holds();
}

}  // namespace nmbcgen
