// SPDX-License-Identifier: GPL-2.0-or-later
/// Planes of every radius between sides that sum by parts, corners included.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nmbc/plane.hpp>
#include <nmbc/plane_convex_kernel.hpp>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "generator/closures/plane_summation_by_parts.hpp"
#include "tests/runtime/closed_planes.hpp"

namespace {

constexpr double nu = 0.3;

nmbc::ClosedSide closed(const nmbc::CorrespondenceModel& model) {
    return {std::make_shared<const nmbc::PlaneClosure>(nmbcgen::plane_summation_by_parts(model))};
}
nmbc::ClosedSide closed(unsigned radius_squared) {
    return closed(nmbc::nopd2d(radius_squared, nu, 0));
}

/// Of radius 1, where the sums are those of a chain along each axis: half of the volume and the
/// mass on the surface, a quarter in corners, as a passive side has them.
nmbc::PassiveSide half() {
    const std::vector<double> weight{0.5};
    return {.strain = weight,
            .stabilisation = weight,
            .mass = {weight, weight},
            .dashpots = {std::vector<double>{0}, std::vector<double>{0}}};
}

/// The largest departure over the largest displacement, in 200 steps under the tractions of an even
/// gradient: xx, xy, yx, yy; surface: the length [dX] that each of its nodes stands for, from a
/// corner on. A free body flies off with the square of the steps, by a rounding of its forces.
double failure_of_patch(const nmbc::PlaneModel& model, const nmbc::PlaneSides& sides,
                        const nmbc::PlaneParameters& p, const std::vector<double>& surface,
                        const std::array<double, 4>& gradient) {
    nmbc::Plane plane(model, sides, p);
    const std::size_t nx = plane.grid().nx - 2 * plane.ghosts();
    const std::size_t ny = plane.grid().ny - 2 * plane.ghosts();
    std::array<std::vector<double>, 2> u{std::vector<double>(plane.displacement(0).size()),
                                         std::vector<double>(plane.displacement(0).size())};
    for_each_node(plane, [&](std::size_t x, std::size_t y, std::size_t entry) {
        for (const std::size_t a : {0U, 1U}) {
            u[a][entry] =
                p.spacing * (gradient[2 * a] * double(x) + gradient[2 * a + 1] * double(y));
            plane.displacement(a)[entry] = u[a][entry];
        }
    });
    const double modulus = p.youngs_modulus / (1 - nu * nu);  // plane stress
    const double sigma_x = modulus * (gradient[0] + nu * gradient[3]);
    const double sigma_y = modulus * (gradient[3] + nu * gradient[0]);
    const double sigma_xy = p.youngs_modulus / (2 * (1 + nu)) * (gradient[1] + gradient[2]);
    const auto length = [&](std::size_t node, std::size_t nodes) {  // of the surface
        return p.spacing * surface[std::min({node, nodes - 1 - node, surface.size() - 1})];
    };
    const auto pull = [&](double duration) {
        for_each_node(plane, [&](std::size_t x, std::size_t y, std::size_t entry) {
            const double out_x = (double(x + 1 == nx) - double(x == 0)) * length(y, ny);
            const double out_y = (double(y + 1 == ny) - double(y == 0)) * length(x, nx);
            const double push = duration / plane.mass(0, entry);
            plane.velocity(0)[entry] += push * (out_x * sigma_x + out_y * sigma_xy);
            plane.velocity(1)[entry] += push * (out_x * sigma_xy + out_y * sigma_y);
        });
    };
    plane.start();
    pull(-p.time_step / 2);
    double force = 0;
    for_each_node(plane, [&](std::size_t, std::size_t, std::size_t entry) {
        for (const std::size_t a : {0U, 1U}) {
            force = std::max(force, plane.mass(a, entry) / (p.time_step / 2) *
                                        std::abs(std::as_const(plane).velocity(a)[entry]));
        }
    });
    CHECK(force < 1e-12 * p.spacing * std::hypot(sigma_x, sigma_y, sigma_xy));
    plane.advance(
        200, [&](auto&, double) { pull(p.time_step); }, [](const auto&) {});
    double failure = 0;
    double largest = 0;
    for_each_node(plane, [&](std::size_t, std::size_t, std::size_t entry) {
        for (const std::size_t a : {0U, 1U}) {
            failure = std::max(failure,
                               std::abs(std::as_const(plane).displacement(a)[entry] - u[a][entry]));
            largest = std::max(largest, std::abs(u[a][entry]));
        }
    });
    return failure / largest;
}

}  // namespace

