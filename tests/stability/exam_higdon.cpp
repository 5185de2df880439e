// SPDX-License-Identifier: GPL-2.0-or-later
/// Products of two NMBC1, (s C_1 - B_1)(s C_2 - B_2) = 0 on every ghost layer, each exact at a wave
/// number of its own (after Higdon): another condition of second order, held against the
/// project's.
///
/// The amplitudes of theory's formula depend on the condition by the ratio Delta(k_i)/Delta(k_o)
/// alone, which is 1 at a fixed end and a product here: entry by entry, R is R_1 R_2 / R_fixed.
#include <cmath>
#include <limits>

#include "generator/exact/rational_function.hpp"
#include "generator/stability/band_reflection.hpp"
#include "generator/stability/band_search.hpp"
#include "generator/stability/modal.hpp"
#include "generator/stability/mode_polynomial.hpp"
#include "generator/stability/reflection.hpp"
#include "generator/stability/round_trip.hpp"
#include "tests/stability/boundary.hpp"

namespace {

using nmbcgen::HalfSpace;
using nmbcgen::Reflection;

/// NMBC1 of a lattice, with B scaled to be exact at wave number xi; xi = 0: as it is.
HalfSpace exact_at(HalfSpace h, double xi) {
    if (xi > 0) {
        const double scale =
            std::sqrt(omega_squared(h, xi)) / std::tan(xi * h.stride / 2) * h.stride / 2;
        for (double& b : h.b) {
            b *= scale;
        }
        h.O *= nmbcgen::constant(nmbcgen::Rational(scale));
        h.modes = mode_coefficients(h);
    }
    return h;
}

struct Product {
    HalfSpace one;
    HalfSpace other;

    Reflection at(double omega) const {
        Reflection R = reflection(one, omega);
        const Reflection R_other = reflection(other, omega);
        const Reflection R_fixed = reflection(fixed_end(one), omega);
        R.matrix = R.matrix.cwiseProduct(R_other.matrix).cwiseQuotient(R_fixed.matrix);
        return R;
    }

    bool is_stable() const {
        std::vector<double> frequencies;
        for (const HalfSpace* factor : {&one, &other}) {
            const nmbcgen::BoundaryModes modes(*factor);
            if (modes.growing() || modes.resonance()) {
                return false;
            }
            const auto of_factor = critical_frequencies(*factor);
            frequencies.insert(frequencies.end(), of_factor.begin(), of_factor.end());
        }
        std::ranges::sort(frequencies);
        const auto supremum = [this](double omega) {
            const Reflection R = at(omega);
            return std::sqrt(round_trip_supremum(R, R));
        };
        return nmbcgen::largest_over_band(frequencies, supremum, nmbcgen::amplification_limit)
                   .value <= nmbcgen::amplification_limit;
    }

    /// Of the energy, mean over xi = 0.05 .. 0.3.
    double reflected() const {
        constexpr int samples = 25;
        double sum = 0;
        for (int i = 0; i < samples; ++i) {
            const double xi = 0.05 + 0.25 * (i + 0.5) / samples;
            // One wave travels at these frequencies, or the first one is it.
            sum += at(std::sqrt(omega_squared(one, xi))).matrix.col(0).squaredNorm();
        }
        return sum / samples;
    }
};

/// The least reflection of the undamped, stable conditions of order 2 to 4 with strides to n + 2.
double least_reflected(unsigned horizon, double G) {
    double least = std::numeric_limits<double>::infinity();
    for (const unsigned order : {2U, 3U, 4U}) {
        for (unsigned stride = 1; stride <= horizon + 2; ++stride) {
            try {
                const HalfSpace h = nmbcgen::test::half_space({horizon, order, stride, G});
                if (stability_grade(h) != nmbcgen::Grade::none) {
                    least = std::min(least, mean_reflected_energy(h, 0.05, 0.3));
                }
            } catch (const nmbcgen::NoSuchBoundary&) {
                continue;
            }
        }
    }
    return least;
}

TEST_CASE("the product rule holds: the product with a fixed end is the other factor") {
    const HalfSpace h = nmbcgen::test::half_space({2, 1, 1, 0.6});
    const Product product{h, fixed_end(h).half_space};
    for (const double omega : {0.1, 0.3, 0.5}) {
        const double difference =
            (product.at(omega).matrix - reflection(h, omega).matrix).cwiseAbs().maxCoeff();
        CHECK(difference < 1e-12);
    }
}

TEST_CASE("where a product exact for long waves is stable, a matched condition reflects less") {
    int stable = 0;
    for (const unsigned horizon : {1U, 2U, 3U, 4U}) {
        for (const double G : {0.0, 0.25, 0.5, 1.0, 1.5, 2.0}) {
            for (const unsigned stride : {1U, horizon}) {
                const HalfSpace h = nmbcgen::test::half_space({horizon, 1, stride, G});
                const Product product{h, h};
                if (product.is_stable()) {
                    ++stable;
                    CAPTURE(horizon);
                    CAPTURE(G);
                    CAPTURE(stride);
                    // n = 1, G = 1: NMBC1 has order 2 there, its square order 4, as NMBC4 has.
                    constexpr double tie = 1.02;
                    CHECK(least_reflected(horizon, G) < tie * product.reflected());
                }
            }
        }
    }
    CHECK(stable == 16);
}

TEST_CASE("exact inside the band, a product can reflect less than matching at long waves alone") {
    const HalfSpace h = nmbcgen::test::half_space({3, 1, 3, 1.5});
    const Product product{exact_at(h, 0.1), exact_at(h, 0.25)};
    CHECK(product.is_stable());
    CHECK(product.reflected() == nmbcgen::test::relative(1.29e-7, 0.01));
    CHECK(least_reflected(3, 1.5) == nmbcgen::test::relative(1.58e-6, 0.01));
}

}  // namespace
