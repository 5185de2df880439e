// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/plane.hpp>
#include <nmbc/plane_pml.hpp>
#include <nmbc/plane_stability.hpp>
#include <variant>
#include <vector>

#include "tests/runtime/plane_bodies.hpp"

namespace {

using nmbc::LossLayer;
using nmbc::PlanePml;

nmbc::PlaneSide room_for(const LossLayer& layer) {
    return nmbc::SpongeSide{std::vector<double>(layer.nodes, 0)};
}

void kick_layers(PlanePml& pml, nmbc::Plane& plane) {
    pml.kick({plane.displacement(0), plane.displacement(1)},
             {plane.velocity(0), plane.velocity(1)});
}

/// With such a layer at all four sides.
struct PmlBox {
    PmlBox(const nmbc::PlaneModel& model, const LossLayer& layer, double of_stable,
           std::size_t nx = 9, std::size_t ny = 7)
        : plane(model, nmbc::PlaneSides::all(room_for(layer)),
                {.nx = nx,
                 .ny = ny,
                 .time_step = of_stable * 2 / std::sqrt(nmbc::highest_eigenvalue(model))}),
          pml(std::get<nmbc::CorrespondenceModel>(model.law()), {layer, layer, layer, layer},
              plane.grid(), plane.parameters()) {}

    void advance(std::size_t steps) {
        plane.advance(
            steps, [this](nmbc::Plane& body, double /*time*/) { kick_layers(pml, body); },
            [](const nmbc::Plane& /*body*/) {});
    }

    nmbc::Plane plane;
    PlanePml pml;
};

void start_plane_at_random(nmbc::Plane& plane) {
    fill_at_random(plane, 2018);
    plane.start();
}

/// Along a line of nodes, nearest neighbours at G = 0, with loss(i) = sigma dt/2: v' + sigma v = c
/// (p_(i+1) - p_(i-1))/2 and p' + sigma p = c (v_(i+1) - v_(i-1))/2, v at half steps and p at whole
/// ones. Two nodes at each end stay.
struct FirstOrderChain {
    double c = 0;
    double dt = 0;
    std::vector<double> losses{};
    std::vector<double> v{};
    std::vector<double> p{};

    double slope(const std::vector<double>& f, std::size_t i) const {
        return c * (f[i + 1] - f[i - 1]) / 2;
    }
    void start(const std::vector<double>& u) {
        v.assign(u.size(), 0);
        p.assign(u.size(), 0);
        for (std::size_t i = 1; i + 1 < u.size(); ++i) {
            p[i] = slope(u, i);
        }
        for (std::size_t i = 2; i + 2 < u.size(); ++i) {
            v[i] = -dt / 2 * slope(p, i);
        }
    }
    void step() {
        for (std::size_t i = 2; i + 2 < v.size(); ++i) {
            v[i] = ((1 - losses[i]) * v[i] + dt * slope(p, i)) / (1 + losses[i]);
        }
        for (std::size_t i = 1; i + 1 < v.size(); ++i) {
            p[i] = ((1 - losses[i]) * p[i] + dt * slope(v, i)) / (1 + losses[i]);
        }
    }
};

}  // namespace

TEST_CASE("head-on it is the layer of first order of the chain") {
    const nmbc::PlaneModel model = nmbc::nopd2d(1, 0.25, 0);
    constexpr std::size_t nodes = 30;
    constexpr double dt = 1.3;
    const LossLayer layer{.nodes = 12, .profile = 2, .target = 1e-4};
    const nmbc::PlaneSides sides{.left = nmbc::FixedSide{},
                                 .right = room_for(layer),
                                 .bottom = nmbc::PeriodicSide{},
                                 .top = nmbc::PeriodicSide{}};
    for (const std::size_t component : {0U, 1U}) {
        nmbc::Plane plane(model, sides, {.nx = nodes, .ny = 3, .time_step = dt});
        PlanePml pml(std::get<nmbc::CorrespondenceModel>(model.law()), {LossLayer{}, layer, {}, {}},
                     plane.grid(), plane.parameters());
        FirstOrderChain chain{.c = component == 0 ? model.speed_P() : model.speed_S(), .dt = dt};
        constexpr std::size_t all = 2 + nodes + 12 + 2;  // ghosts at both ends
        std::vector<double> u(all, 0);
        for (std::size_t i = 0; i < all; ++i) {
            const double depth = (double(i) - 31.5) / 12;
            const double largest = 0.5 * 3 * model.speed_P() * std::log(1e4) / 12 * dt / 2;
            chain.losses.push_back(i < 32 ? 0 : largest * std::min(1.0, depth * depth));
        }
        for (std::size_t x = 0; x < nodes; ++x) {
            u[2 + x] = std::exp(-std::pow(double(x) - 15, 2) / 4);
            for (std::size_t y = 0; y < 3; ++y) {
                plane.displacement(component)[plane.entry(x, y)] = u[2 + x];
            }
        }
        chain.start(u);
        plane.start();
        double largest = 0;
        double error = 0;
        for (std::size_t step = 0; step < 60; ++step) {
            plane.advance(
                1, [&](nmbc::Plane& body, double /*time*/) { kick_layers(pml, body); },
                [](const nmbc::Plane& /*body*/) {});
            chain.step();
            for (std::size_t x = 0; x < nodes; ++x) {
                const double there = plane.velocity(component)[plane.entry(x, 1)];
                largest = std::max(largest, std::abs(chain.v[2 + x]));
                error = std::max(error, std::abs(there - chain.v[2 + x]));
            }
        }
        CHECK(largest > 0.1);
        CHECK(error < 1e-12 * largest);  // roundings of 60 steps
    }
}