TEST_CASE("closed sides pass the patch test at every radius and influence, corners included" *
          doctest::test_suite("long")) {
    for (const double G : {0.0, 0.5}) {
        std::vector<nmbc::CorrespondenceModel> models;
        for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U}) {
            models.push_back(nmbc::nopd2d(radius_squared, nu, G));
        }
        for (const unsigned radius_squared : {2U, 8U}) {
            models.push_back(nmbc::with_influence(nmbc::nopd2d(radius_squared, nu, G),
                                                  nmbc::spline_influence(radius_squared)));
        }
        for (const nmbc::CorrespondenceModel& model : models) {
            CAPTURE(model.radius_squared);
            CAPTURE(model.influence.size());
            CAPTURE(G);
            const nmbc::ClosedSide side = closed(model);
            const auto sides = nmbc::PlaneSides::all(side);
            const auto p = parameters_of(model, sides);
            const auto failure = [&](const std::array<double, 4>& gradient) {
                return failure_of_patch(model, sides, p, side.closure->surface, gradient);
            };
            CHECK(failure({0.1, 0, 0, 0.02}) < 1e-11);
            CHECK(failure({0, 0.05, 0.05, 0}) < 1e-11);
            CHECK(failure({0.03, 0.1, -0.04, -0.02}) < 1e-11);
        }
    }
}

TEST_CASE("halves at the sides pass the patch test at radius 1, quarters in the corners") {
    for (const double G : {0.0, 0.5}) {
        CAPTURE(G);
        const nmbc::PlaneModel model = nmbc::nopd2d(1, nu, G);
        const auto sides = nmbc::PlaneSides::all(half());
        const auto failure = [&](const std::array<double, 4>& gradient) {
            return failure_of_patch(model, sides, parameters_of(model, sides, 12, 9), {0.5, 1},
                                    gradient);
        };
        CHECK(failure({0.1, 0, 0, 0.02}) < 1e-12);
        CHECK(failure({0, 0.05, 0.05, 0}) < 1e-12);
        CHECK(failure({0.03, 0.1, -0.04, -0.02}) < 1e-12);
    }
}

TEST_CASE("between closed sides the energy is kept, and is a sum of squares" *
          doctest::test_suite("long")) {
    for (const unsigned radius_squared : {1U, 2U, 4U, 9U, 10U}) {
        for (const double G : {0.0, 0.5}) {
            CAPTURE(radius_squared);
            CAPTURE(G);
            const nmbc::PlaneModel model = nmbc::nopd2d(radius_squared, nu, G);
            const nmbc::PlaneSide side = closed(radius_squared);
            for (const nmbc::PlaneSides& sides :
                 {nmbc::PlaneSides::all(side),
                  nmbc::PlaneSides{side, nmbc::FixedSide{}, nmbc::MirrorSide{}, side},
                  nmbc::PlaneSides{nmbc::PeriodicSide{}, nmbc::PeriodicSide{}, side, side}}) {
                // Of so many steps of roundings.
                CHECK(largest_drift(model, sides, parameters_of(model, sides), 200) < 1e-11);
            }
        }
    }
}

TEST_CASE(
    "where a closed side meets a free or passive one, linear displacements have their own "
    "gradient") {
    for (const unsigned radius_squared : {2U, 4U, 9U}) {
        CAPTURE(radius_squared);
        const nmbc::PlaneSide side = closed(radius_squared);
        check_linear_gradient(nmbc::nopd2d(radius_squared, nu, 0.5),
                              {side, absorbing(3, 0.2), nmbc::FreeSide{}, side});
    }
}

