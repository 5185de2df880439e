// SPDX-License-Identifier: GPL-2.0-or-later
/// Rows of the surface node method, and the paper's Fig. 3: a bar with both of its ends.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "generator/closures/surface_node.hpp"
#include "generator/exact/rational.hpp"

using namespace nmbcgen;

namespace {

std::string row_text(unsigned horizon, bool corrected) {
    std::string text;
    for (const Rational& entry : surface_node(horizon, corrected).row) {
        text += (text.empty() ? "" : " ") + to_string(entry);
    }
    return text;
}

std::vector<double> doubles(const std::vector<Rational>& numbers) {
    std::vector<double> values;
    values.reserve(numbers.size());
    for (const Rational& number : numbers) {
        values.push_back(nearest_double(number));
    }
    return values;
}

/// Si(x), the sum of its series.
double sine_integral(double x) {
    double term = x;
    double sum = x;
    for (int n = 1; n < 100; ++n) {
        term *= -x * x / ((2.0 * n) * (2.0 * n + 1));
        sum += term / (2 * n + 1);
    }
    return sum;
}

constexpr double horizon_length = 0.1;  // of a bar of length 1 [m]

double omega_over_speed(double k) {
    const double phase = k * horizon_length;
    return std::sqrt(2 * (phase * sine_integral(phase) + std::cos(phase) - 1)) / horizon_length;
}

/// omega_1 = 7851.29098 of the paper's bar [1/s].
double speed() {
    return 7851.29098 / omega_over_speed(std::numbers::pi / 2);
}

/// (7): fixed at x = 0, free at x = 1.
double series(double x, double t) {
    double sum = 0;
    for (int m = 1; m <= 40; ++m) {
        const double k = (2 * m - 1) * std::numbers::pi / 2;
        sum += std::sqrt(std::numbers::pi) / 250 * std::sin(k / 2) * std::exp(-k * k / 400) *
               std::sin(k * x) * std::cos(speed() * omega_over_speed(k) * t);
    }
    return sum;
}

/// The bar in central differences: nodes at (i + 1/2)/count, the surface nodes of (4) at both ends.
class Bar {
  public:
    Bar(std::size_t count, bool corrected)
        : closure_(surface_node(unsigned(std::lround(horizon_length * double(count))), corrected)),
          beta_(doubles(closure_.quadrature)),
          row_(doubles(closure_.row)),
          u_(count),
          v_(count) {
        for (std::size_t i = 0; i < count; ++i) {
            u_[i] = 0.02 * std::exp(-100 * std::pow(place(i) - 0.5, 2));
        }
    }

    double place(std::size_t i) const { return (double(i) + 0.5) / double(u_.size()); }

    void advance(double dt, std::size_t steps) {
        for (std::size_t step = 0; step < steps; ++step) {
            const std::vector<double> a = accelerations();
            // Central differences start with half a kick.
            const double kick = is_started_ ? dt : dt / 2;
            is_started_ = true;
            for (std::size_t i = 0; i < u_.size(); ++i) {
                v_[i] += kick * a[i];
                u_[i] += dt * v_[i];
            }
        }
    }

    /// ||u - (7)||/||u_0||
    double error(double t) const {
        double difference = 0;
        double start = 0;
        for (std::size_t i = 0; i < u_.size(); ++i) {
            difference += std::pow(u_[i] - series(place(i), t), 2);
            start += std::pow(0.02 * std::exp(-100 * std::pow(place(i) - 0.5, 2)), 2);
        }
        return std::sqrt(difference / start);
    }

