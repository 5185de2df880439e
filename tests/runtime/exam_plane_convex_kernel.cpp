// SPDX-License-Identifier: MIT
/// Planes between sides of convex kernels (Wu 2015), corners included.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nmbc/plane.hpp>
#include <nmbc/plane_convex_kernel.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/runtime/closed_planes.hpp"

namespace {

constexpr std::array<unsigned, 3> radii{2, 8, 13};  // of n = 1, 2, 3

nmbc::CorrespondenceModel spline(unsigned radius_squared, double G) {
    return nmbc::with_influence(nmbc::nopd2d(radius_squared, 0.3, G),
                                nmbc::spline_influence(radius_squared));
}

nmbc::ClosedSide kernel(const nmbc::CorrespondenceModel& model) {
    return {std::make_shared<const nmbc::PlaneClosure>(nmbc::convex_kernel_closure(model))};
}

/// The forces on the nodes of a square of kernel sides in units of the stress that a strain e_xx,
/// e_yy in the ratio of 5 to 1 has along x, row by row.
struct Forces {
    std::size_t size = 0;
    std::vector<std::array<double, 2>> of{};

    explicit Forces(const nmbc::CorrespondenceModel& model) {
        nmbc::Plane plane(model, nmbc::PlaneSides::all(kernel(model)),
                          {.nx = 3, .ny = 3, .time_step = 2});
        for_each_node(plane, [&](std::size_t x, std::size_t y, std::size_t entry) {
            plane.displacement(0)[entry] = 5 * double(x);
            plane.displacement(1)[entry] = double(y);
        });
        plane.start();  // v is minus the acceleration then
        const double stress = (5 + 0.3) / (1 - 0.09);
        for_each_node(plane, [&](std::size_t x, std::size_t, std::size_t entry) {
            size = std::max(size, x + 1);
            of.push_back({-std::as_const(plane).velocity(0)[entry] / stress,
                          -std::as_const(plane).velocity(1)[entry] / stress});
        });
    }
};

}  // namespace

TEST_CASE("convex kernels of a plane are not below 0 and reproduce what is linear, (20)") {
    for (const unsigned radius_squared : radii) {
        CAPTURE(radius_squared);
        const nmbc::detail::PlaneConvexKernels kernels(radius_squared);
        const auto wide = int(3 * nmbc::horizon_of(radius_squared) + 3);
        for (int y = 0; y < wide; ++y) {
            for (int x = 0; x < wide; ++x) {
                CAPTURE(x);
                CAPTURE(y);
                double one = 0;
                std::array<double, 2> moment{};
                for (const auto& [owner, value] : kernels.at({x, y})) {
                    CHECK(value > 0);
                    CHECK((x > 0 || owner.x == 0));  // a side knows its own nodes only
                    CHECK((y > 0 || owner.y == 0));
                    one += value;
                    moment[0] += value * (owner.x - x);
                    moment[1] += value * (owner.y - y);
                }
                CHECK(std::abs(one - 1) < 1e-14);  // of 30 terms
                CHECK(std::abs(moment[0]) < 1e-14);
                CHECK(std::abs(moment[1]) < 1e-14);
            }
        }
        const auto corner = kernels.at({0, 0});
        REQUIRE(corner.size() == 1);
        CHECK(corner[0].value == 1);
    }
}

TEST_CASE("between sides of convex kernels linear displacements have their own gradient") {
    for (const unsigned radius_squared : radii) {
        CAPTURE(radius_squared);
        const nmbc::CorrespondenceModel model = spline(radius_squared, 0.5);
        const nmbc::PlaneSide side = kernel(model);
        for (const nmbc::PlaneSides& sides :
             {nmbc::PlaneSides::all(side),
              nmbc::PlaneSides{side, absorbing(3, 0.2), nmbc::FreeSide{}, side}}) {
            check_linear_gradient(model, sides);
        }
    }
}