TEST_CASE("closed, free and passive sides in one box: what is left and what has gone out is all" *
          doctest::test_suite("long")) {
    for (const unsigned radius_squared : {2U, 4U, 9U, 10U}) {
        for (const double G : {0.0, 0.5}) {
            CAPTURE(radius_squared);
            CAPTURE(G);
            const nmbc::PlaneModel model = nmbc::nopd2d(radius_squared, nu, G);
            const nmbc::PlaneSide side = closed(radius_squared);
            const nmbc::PlaneSide passive = absorbing(4, 0.3);
            for (const nmbc::PlaneSides& sides :
                 {nmbc::PlaneSides{side, passive, side, side},
                  nmbc::PlaneSides{passive, passive, side, nmbc::FreeSide{}},
                  nmbc::PlaneSides{nmbc::FreeSide{}, side, nmbc::FreeSide{}, passive},
                  nmbc::PlaneSides{side, passive, nmbc::SpongeSide{{0.1, 0.02}}, passive}}) {
                CHECK(largest_drift(model, sides, parameters_of(model, sides), 200) < 1e-11);
            }
        }
    }
}

TEST_CASE("the energies of a range of nodes are those of closed layers, too") {
    const nmbc::PlaneModel model = nmbc::nopd2d(4, nu, 0.5);
    const nmbc::PlaneSide side = closed(4);
    const nmbc::PlaneSides sides{side, absorbing(3, 0.2), nmbc::FreeSide{}, side};
    nmbc::Plane plane(model, sides, parameters_of(model, sides));
    plane.displacement(0)[plane.entry(1, 6)] = 1;
    plane.start();
    plane.advance(20);
    const auto before = std::ptrdiff_t(plane.layers()[0]);
    const auto right = 9 + std::ptrdiff_t(plane.layers()[1]);
    const auto top = 7 + std::ptrdiff_t(plane.layers()[3]);
    CHECK(plane.energies(-before, right, 0, top).staggered ==
          doctest::Approx(plane.energies().staggered).epsilon(1e-13));
    CHECK(plane.energies(-before, 9, 0, top).staggered +
              plane.energies(9, right, 0, top).staggered ==
          doctest::Approx(plane.energies().staggered).epsilon(1e-13));
    CHECK(plane.interior_energies().staggered < 0.9 * plane.energies().staggered);
    const std::vector<double> of_nodes = plane.energies_of_nodes(-before, 9, 0, top);
    CHECK(of_nodes.size() == std::size_t((9 + before) * top));
    CHECK(std::accumulate(of_nodes.begin(), of_nodes.end(), 0.0) ==
          doctest::Approx(plane.energies(-before, 9, 0, top).total()).epsilon(1e-13));
    CHECK_THROWS_AS(plane.energies(-before - 1, 9, 0, 7), std::invalid_argument);
    CHECK_THROWS_AS(plane.energies(0, 9, 0, top + 1), std::invalid_argument);
    CHECK_THROWS_AS(plane.energies(0, 9, -1, 7), std::invalid_argument);
}

TEST_CASE("an even strain has the same energy per volume everywhere, at closed sides and corners") {
    const nmbc::PlaneModel model = nmbc::nopd2d(4, nu, 0.5);
    const nmbc::PlaneSides sides = nmbc::PlaneSides::all(closed(4));
    nmbc::Plane plane(model, sides, parameters_of(model, sides));
    const auto layers = std::ptrdiff_t(plane.layers()[0]);
    for (std::ptrdiff_t y = -layers; y < 7 + layers; ++y) {
        for (std::ptrdiff_t x = -layers; x < 9 + layers; ++x) {
            plane.displacement(0)[plane.entry(std::size_t(x), std::size_t(y))] = 1e-3 * double(x);
        }
    }
    plane.start_staggered();
    const std::vector<double> energies =
        plane.energies_of_nodes(-layers, 9 + layers, -layers, 7 + layers);
    const double inside = plane.energies(4, 5, 3, 4).total();
    std::size_t node = 0;
    double largest = 0;  // difference
    for (std::ptrdiff_t y = -layers; y < 7 + layers; ++y) {
        for (std::ptrdiff_t x = -layers; x < 9 + layers; ++x) {
            largest =
                std::max(largest, std::abs(energies[node++] / plane.volume(x, y) / inside - 1));
        }
    }
    CHECK(plane.volume(-layers, 3) < 0.9);
    CHECK(largest < 1e-11);  // strains of 1e-3 are differences of u up to 1e-2: 1e3 roundings
}

