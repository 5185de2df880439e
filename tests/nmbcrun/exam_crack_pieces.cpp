// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "tools/nmbcrun/plane/crack_pieces.hpp"

using namespace nmbcrun;

namespace {

constexpr double horizon = 3;  // dX = 1

/// Ways of straight lines, two nodes wide, from the origin.
class Ways {
  public:
    void add(double x, double y, double degrees, double length) {
        const double angle = degrees * std::numbers::pi / 180;
        for (double along = 0; along <= length; along += 0.25) {
            for (const double across : {-0.5, 0.5}) {
                const double X = x + along * std::cos(angle) - across * std::sin(angle);
                const double Y = y + along * std::sin(angle) + across * std::cos(angle);
                const std::array<long, 2> place{std::lround(X), std::lround(Y)};
                nodes_[place] = {place,
                                 {double(place[0]), double(place[1])},
                                 std::hypot(double(place[0]), double(place[1]))};
            }
        }
    }
    std::vector<CrackBranch> branches() const {
        std::vector<CrackedNode> all;
        all.reserve(nodes_.size());
        for (const auto& [place, node] : nodes_) {
            all.push_back(node);
        }
        return CrackPieces(all, horizon).branches();
    }

  private:
    std::map<std::array<long, 2>, CrackedNode> nodes_{};
};

}  // namespace

TEST_CASE("a crack that forks: where, and into which directions") {
    for (const int half_angle : {20, 30, 40}) {
        Ways crack;
        crack.add(0, 0, 0, 40);
        crack.add(40, 0, half_angle, 40);
        crack.add(40, 0, -half_angle, 40);
        const std::vector<CrackBranch> branches = crack.branches();
        REQUIRE(branches.size() == 1);
        // Ways are apart where they are more than two nodes apart, bands are 3 wide.
        CHECK(branches[0].X[0] > 40);
        CHECK(branches[0].X[0] < 40 + 3 / std::sin(half_angle * std::numbers::pi / 180) + 3);
        CHECK(std::abs(branches[0].X[1]) < 0.51);
        REQUIRE(branches[0].directions.size() == 2);
        // Of 15 nodes: half a node is 2 degrees.
        CHECK(std::abs(branches[0].directions[0] + half_angle) <= 4);
        CHECK(std::abs(branches[0].directions[1] - half_angle) <= 4);
    }
}

TEST_CASE("a straight crack has no branch, nor one with a short spur") {
    Ways crack;
    crack.add(0, 0, 30, 60);
    CHECK(crack.branches().empty());
    crack.add(26, 15, 90, 10);
    CHECK(crack.branches().empty());
}

TEST_CASE("directions are from the x axis, 180 degrees at most") {
    CHECK(degrees_from_x({0, 0}, {1, 1}) == 45);
    CHECK(degrees_from_x({2, 0}, {1, 0}) == 180);
    CHECK(degrees_from_x({0, 0.1}, {-100, 0}) == 180);
    CHECK(degrees_from_x({0, 0}, {0, -3}) == -90);
}
