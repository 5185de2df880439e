// SPDX-License-Identifier: MIT
/// Integrals over pairs of elements against quadrature of the double integral as it stands.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <vector>

#include "generator/coupling/pair_matrix.hpp"
#include "generator/exact/rational.hpp"

using namespace nmbcgen;

namespace {

struct Numbers {
    double length, gap, other_length, horizon;
};

/// The hat function of a node of the pair: 0 and 1 of the first element, 2 and 3 of the second.
double hat(const Numbers& p, std::size_t node, double x, bool in_second) {
    const double start = in_second ? p.gap : 0;
    const double length = in_second ? p.other_length : p.length;
    if ((node >= 2) != in_second && p.gap != 0) {
        return 0;
    }
    const double along = (x - start) / length;
    return node % 2 == 0 ? 1 - along : along;
}

/// Over pieces between the breakpoints that lie within.
template <class Function>
double integral(const Function& f, std::vector<double> breaks, double from, double to) {
    static boost::math::quadrature::tanh_sinh<double> rule;
    breaks.push_back(from);
    breaks.push_back(to);
    std::ranges::sort(breaks);
    double sum = 0;
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        const double low = std::clamp(breaks[i - 1], from, to);
        const double high = std::clamp(breaks[i], from, to);
        if (high - low > 1e-12) {
            // over 0 .. 1, where no node of the rule rounds to an end, which it asserts
            const double width = high - low;
            sum += width *
                   rule.integrate([&](double t) { return f(low + width * t); }, 0.0, 1.0, 1e-11);
        }
    }
    return sum;
}

double entry(const Numbers& p, CouplingForm form, std::size_t i, std::size_t j) {
    const double end = p.gap + p.other_length;
    const auto inner = [&](double x) {
        const double from = std::max(p.gap, x - p.horizon);
        const double to = std::min(end, x + p.horizon);
        if (to <= from) {
            return 0.0;
        }
        const auto integrand = [&](double y) {
            const bool second = p.gap != 0;
            const double distance = std::abs(y - x);
            if (distance < 1e-14) {
                return 0.0;  // a bounded integrand, next to its own point
            }
            const double change = hat(p, j, y, second) - hat(p, j, x, false);
            const double test = form == CouplingForm::pairs
                                    ? (hat(p, i, y, second) - hat(p, i, x, false)) / 2
                                    : -hat(p, i, x, false);
            return test * change * 2 / (p.horizon * p.horizon * distance);
        };
        return integral(integrand, {x}, from, to);
    };
    return integral(inner, {p.gap - p.horizon, end - p.horizon, p.gap + p.horizon, end + p.horizon},
                    0, p.length);
}

}  // namespace

TEST_CASE("pairs of elements of any lengths, distance and horizon") {
    CHECK(rc::check("the double integral", [] {
        const auto part = [](int low, int high) {
            return Rational(*rc::gen::inRange(low, high + 1), *rc::gen::inRange(1, 6));
        };
        const Rational length = part(1, 6);
        const Rational other = part(1, 6);
        const int place = *rc::gen::inRange(0, 4);  // the same, next on either side, or farther
        const Rational farther = place == 3 ? part(1, 3) : 0;
        ElementPair pair{length, 0, place == 0 ? length : other, part(1, 12)};
        if (place != 0) {
            pair.gap = place == 2 ? Rational(-other) : Rational(length + farther);
        }
        const Numbers p{nearest_double(pair.length), nearest_double(pair.gap),
                        nearest_double(pair.other_length), nearest_double(pair.horizon)};
        const auto form = *rc::gen::element(CouplingForm::pairs, CouplingForm::rows);
        const std::vector<LogNumber> matrix = pair_matrix(pair, form);
        const std::size_t size = place == 0 ? 2 : 4;
        RC_ASSERT(matrix.size() == size * size);
        const auto i = std::size_t(*rc::gen::inRange(0, int(matrix.size())));
        const double expected = entry(p, form, i / size, i % size);
        // A jump of the integrand at its own point costs the quadrature digits.
        RC_ASSERT(std::abs(nearest_double(matrix[i]) - expected) < 1e-7);
    }));
}
