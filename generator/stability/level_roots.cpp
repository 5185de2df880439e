// SPDX-License-Identifier: MIT
#include "generator/stability/level_roots.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "generator/stability/polynomial_roots.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;

/// Of p - y.
double value_at(const std::vector<double>& p, double y, double x) {
    double value = 0;
    for (std::size_t i = p.size() - 1; i > 0; --i) {
        value = (value + p[i]) * x;
    }
    return value + (p[0] - y);
}

/// The coefficients of p in powers of x - origin.
std::vector<double> shifted(std::vector<double> p, double origin) {
    for (std::size_t first = 0; first + 1 < p.size(); ++first) {
        for (std::size_t i = p.size() - 1; i-- > first;) {
            p[i] += origin * p[i + 1];
        }
    }
    return p;
}

/// Of p - y between two places where it has different signs, or is 0.
double root_between(const std::vector<double>& p, double y, double low, double at_low, double high,
                    double at_high) {
    if (at_low == 0 || at_high == 0) {
        return at_low == 0 ? low : high;
    }
    std::uintmax_t most = 200;
    const auto [left, right] = boost::math::tools::toms748_solve(
        [&](double x) { return value_at(p, y, x); }, low, high, at_low, at_high,
        boost::math::tools::eps_tolerance<double>(), most);
    return std::abs(value_at(p, y, left)) < std::abs(value_at(p, y, right)) ? left : right;
}

bool is_between(double at_low, double at_high) {
    return at_low == 0 || at_high == 0 || (at_low < 0) != (at_high < 0);
}

/// Of p - y from 0 to the right, or to the left, where p has no extremum.
std::optional<double> root_beyond(const std::vector<double>& p, double y, double direction) {
    const bool is_odd = p.size() % 2 == 0;
    const bool rises = (p.back() > 0) != (direction < 0 && is_odd);
    double near = 0;
    double at_near = p[0] - y;
    if (at_near != 0 && (at_near > 0) == rises) {
        return std::nullopt;
    }
    for (double far = direction; std::isfinite(far); far *= 2) {
        const double at_far = value_at(p, y, far);
        if ((at_far > 0) == rises) {
            return direction > 0 ? root_between(p, y, near, at_near, far, at_far)
                                 : root_between(p, y, far, at_far, near, at_near);
        }
        near = far;
        at_near = at_far;
    }
    return std::nullopt;
}

/// Divides x - root out of p, a polynomial with that root.
void divide(std::vector<double>& p, double root) {
    for (std::size_t i = p.size() - 1; i-- > 0;) {
        p[i] += root * p[i + 1];
    }
    p.erase(p.begin());
}

/// Polished real roots have no imaginary part but roundings. Those of two that are about to meet
/// are larger where they are closer than 1e-5.
std::vector<Complex> with_real_ones(std::vector<Complex> roots) {
    constexpr double real_enough = 1e-10;
    for (Complex& root : roots) {
        root = std::abs(root.imag()) < real_enough ? root.real() : root;
    }
    return roots;
}

/// Of what is left without its real roots.
std::vector<Complex> roots_of_rest(const std::vector<double>& rest) {
    if (rest.size() != 3) {
        return polynomial_roots(rest);
    }
    const double half = -rest[1] / (2 * rest[2]);
    const Complex root = std::sqrt(Complex(half * half - rest[0] / rest[2]));
    return {half + root, half - root};
}

}  // namespace

LevelRoots::LevelRoots(std::vector<double> p) : p_(std::move(p)) {
    while (!p_.empty() && p_.back() == 0) {
        p_.pop_back();
    }
    if (p_.size() < 2) {
        p_.clear();
        return;
    }
    std::vector<double> extrema;
    for (const Complex x : polynomial_roots(derivative(p_))) {
        constexpr double far = 10;
        is_wide_ = is_wide_ || std::abs(x) > far;
        if (x.imag() == 0) {
            extrema.push_back(x.real());
        }
    }
    if (is_wide_) {
        return;
    }
    std::ranges::sort(extrema);
    for (const double x : extrema) {
        cuts_.push_back({x, shifted(p_, x)});
        cuts_.back().around[1] = 0;  // but for the roundings of x
    }
    is_monotone_ = cuts_.empty();
    if (is_monotone_) {
        cuts_.push_back({0, p_});
    }
}

std::vector<double> LevelRoots::real_roots(double y) const {
    std::vector<double> roots;
    const auto add_beyond = [&](const Cut& cut, double direction) {
        if (const auto distance = root_beyond(cut.around, y, direction)) {
            roots.push_back(cut.x + *distance);
        }
    };
    if (is_monotone_) {
        const bool is_right = (p_.front() < y) == (p_.back() > 0);
        add_beyond(cuts_.front(), is_right ? 1 : -1);
        return roots;
    }
    add_beyond(cuts_.front(), -1);
    for (std::size_t i = 1; i < cuts_.size(); ++i) {
        const Cut& low = cuts_[i - 1];
        const Cut& high = cuts_[i];
        const double at_low = low.around[0] - y;
        const double at_high = high.around[0] - y;
        if (is_between(at_low, at_high)) {
            const bool is_low = std::abs(at_low) < std::abs(at_high);
            const Cut& near = is_low ? low : high;
            roots.push_back(near.x + root_between(near.around, y, low.x - near.x, at_low,
                                                  high.x - near.x, at_high));
        }
    }
    add_beyond(cuts_.back(), 1);
    return roots;
}

std::vector<Complex> LevelRoots::at(double y) const {
    if (p_.empty()) {
        return {};
    }
    std::vector<double> p = p_;
    p[0] -= y;
    if (is_wide_) {
        return with_real_ones(polynomial_roots(p));
    }
    std::vector<double> real = real_roots(y);
    std::vector<Complex> roots(real.begin(), real.end());
    // Small ones first: so the coefficients keep their digits (Wilkinson 1963).
    std::ranges::sort(real, {}, [](double x) { return std::abs(x); });
    std::vector<double> rest = p;
    for (const double root : real) {
        divide(rest, root);
    }
    for (const Complex root : roots_of_rest(rest)) {
        roots.push_back(polished(p, root));
    }
    return roots;
}

}  // namespace nmbcgen