TEST_CASE("between halves at the sides the energy is kept") {
    const nmbc::PlaneModel model = nmbc::nopd2d(1, nu, 0.5);
    const auto sides = nmbc::PlaneSides::all(half());
    CHECK(largest_drift(model, sides, parameters_of(model, sides, 12, 9), 1000) < 1e-12);
}

TEST_CASE("P and S waves meet a closed side as the middle of an even whole, to second order") {
    const nmbc::PlaneModel model = nmbc::nopd2d(4, nu, 0.5);
    const auto departure = [&](std::size_t component, double width) {
        const nmbc::PlaneSides strip{closed(4), nmbc::FixedSide{}, nmbc::PeriodicSide{},
                                     nmbc::PeriodicSide{}};
        nmbc::PlaneParameters p{.nx = std::size_t(16 * width), .ny = 2, .time_step = 0.5};
        nmbc::Plane half(model, strip, p);
        const std::size_t ghosts = half.ghosts();
        const std::size_t lines = half.grid().nx - 2 * ghosts;
        p.nx = 2 * lines - 1;
        nmbc::PlaneSides both = strip;
        both.left = nmbc::FixedSide{};
        nmbc::Plane whole(model, both, p);
        const auto pulse = [&](double x) {  // from the surface
            return std::exp(-std::pow((std::abs(x) - 6 * width) / width, 2));
        };
        const auto fill = [&](nmbc::Plane& plane, std::size_t surface) {
            for_each_node(plane, [&](std::size_t x, std::size_t, std::size_t entry) {
                plane.displacement(component)[entry] = pulse(double(x) - double(surface));
            });
            plane.start();
            plane.advance(std::size_t(
                9 * width / (component == 0 ? model.speed_P() : model.speed_S()) / p.time_step));
        };
        fill(half, 0);
        fill(whole, lines - 1);
        double error = 0;
        for (std::size_t x = 0; x < lines; ++x) {
            const std::size_t row = ghosts * half.grid().nx + ghosts + x;
            const std::size_t middle = ghosts * whole.grid().nx + ghosts + lines - 1 + x;
            error = std::max(error, std::abs(std::as_const(half).displacement(component)[row] -
                                             std::as_const(whole).displacement(component)[middle]));
        }
        return error;
    };
    for (const std::size_t component : {0U, 1U}) {
        CAPTURE(component);
        const double coarse = departure(component, 8);
        CHECK(coarse < 0.01);
        CHECK(coarse / departure(component, 16) > 3.5);
    }
}

TEST_CASE("what is refused beside closed sides") {
    const nmbc::PlaneModel model = nmbc::nopd2d(4, nu, 0);
    const nmbc::PlaneSide side = closed(4);
    const nmbc::PlaneParameters p{.nx = 20, .ny = 20, .time_step = 0.1};
    const auto refuses = [&](const nmbc::PlaneModel& plane, const nmbc::PlaneSides& sides) {
        CHECK_THROWS_AS(nmbc::Plane(plane, sides, p), std::invalid_argument);
    };
    CHECK_NOTHROW(nmbc::Plane(model, nmbc::PlaneSides::all(side), p));
    refuses(nmbc::nopd2d(9, nu, 0), nmbc::PlaneSides::all(side));
    refuses(nmbc::with_influence(nmbc::nopd2d(4, nu, 0), {3, 2, 1}), nmbc::PlaneSides::all(side));
    refuses(nmbc::bond2d(4, {1, 1, 1}), nmbc::PlaneSides::all(side));
    refuses(model, {side, closed(4), side, side});
    refuses(model, nmbc::PlaneSides::all(nmbc::ClosedSide{}));
    nmbc::PlaneClosure hollow = nmbcgen::plane_summation_by_parts(nmbc::nopd2d(4, nu, 0));
    hollow.nodes[0].volume = 0;
    refuses(model, nmbc::PlaneSides::all(
                       nmbc::ClosedSide{std::make_shared<const nmbc::PlaneClosure>(hollow)}));
}
