// SPDX-License-Identifier: GPL-2.0-or-later
/// The paper's bounds (54) and (55), exactly, and what (55) leaves out.
#include <doctest/doctest.h>

#include <cmath>

#include "generator/exact/algebraic_number.hpp"
#include "generator/pipeline.hpp"
#include "generator/stability/critical_values.hpp"
#include "generator/stability/polynomial_roots.hpp"
#include "generator/stability/scalar.hpp"

namespace {

using Texts = std::vector<std::string>;

/// "[low, high]" for each window, end points as exact text.
Texts windows_of(unsigned horizon, unsigned order, unsigned stride = 1) {
    const auto table = nmbcgen::derive({"nopd1d", horizon, order, stride, std::nullopt});
    Texts texts;
    for (const auto& window : nmbcgen::scalar_windows(table)) {
        texts.push_back("[" + to_text(window.low) + ", " +
                        (window.high ? to_text(*window.high) : "inf") + "]");
    }
    return texts;
}

Texts poles_of(unsigned horizon, unsigned order) {
    const auto table = nmbcgen::derive({"nopd1d", horizon, order, 1, std::nullopt});
    Texts texts;
    for (const auto& pole : poles(even_and_odd_parts(table))) {
        texts.push_back(to_text(pole));
    }
    return texts;
}

TEST_CASE("NMBC1: every G") {
    for (unsigned horizon = 1; horizon <= 4; ++horizon) {
        CHECK(windows_of(horizon, 1) == Texts{"[0, inf]"});
    }
}

TEST_CASE("(54), NMBC2, as printed, and the poles inside it") {
    CHECK(windows_of(1, 2) == Texts{"[0, 1]"});
    CHECK(windows_of(2, 2) == Texts{"[0, 208/85]"});
    CHECK(windows_of(3, 2) == Texts{"[0, 405/98]"});
    CHECK(poles_of(1, 2) == Texts{"0"});
    CHECK(poles_of(2, 2) == Texts{"128/85"});
    CHECK(poles_of(3, 2) == Texts{"162/49"});
}

TEST_CASE("(55), NMBC3: the printed intervals hold, and so does a second one each") {
    CHECK(windows_of(1, 3) == Texts{"[0, 2/3]", "[1, inf]"});
    CHECK(windows_of(2, 3) ==
          Texts{"[(5584 - 80*sqrt(433))/4335, (5584 + 80*sqrt(433))/4335]", "[208/85, inf]"});
    CHECK(windows_of(3, 3) ==
          Texts{"[(11583 - 27*sqrt(2937))/4802, (11583 + 27*sqrt(2937))/4802]", "[405/98, inf]"});
    // The pole at n = 2 lies inside the printed interval, 0.904 to 1.672.
    CHECK(poles_of(2, 3) == Texts{"(-128 + 192*sqrt(161))/1445"});
}

TEST_CASE("NMBC4") {
    CHECK(windows_of(1, 4) == Texts{"[0, 2 - sqrt(2)]", "[2/3, 2 + sqrt(2)]"});
}

TEST_CASE("a stride above 1 has no scalar window") {
    CHECK(windows_of(2, 2, 2).empty());
}

/// Values of t = tan(xi/2), ascending: one between any two neighbouring zeros of E and O on w =
/// -t^2 < 0, where |R| - 1 can change its sign, and evenly spread ones.
std::vector<double> sample_places(const nmbcgen::HalfSpace& h) {
    std::vector<double> zeros{1e-3, 1e3};
    for (const auto* polynomial : {&h.E, &h.O}) {
        for (const auto w : nmbcgen::nonzero_roots(*polynomial)) {
            if (w.real() < 0 && std::abs(w.imag()) < 1e-9 * std::abs(w)) {
                zeros.push_back(std::sqrt(-w.real()));
            }
        }
    }
    std::ranges::sort(zeros);
    std::vector<double> places;
    for (std::size_t i = 0; i + 1 < zeros.size(); ++i) {
        places.push_back(std::sqrt(zeros[i] * zeros[i + 1]));
    }
    for (int k = 1; k < 200; ++k) {
        places.push_back(std::tan(3.14159265358979 * k / 400));
    }
    return places;
}

TEST_CASE("the exact windows agree with |R| <= 1 by sampling") {
    for (const auto& which : {std::pair{1U, 4U}, std::pair{2U, 4U}, std::pair{3U, 3U}}) {
        const unsigned horizon = which.first;
        const unsigned order = which.second;
        const auto table = nmbcgen::derive({"nopd1d", horizon, order, 1, std::nullopt});
        const auto exact = nmbcgen::scalar_windows(table);
        for (int i = 1; i < 160; ++i) {
            const nmbcgen::Rational G(nmbcgen::Integer(2 * i + 1), nmbcgen::Integer(40));
            const bool inside = std::ranges::any_of(exact, [&G](const auto& window) {
                return compare(window.low, G) < 0 && (!window.high || compare(*window.high, G) > 0);
            });
            const auto h = nmbcgen::make_half_space(table, G);
            double largest = 0;
            for (const double t : sample_places(h)) {
                const auto value = [t](const nmbcgen::Polynomial& f) {
                    double sum = 0;
                    for (std::size_t j = f.size(); j-- > 0;) {
                        sum = sum * -t * t + f[j].convert_to<double>();
                    }
                    return sum;
                };
                const double omega = std::sqrt(omega_squared(h, 2 * std::atan(t)));
                const double C = omega * value(h.E);
                const double B = t * value(h.O);
                largest = std::max(largest, std::abs((C - B) / (C + B)));
            }
            CAPTURE(horizon);
            CAPTURE(order);
            CAPTURE(G.convert_to<double>());
            if (inside) {
                CHECK(largest <= 1 + 1e-9);
            } else {
                CHECK(largest > 1);
            }
        }
    }
}

}  // namespace