TEST_CASE("from random data nothing grows at G = 1/4 and 1, nearly at the interior's limit" *
          doctest::test_suite("long")) {
    for (const unsigned radius_squared : {1U, 2U, 4U, 5U, 8U, 9U}) {
        for (const double G : {0.25, 1.0}) {
            for (const double target : {1e-2, 1e-8}) {
                CAPTURE(radius_squared);
                CAPTURE(G);
                CAPTURE(target);
                PmlBox box(nmbc::nopd2d(radius_squared, 0.25, G),
                           {.nodes = 6, .profile = 2, .target = target}, 0.99);
                start_plane_at_random(box.plane);
                double before = box.plane.energies().staggered;
                for (std::size_t look = 0; look < 4; ++look) {
                    box.advance(250);
                    const double now = box.plane.energies().staggered;
                    CHECK(now < before);
                    before = now;
                }
            }
        }
    }
}

TEST_CASE("nor where bonds count by their length, whose waves it absorbs as well") {
    const auto left = [](const nmbc::CorrespondenceModel& model) {
        PmlBox box(model, {.nodes = 10, .profile = 2, .target = 1e-3}, 0.9, 20, 20);
        for (std::size_t y = 0; y < 20; ++y) {
            for (std::size_t x = 0; x < 20; ++x) {
                box.plane.displacement(0)[box.plane.entry(x, y)] =
                    std::exp(-(std::pow(double(x) - 9, 2) + std::pow(double(y) - 10, 2)) / 16);
            }
        }
        box.plane.start();
        const double first = box.plane.energies().staggered;
        box.advance(300);
        return box.plane.energies().staggered / first;
    };
    const nmbc::CorrespondenceModel model = nmbc::nopd2d(4, 0.25, 0.5);
    CHECK(left(model) < 1e-3);
    CHECK(left(nmbc::with_influence(model, {4, 2, 1})) < 1e-3);
}

TEST_CASE("at G = 0 fields grow in it") {
    PmlBox box(nmbc::nopd2d(4, 0.25, 0), {.nodes = 6, .profile = 2, .target = 1e-4}, 0.9);
    start_plane_at_random(box.plane);
    const double first = box.plane.energies().staggered;
    box.advance(4000);
    CHECK(box.plane.energies().staggered > 1e6 * first);
}

TEST_CASE("goes on from what it remembers, bit for bit") {
    const nmbc::PlaneModel model = nmbc::nopd2d(2, 0.25, 0.5);
    const LossLayer layer{.nodes = 5, .profile = 2, .target = 1e-3};
    PmlBox whole(model, layer, 0.9);
    start_plane_at_random(whole.plane);
    whole.advance(20);
    PmlBox rest(model, layer, 0.9);
    rest.plane.resume(whole.plane.state());
    rest.pml.remember(whole.pml.memory());
    whole.advance(20);
    rest.advance(20);
    for (const std::size_t a : {0U, 1U}) {
        CHECK(std::ranges::equal(whole.plane.velocity(a), rest.plane.velocity(a)));
    }
}

TEST_CASE("mirrored data give mirrored fields, and turned ones turned fields") {
    const nmbc::PlaneModel model = nmbc::nopd2d(5, 0.25, 0.5);
    const LossLayer layer{.nodes = 7, .profile = 2, .target = 1e-3};
    PmlBox one(model, layer, 0.9, 11, 9);
    PmlBox turned(model, layer, 0.9, 9, 11);
    // By 90 degrees: (x, y) to (8 - y, x), (u_x, u_y) to (-u_y, u_x).
    one.plane.displacement(0)[one.plane.entry(3, 5)] = 1;
    turned.plane.displacement(1)[turned.plane.entry(3, 3)] = 1;
    one.plane.start();
    turned.plane.start();
    one.advance(60);
    turned.advance(60);
    double largest = 0;
    double error = 0;
    for (std::size_t y = 0; y < 9; ++y) {
        for (std::size_t x = 0; x < 11; ++x) {
            const double here = one.plane.displacement(0)[one.plane.entry(x, y)];
            largest = std::max(largest, std::abs(here));
            error = std::max(
                error, std::abs(here - turned.plane.displacement(1)[turned.plane.entry(8 - y, x)]));
        }
    }
    CHECK(largest > 1e-3);
    CHECK(error < 1e-13);  // roundings of 60 steps, of fields of at most 1
}

