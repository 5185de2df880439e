// SPDX-License-Identifier: MIT
// What is no plane lattice, or has no such sides.
#include <doctest/doctest.h>

#include <cmath>
#include <nmbc/plane.hpp>
#include <nmbc/plane_convex_kernel.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/runtime/plane_bodies.hpp"

using namespace nmbc;

TEST_CASE("steps that the interior does not stand are refused before they are taken") {
    const PlaneModel model = nopd2d(1, 0.25, 1);
    const double longest = 2 / std::sqrt(highest_eigenvalue(model));
    const auto plane = [&](double step) {
        PlaneParameters p{.nx = 8, .ny = 8, .spacing = 0.5, .youngs_modulus = 4, .density = 1};
        p.time_step = step / p.rate();
        return Plane(model, PlaneSides::all(FixedSide{}), p);
    };
    auto stable = plane(longest);
    stable.start();
    CHECK_NOTHROW(stable.advance(1));
    auto too_long = plane(longest * (1 + 1e-6));
    too_long.start();  // accelerations are there in any step
    CHECK_THROWS_WITH_AS(too_long.advance(1), doctest::Contains("stable in steps up to"),
                         NotCertified);
    CHECK_THROWS_AS(too_long.advance(
                        1, [](auto&&...) {}, [](const auto&) {}),
                    NotCertified);
}

TEST_CASE("what cannot be is refused") {
    const auto refusal = [](auto make) {
        try {
            make();
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    CHECK(refusal([] { nopd2d(3, 0.25, 0); }).find("sum of two squares") != std::string::npos);
    for (const unsigned large : {1'000'001U, 3'999'930'025U, 4'000'000'000U}) {  // of 63245^2, too
        const std::string most = "at most 1000000, not " + std::to_string(large);
        CHECK(refusal([&] { nopd2d(large, 0.25, 0); }).find(most) != std::string::npos);
        CHECK(refusal([&] { bond2d(large, {1}); }).find(most) != std::string::npos);
        CHECK(refusal([&] { spline_influence(large); }).find(most) != std::string::npos);
        CHECK(refusal([&] { squared_lengths(large); }).find(most) != std::string::npos);
        CHECK(refusal([&] { plane_bond_classes(large); }).find(most) != std::string::npos);
    }
    CHECK(refusal([] { bond_weights(63245U * 63245U, {1}); }).find("at most") != std::string::npos);
    CHECK(refusal([] { nopd2d(1, 1, 0); }).find("Poisson") != std::string::npos);
    CHECK(refusal([] { nopd2d(1, 0.5, 0, StressState::plane_strain); }).find("1/2") !=
          std::string::npos);
    CHECK(refusal([] { nopd2d(1, 0.25, -1); }).find('G') != std::string::npos);
    for (const std::vector<double>& bad :
         {std::vector<double>{1, 2}, {1, 2, 3, 4}, {1, 0, 1}, {1, -1, 1}, {1, HUGE_VAL, 1}}) {
        CHECK(refusal([&] {
                  with_influence(nopd2d(4, 0.25, 0), bad);
              }).find("a positive number for each length of bonds, 3 of this family") !=
              std::string::npos);
    }
    const PlaneModel model = nopd2d(4, 0.25, 1);
    const auto body = [&](const PlaneSides& sides, std::size_t nx = 10, std::size_t ny = 10) {
        return refusal([&] { const Plane plane(model, sides, body_parameters(nx, ny, model)); });
    };
    const PassiveSide passive = some_passive_side(0.2);
    CHECK(body({PeriodicSide{}, FixedSide{}, FixedSide{}, FixedSide{}}).find("opposite") !=
          std::string::npos);
    CHECK(body({passive, some_passive_side(0.3), passive, passive}).find("same null Lagrangian") !=
          std::string::npos);
    CHECK(body({passive, FreeSide{}, passive, passive}).find("free side") != std::string::npos);
    CHECK(body(PlaneSides::all(FreeSide{}), 1, 10).find("one direction") != std::string::npos);
    CHECK(body({PeriodicSide{}, PeriodicSide{}, FixedSide{}, FixedSide{}}, 1) == "accepted");
    CHECK(refusal([] {
              const PlaneModel bonds = bond2d(4, {1, 1, 1});
              const Plane plane(bonds, {PeriodicSide{}, PeriodicSide{}, FreeSide{}, FreeSide{}},
                                body_parameters(1, 10, bonds));
          }).find("2 nodes") != std::string::npos);
    PassiveSide wrong = passive;
    wrong.mass[0][1] = 0;
    CHECK(body(PlaneSides::all(wrong)).find("positive") != std::string::npos);
    wrong = passive;
    wrong.dashpots[1].pop_back();
    CHECK(body(PlaneSides::all(wrong)).find("q * q") != std::string::npos);
    wrong = passive;
    for (double& one : wrong.dashpots[0]) {
        one = -one;
    }
    CHECK(body(PlaneSides::all(wrong)).find("dashpots") != std::string::npos);
    wrong.dashpots[0] = {1, 2, 2, 1};  // eigenvalues 3 and -1
    CHECK(body(PlaneSides::all(wrong)).find("dashpots") != std::string::npos);
    wrong.dashpots[0] = {1, 0.1, 0.3, 1};
    CHECK(body(PlaneSides::all(wrong)).find("dashpots") != std::string::npos);
    wrong = passive;
    wrong.made_for = nopd2d(4, 0.25, 1.5);
    CHECK(body(PlaneSides::all(wrong)).find("another lattice") != std::string::npos);
    wrong.made_for = with_influence(nopd2d(4, 0.25, 1), {3, 2, 1});
    CHECK(body(PlaneSides::all(wrong)).find("another lattice") != std::string::npos);
    wrong.made_for = nopd2d(4, 0.25, 1);
    CHECK(body(PlaneSides::all(wrong)) == "accepted");
    wrong = passive;
    wrong.null_lagrangian = 50;
    CHECK(body(PlaneSides::all(wrong)).find("twice the shear") != std::string::npos);
    wrong.null_lagrangian = std::nan("");
    CHECK(body(PlaneSides::all(wrong)).find("twice the shear") != std::string::npos);
    CHECK(body(PlaneSides::all(HigdonSide{})).find("needs speeds") != std::string::npos);
    CHECK(body(PlaneSides::all(HigdonSide{{1, -1}, 0})).find("needs speeds") != std::string::npos);
    CHECK(body(PlaneSides::all(SpongeSide{{0.1, -1}})).find("friction") != std::string::npos);
    CHECK(refusal([] {
              const Plane plane(CorrespondenceModel{}, {}, {.nx = 5, .ny = 5, .time_step = 1});
          }).find("positive moduli") != std::string::npos);
    CHECK(body(PlaneSides::all(FixedSide{}), 0, 4).find("interior") != std::string::npos);
    Plane plane(model, {}, body_parameters(5, 5, model));
    CHECK_THROWS_AS(plane.energies(0, 6, 0, 5), std::invalid_argument);
    CHECK_THROWS_AS(plane.energies(2, 2, 0, 5), std::invalid_argument);
}
