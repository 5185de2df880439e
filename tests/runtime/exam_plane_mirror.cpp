// SPDX-License-Identifier: GPL-2.0-or-later
/// Mirrors at the sides of planes: the plane is one half, or a quarter, of a larger one.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

constexpr std::size_t half_x = 14;
constexpr std::size_t half_y = 12;

struct Mirrors {
    bool is_odd_x = false;
    bool is_odd_y = false;

    /// Of component a on the other side of the mirror across an axis.
    double sign(std::size_t axis, std::size_t a) const {
        const bool is_odd = axis == 0 ? is_odd_x : is_odd_y;
        return (a == axis) == is_odd ? 1 : -1;
    }
};

double start_at(std::size_t a, std::size_t x, std::size_t y) {
    return std::sin(double(a + 2 * x * x + 3 * y * y + x * y));
}

/// Puts the same waves into the quarter and, with their images, into the whole.
void fill(nmbc::Plane& quarter, nmbc::Plane& whole, const Mirrors& mirrors) {
    const auto place = [](std::size_t half, bool is_image, std::size_t i) {
        return is_image ? half - 1 - i : half + i;
    };
    const auto put = [&](std::size_t a, std::size_t x, std::size_t y) {
        const double u = start_at(a, x, y);
        quarter.displacement(a)[quarter.entry(x, y)] = u;
        for (const unsigned image : {0U, 1U, 2U, 3U}) {
            const bool image_x = image % 2 == 1;
            const bool image_y = image / 2 == 1;
            const std::size_t at =
                whole.entry(place(half_x, image_x, x), place(half_y, image_y, y));
            whole.displacement(a)[at] =
                u * (image_x ? mirrors.sign(0, a) : 1) * (image_y ? mirrors.sign(1, a) : 1);
        }
    };
    for (const std::size_t a : {0U, 1U}) {
        for (std::size_t y = 0; y < half_y; ++y) {
            for (std::size_t x = 0; x < half_x; ++x) {
                put(a, x, y);
            }
        }
    }
}

/// The largest difference between the quarter and that of the whole.
double difference(const nmbc::Plane& quarter, const nmbc::Plane& whole) {
    double largest = 0;
    for (const std::size_t a : {0U, 1U}) {
        for (std::size_t y = 0; y < half_y; ++y) {
            for (std::size_t x = 0; x < half_x; ++x) {
                const double own = quarter.displacement(a)[quarter.entry(x, y)];
                const double other = whole.displacement(a)[whole.entry(half_x + x, half_y + y)];
                largest = std::max(largest, std::abs(own - other));
            }
        }
    }
    return largest;
}

/// The largest difference between a quarter and the whole in 300 steps.
double departure(const nmbc::PlaneModel& model, const Mirrors& mirrors, double stretch) {
    nmbc::PlaneParameters p{
        .nx = half_x, .ny = half_y, .spacing = 0.5, .youngs_modulus = 7, .density = 3};
    const nmbc::PlaneSides sides{nmbc::MirrorSide{mirrors.is_odd_x}, nmbc::FreeSide{},
                                 nmbc::MirrorSide{mirrors.is_odd_y}, nmbc::FreeSide{}};
    p.time_step = 1.8 / std::sqrt(nmbc::highest_eigenvalue(model, sides, p.nx, p.ny)) / p.rate();
    nmbc::PlaneParameters of_whole = p;
    of_whole.nx *= 2;
    of_whole.ny *= 2;
    nmbc::Plane quarter(model, sides, p);
    nmbc::Plane whole(model, nmbc::PlaneSides::all(nmbc::FreeSide{}), of_whole);
    fill(quarter, whole, mirrors);
    const bool breaks = stretch > 0;
    if (breaks) {
        const auto all_may = [](auto, auto) { return false; };
        quarter.break_above(stretch, all_may);
        whole.break_above(stretch, all_may);
        // From one mirror to beyond it.
        quarter.cut({-0.5, 5.5}, {4.2, 5.5});
        whole.cut({half_x - 5.2, half_y + 5.5}, {half_x + 4.2, half_y + 5.5});
        whole.cut({half_x - 5.2, half_y - 6.5}, {half_x + 4.2, half_y - 6.5});
    }
    quarter.start();
    whole.start();
    quarter.advance(300);
    whole.advance(300);
    constexpr double roundings = 1e-11;
    CHECK(quarter.energies().staggered ==
          doctest::Approx(whole.energies().staggered / 4).epsilon(roundings));
    if (breaks) {
        CHECK(quarter.broken() > 10);
        CHECK(quarter.broken() == doctest::Approx(whole.broken() / 4).epsilon(1e-15));
        CHECK(quarter.released() ==
              doctest::Approx(whole.released() / 4).scale(0).epsilon(roundings));
    }
    return difference(quarter, whole);
}

}  // namespace

TEST_CASE("a plane between two mirrors is a quarter of a larger one") {
    for (const bool is_odd_x : {false, true}) {
        for (const bool is_odd_y : {false, true}) {
            CAPTURE(is_odd_x);
            CAPTURE(is_odd_y);
            const Mirrors mirrors{is_odd_x, is_odd_y};
            for (const unsigned radius_squared : {1U, 2U, 4U, 9U, 10U}) {
                CAPTURE(radius_squared);
                // 300 steps of roundings, which meet again and again
                CHECK(departure(nmbc::nopd2d(radius_squared, 0.3, 0.5), mirrors, 0) < 1e-11);
            }
            CHECK(departure(nmbc::bond2d(4, {1, 0.5, 0.25}), mirrors, 0) < 1e-11);
        }
    }
}

TEST_CASE("bonds break beside a mirror as they do in the whole") {
    CHECK(departure(nmbc::bond2d(4, {1, 0.5, 0.25}), {false, false}, 2.5) < 1e-11);
    // The image of a bond that is pulled is pushed, beside an odd one.
    nmbc::Plane odd(nmbc::bond2d(4, {1, 0.5, 0.25}),
                    nmbc::PlaneSides::all(nmbc::MirrorSide{.is_odd = true}),
                    {.nx = 20, .ny = 20, .time_step = 0.1});
    CHECK_THROWS_AS(odd.break_above(0.1, [](auto, auto) { return false; }), std::invalid_argument);
}

TEST_CASE("beside a mirror steps are as long as in the whole, and a thin body is refused") {
    const nmbc::PlaneModel model = nmbc::nopd2d(4, 0.3, 0.5);
    const nmbc::PlaneSides mirrored = nmbc::PlaneSides::all(nmbc::MirrorSide{});
    CHECK(nmbc::highest_eigenvalue(model, mirrored, 20, 20) <
          1.0101 * nmbc::highest_eigenvalue(model));
    CHECK_THROWS_AS(nmbc::Plane(model, mirrored, {.nx = 3, .ny = 20, .time_step = 0.1}),
                    std::invalid_argument);
}