  private:
    std::vector<double> accelerations() const {
        const auto count = std::ptrdiff_t(u_.size());
        const auto m = std::ptrdiff_t(beta_.size());
        double surface = 0;  // at x = 1; 0 at x = 0
        for (std::ptrdiff_t i = 0; i < m; ++i) {
            surface += row_[std::size_t(i)] * u_[std::size_t(count - 1 - i)];
        }
        const auto at = [&](std::ptrdiff_t i) {
            if (i >= 0 && i < count) {
                return u_[std::size_t(i)];
            }
            const auto f = double(i < 0 ? -i : i - count + 1);
            return i < 0 ? -(2 * f - 1) * u_.front() : 2 * f * surface - (2 * f - 1) * u_.back();
        };
        const double spacing = 1 / double(count);
        const double factor = speed() * speed() / (horizon_length * spacing);
        std::vector<double> a(u_.size());
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            for (std::ptrdiff_t k = 1; k <= m; ++k) {
                a[std::size_t(i)] += factor * beta_[std::size_t(k) - 1] / double(k * k) *
                                     (at(i + k) - 2 * at(i) + at(i - k));
            }
        }
        return a;
    }

    SurfaceNode closure_;
    std::vector<double> beta_;
    std::vector<double> row_;
    std::vector<double> u_;
    std::vector<double> v_;
    bool is_started_ = false;
};

}  // namespace

TEST_CASE("rows, worked out with an algebra system") {
    CHECK(row_text(1, false) == "1");
    CHECK(row_text(2, false) == "21/22 1/22");
    CHECK(row_text(3, false) == "137/150 11/150 1/75");
    CHECK(row_text(4, false) == "1409/1572 113/1572 41/1572 3/524");
    CHECK(row_text(2, true) == "29/30 1/30");
    CHECK(row_text(3, true) == "173/186 11/186 1/93");
    CHECK(row_text(4, true) == "1697/1860 113/1860 41/1860 3/620");
}

TEST_CASE("a shift and a uniform strain are kept, exactly, at every horizon") {
    for (unsigned m = 1; m <= largest_closure_horizon; ++m) {
        for (const bool corrected : {false, true}) {
            const SurfaceNode node = surface_node(m, corrected);
            Rational sum = 0;
            Rational strained = 0;  // u_i = -(i - 1/2)
            Rational modulus = 0;
            for (unsigned i = 1; i <= m; ++i) {
                CHECK(node.row[i - 1] > 0);
                sum += node.row[i - 1];
                strained -= node.row[i - 1] * Rational(2 * int(i) - 1, 2);
                modulus += node.quadrature[i - 1] / m;
                CHECK(node.ghosts[i - 1][0] + node.ghosts[i - 1][1] == 1);
            }
            CHECK(sum == 1);
            CHECK(modulus == (corrected ? Rational(1) : 1 - Rational(1, 2 * int(m))));
            // The surface is at x = 0: it stays there under the traction of this strain.
            CHECK(strained + node.load * modulus == 0);
        }
    }
}

TEST_CASE("the series' frequencies are the paper's") {
    CHECK(std::abs(speed() * omega_over_speed(79 * std::numbers::pi / 2) - 304274.639) < 6e-4);
}

TEST_CASE("Fig. 3: errors at 0.1, 0.2 and 0.4 ms as listed, of the printed and corrected chain") {
    struct Column {
        std::size_t count;
        bool corrected;
        std::array<double, 3> percent;
    };
    for (const Column& column :
         {Column{100, false, {9.36, 20.0, 35.8}}, Column{100, true, {.18, .32, .28}},
          Column{500, false, {1.83, 4.11, 6.74}}}) {
        Bar bar(column.count, column.corrected);
        // So short that steps add less than the last digit.
        constexpr double dt = 1e-7;
        std::size_t done = 0;
        constexpr std::array<std::size_t, 3> steps{1000, 2000, 4000};
        for (std::size_t i = 0; i < steps.size(); ++i) {
            bar.advance(dt, steps[i] - done);
            done = steps[i];
            const double last_digit = column.percent[i] > 10 ? 0.1 : 0.01;
            CHECK(std::abs(100 * bar.error(double(done) * dt) - column.percent[i]) < last_digit);
        }
    }
}

TEST_CASE("horizons that there are not") {
    CHECK_THROWS_AS(surface_node(0, false), std::invalid_argument);
    CHECK_THROWS_AS(surface_node(largest_closure_horizon + 1, true), std::invalid_argument);
}
