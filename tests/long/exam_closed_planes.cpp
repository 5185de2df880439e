// SPDX-License-Identifier: MIT
/// A million steps of planes between closed sides, free at G = 0 and held at one of them at 1/2:
/// nothing grows.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <nmbc/plane.hpp>
#include <nmbc/plane_convex_kernel.hpp>
#include <string>
#include <utility>
#include <vector>

#include "generator/closures/plane_summation_by_parts.hpp"
#include "tests/runtime/closed_planes.hpp"

namespace {

struct Body {
    std::string name{};
    nmbc::CorrespondenceModel model{};
    nmbc::PlaneClosure closure{};
};

std::vector<Body> bodies() {
    std::vector<Body> all;
    for (const double G : {0.0, 0.5}) {
        const nmbc::CorrespondenceModel even = nmbc::nopd2d(4, 0.3, G);
        const nmbc::CorrespondenceModel spline =
            nmbc::with_influence(nmbc::nopd2d(8, 0.3, G), nmbc::spline_influence(8));
        all.push_back({"sbp, radius2 = 4", even, nmbcgen::plane_summation_by_parts(even)});
        all.push_back({"sbp, spline", spline, nmbcgen::plane_summation_by_parts(spline)});
        all.push_back({"kernel, spline", spline, nmbc::convex_kernel_closure(spline)});
    }
    return all;
}

/// Of a million steps from a rough start at rest: the rate [1/step] at which the root mean square
/// of u grows from the first tenth to the last, and what the energy has changed by, over itself.
struct Growth {
    double rate = 0;
    double energy = 0;
};

Growth growth(const Body& body, bool is_held) {
    const auto sides = nmbc::PlaneSides::all(
        nmbc::ClosedSide{std::make_shared<const nmbc::PlaneClosure>(body.closure)});
    nmbc::PlaneParameters p{.nx = 3, .ny = 3};
    p.time_step =
        2 * (1 - 1e-9) / std::sqrt(nmbc::highest_eigenvalue(body.model, sides, p.nx, p.ny));
    nmbc::Plane plane(body.model, sides, p);
    std::vector<std::size_t> bottom;
    for_each_node(plane, [&](std::size_t x, std::size_t y, std::size_t entry) {
        const double place = double(x) + 100 * double(y);
        plane.displacement(0)[entry] = std::sin(place * place);
        plane.displacement(1)[entry] = std::sin(2 * place * place);
        if (y == 0) {
            bottom.push_back(entry);
        }
    });
    const auto hold = [&](nmbc::Plane& moved, double) {
        for (std::size_t i = 0; i < bottom.size() && is_held; ++i) {
            moved.velocity(0)[bottom[i]] = 0;
            moved.velocity(1)[bottom[i]] = 0;
        }
    };
    plane.start();
    plane.advance(1, hold);
    const double first = std::as_const(plane).energies().staggered;
    std::array<double, 10> tenths{};
    for (double& tenth : tenths) {
        for (int look = 0; look < 1000; ++look) {
            plane.advance(100, hold);
            for (const std::size_t a : {0U, 1U}) {
                for (const double u : std::as_const(plane).displacement(a)) {
                    tenth += u * u;
                }
            }
        }
    }
    return {std::log(tenths.back() / tenths.front()) / 2 / 9e5,
            std::as_const(plane).energies().staggered / first - 1};
}

}  // namespace

// With -s the rates are printed: docs/evidence/closures.md has the largest.
TEST_CASE("a million steps of planes between closed sides") {
    for (const Body& body : bodies()) {
        CAPTURE(body.name);
        CAPTURE(body.model.stabilisation);
        const bool is_held = body.model.stabilisation > 0;
        const Growth found = growth(body, is_held);
        // As many waves meet again and again the mean of a tenth differs by some 1e-3.
        CHECK(found.rate < 1e-8);
        CHECK(std::abs(found.energy) < 1e-12);  // roundings of a million steps
    }
}