TEST_CASE("on arrays of one's own it is the same, whatever made the forces") {
    const nmbc::PlaneModel model = nmbc::nopd2d(4, 0.25, 0.5);
    const LossLayer layer{.nodes = 5, .profile = 2, .target = 1e-3};
    PmlBox box(model, layer, 0.9);
    start_plane_at_random(box.plane);
    // Forces of a plane without losses, on copies of its fields.
    nmbc::Plane without(model, nmbc::PlaneSides::all(room_for(layer)), box.plane.parameters());
    PlanePml pml(std::get<nmbc::CorrespondenceModel>(model.law()), {layer, layer, layer, layer},
                 box.plane.grid(), box.plane.parameters());
    std::array<std::vector<double>, 2> u;
    std::array<std::vector<double>, 2> v;
    for (const std::size_t a : {0U, 1U}) {
        u[a].assign(box.plane.displacement(a).begin(), box.plane.displacement(a).end());
        v[a].assign(box.plane.velocity(a).begin(), box.plane.velocity(a).end());
    }
    for (std::size_t step = 0; step < 30; ++step) {
        for (const std::size_t a : {0U, 1U}) {
            std::ranges::copy(u[a], without.displacement(a).begin());
            std::ranges::copy(v[a], without.velocity(a).begin());
        }
        without.advance(1);
        for (const std::size_t a : {0U, 1U}) {
            v[a].assign(without.velocity(a).begin(), without.velocity(a).end());
        }
        pml.kick({u[0], u[1]}, {v[0], v[1]});
        for (const std::size_t a : {0U, 1U}) {
            for (std::size_t i = 0; i < u[a].size(); ++i) {
                u[a][i] += box.plane.parameters().time_step * v[a][i];
            }
        }
        box.advance(1);
    }
    for (const std::size_t a : {0U, 1U}) {
        CHECK(std::ranges::equal(u[a], box.plane.displacement(a)));
        CHECK(std::ranges::equal(v[a], box.plane.velocity(a)));
    }
}

TEST_CASE("in single precision it absorbs as in double") {
    const nmbc::CorrespondenceModel model = nmbc::nopd2d(1, 0.25, 1);
    const LossLayer layer{.nodes = 10, .profile = 2, .target = 1e-3};
    const nmbc::PlaneParameters p{.nx = 20, .ny = 20, .time_step = 0.5};
    const auto run = [&]<class Real>(Real /*of this type*/) {
        nmbc::BasicPlane<Real> plane(model, nmbc::PlaneSides::all(room_for(layer)), p);
        nmbc::BasicPlanePml<Real> pml(model, {layer, layer, layer, layer}, plane.grid(), p);
        for (std::size_t y = 0; y < p.ny; ++y) {
            for (std::size_t x = 0; x < p.nx; ++x) {
                plane.displacement(0)[plane.entry(x, y)] = static_cast<Real>(
                    std::exp(-(std::pow(double(x) - 9, 2) + std::pow(double(y) - 10, 2)) / 16));
            }
        }
        plane.start();
        const double first = plane.energies().staggered;
        plane.advance(200, [&](nmbc::BasicPlane<Real>& body, double /*time*/) {
            pml.kick({body.displacement(0), body.displacement(1)},
                     {body.velocity(0), body.velocity(1)});
        });
        return plane.interior_energies().total() / first;
    };
    const double in_double = run(0.0);
    CHECK(in_double < 1e-3);
    CHECK(run(0.0F) == doctest::Approx(in_double).scale(0).epsilon(1e-3));
}

TEST_CASE("layers that leave no interior, and the memory of others, are refused") {
    const nmbc::CorrespondenceModel model = nmbc::nopd2d(1, 0.25, 1);
    const nmbc::PlaneParameters p{.time_step = 0.5};
    const auto made = [&](const LossLayer& layer, const nmbc::Grid& grid) {
        return PlanePml(model, {layer, layer, LossLayer{}, LossLayer{}}, grid, p);
    };
    CHECK_THROWS_AS(made({.nodes = 5, .target = 0.1}, {.nx = 14, .ny = 9}), std::invalid_argument);
    CHECK_THROWS_AS(made({.nodes = 5, .target = 0.1}, {.nx = 15, .ny = 4}), std::invalid_argument);
    CHECK_THROWS_AS(made({.nodes = 5, .target = 0}, {.nx = 15, .ny = 5}), std::invalid_argument);
    PlanePml smallest = made({.nodes = 5, .target = 0.1}, {.nx = 15, .ny = 5});
    CHECK_THROWS_AS(smallest.remember(std::vector<double>(3)), std::invalid_argument);
}