TEST_CASE("under an even stress a side of convex kernels bears its force, (25), and rests not") {
    for (const unsigned radius_squared : radii) {
        CAPTURE(radius_squared);
        const Forces forces(spline(radius_squared, 0));
        const std::size_t n = nmbc::horizon_of(radius_squared);
        const std::size_t corner = 2 * n + 2;  // of the corners' nodes and of those they act on
        for (std::size_t y = corner; y + corner < forces.size; ++y) {
            CHECK(std::abs(forces.of[y * forces.size][0] - 1) < 1e-13);
            CHECK(std::abs(forces.of[y * forces.size][1]) < 1e-13);
        }
        double sum = 0;
        double torque = 0;
        double within = 0;  // the largest force inside of the body
        for (std::size_t y = 0; y < forces.size; ++y) {
            for (std::size_t x = 0; x < forces.size; ++x) {
                const auto& [along, across] = forces.of[y * forces.size + x];
                sum += along;
                torque += double(x) * across - double(y) * along;
                if (x > 0 && x + 1 < forces.size && y >= corner && y + corner < forces.size) {
                    within = std::max(within, std::abs(along));
                }
            }
        }
        CHECK(std::abs(sum) < 1e-12);
        CHECK(std::abs(torque) < 1e-11);
        CHECK(within > 0.3);  // so this is no patch test
    }
}

TEST_CASE("forces in a square of convex kernels, n = 2") {
    const Forces forces(spline(8, 0));
    const std::size_t middle = forces.size / 2 * forces.size;
    // Of a half plane, lambda by bisection; what is strained along the side has no part in them.
    const std::array<double, 7> known{1,         -0.012876, 0.357164, -0.204026,
                                      -0.113966, -0.024270, -0.002027};
    for (std::size_t x = 0; x < known.size(); ++x) {
        CHECK(std::abs(forces.of[middle + x][0] - known[x]) < 1e-6);
    }
}

TEST_CASE("between sides of convex kernels the energy is kept, and is a sum of squares") {
    for (const unsigned radius_squared : {2U, 8U}) {
        for (const double G : {0.0, 0.5}) {
            CAPTURE(radius_squared);
            CAPTURE(G);
            const nmbc::CorrespondenceModel model = spline(radius_squared, G);
            const nmbc::PlaneSide side = kernel(model);
            const nmbc::PlaneSide passive = absorbing(4, 0.3);
            for (const nmbc::PlaneSides& sides :
                 {nmbc::PlaneSides::all(side),
                  nmbc::PlaneSides{side, nmbc::FixedSide{}, nmbc::MirrorSide{}, side},
                  nmbc::PlaneSides{nmbc::PeriodicSide{}, nmbc::PeriodicSide{}, side, side},
                  nmbc::PlaneSides{passive, side, nmbc::FreeSide{}, side}}) {
                // Of so many steps of roundings.
                CHECK(largest_drift(model, sides, parameters_of(model, sides), 300) < 1e-11);
            }
        }
    }
}

TEST_CASE("what sides of convex kernels do not continue is refused") {
    const nmbc::CorrespondenceModel model = spline(8, 0);
    CHECK_THROWS_AS(nmbc::convex_kernel_closure(nmbc::nopd2d(8, 0.3, 0)), std::invalid_argument);
    CHECK_THROWS_AS(nmbc::convex_kernel_closure(nmbc::with_influence(model, {5, 4, 3, 2, 1})),
                    std::invalid_argument);
    for (const unsigned without_all : {1U, 4U, 5U, 9U, 10U}) {
        CAPTURE(without_all);
        CHECK_THROWS_AS(nmbc::spline_influence(without_all), std::invalid_argument);
    }
    const nmbc::PlaneSides sides = nmbc::PlaneSides::all(kernel(model));
    const nmbc::PlaneParameters p{.nx = 9, .ny = 9, .time_step = 0.1};
    CHECK_NOTHROW(nmbc::Plane(model, sides, p));
    for (const nmbc::CorrespondenceModel& other :
         {nmbc::nopd2d(8, 0.3, 0), nmbc::with_influence(model, {5, 4, 3, 2, 1}), spline(13, 0)}) {
        CHECK_THROWS_AS(nmbc::Plane(other, sides, p), std::invalid_argument);
    }
    nmbc::CorrespondenceModel wrong = model;
    wrong.influence.pop_back();
    CHECK_THROWS_AS(nmbc::Plane(wrong, nmbc::PlaneSides{}, p), std::invalid_argument);
}
