// SPDX-License-Identifier: GPL-2.0-or-later
/// Every root of every polynomial at a corner of the intervals is in the discs.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "generator/enclosures/root_discs.hpp"
#include "generator/stability/polynomial_roots.hpp"
#include "tests/support/generators.hpp"

using nmbcgen::ComplexInterval;
using nmbcgen::EnclosedPolynomial;
using nmbcgen::Interval;
using nmbcgen::RootDisc;

namespace {

/// Roots are found in doubles, nearby ones to the square root of roundings.
constexpr double roundings = 1e-7;

bool holds(const RootDisc& disc, const std::complex<double>& root) {
    return std::abs(root - disc.centre) <= disc.radius + roundings * (1 + std::abs(root));
}

/// Of the polynomial at a corner: whether each coefficient is at the upper end.
void require_roots_in_discs(const EnclosedPolynomial& f, const std::vector<RootDisc>& discs,
                            const std::vector<bool>& corner) {
    std::vector<double> coefficients;
    for (std::size_t i = 0; i < f.size(); ++i) {
        coefficients.push_back(corner[i] ? f[i].upper() : f[i].lower());
    }
    const auto roots = nmbcgen::polynomial_roots(coefficients);
    for (const auto& root : roots) {
        REQUIRE(
            std::ranges::any_of(discs, [&](const RootDisc& disc) { return holds(disc, root); }));
    }
    for (const RootDisc& disc : discs) {
        if (std::ranges::count(discs, disc.component, &RootDisc::component) == 1) {
            REQUIRE(
                std::ranges::any_of(roots, [&](const auto& root) { return holds(disc, root); }));
        }
    }
}

std::vector<RootDisc> discs_of(const EnclosedPolynomial& f) {
    return nmbcgen::root_discs(f,
                               [&f](const ComplexInterval& z) { return nmbcgen::value_at(f, z); });
}

}  // namespace

TEST_CASE("roots of random corners are in the discs, one in each that is alone") {
    CHECK(rc::check("root discs", [] {
        const int degree = nmbcgen::test::whole_number(2, 7);
        const double width = std::pow(10.0, -nmbcgen::test::whole_number(1, 6));
        EnclosedPolynomial f;
        for (int i = 0; i <= degree; ++i) {
            const double middle = nmbcgen::test::whole_number(-1000, 1001) / 500.0;
            f.emplace_back(middle - width, middle + width);
        }
        const auto discs = discs_of(f);
        RC_PRE(!discs.empty());
        for (int tried = 0; tried < 8; ++tried) {
            std::vector<bool> corner;
            for (int i = 0; i <= degree; ++i) {
                corner.push_back(nmbcgen::test::whole_number(0, 2) == 1);
            }
            require_roots_in_discs(f, discs, corner);
        }
    }));
}

// Discs about 0.39 touch once they are widened, and radii from wider discs than before were 6 times
// too small.
TEST_CASE("a disc is narrowed only, and by what holds for its neighbours") {
    const EnclosedPolynomial f{Interval(-0.0974651, -0.0895616), Interval(0.347215, 0.38983),
                               Interval(-1.43004, -1.31099),     Interval(1.17726, 1.26231),
                               Interval(3.10256, 3.30252),       Interval(0.975936, 1.02406)};
    const auto discs = discs_of(f);
    REQUIRE(discs.size() == 5);
    for (unsigned which = 0; which < 64; ++which) {
        std::vector<bool> corner;
        for (unsigned i = 0; i < 6; ++i) {
            corner.push_back((which >> i & 1U) != 0);
        }
        require_roots_in_discs(f, discs, corner);
    }
}
