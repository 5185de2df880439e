// SPDX-License-Identifier: MIT
// A plane in blocks that exchange their edges is the plane in one.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <nmbc/plane.hpp>
#include <nmbc/plane_stability.hpp>
#include <vector>

#include "tests/runtime/plane_bodies.hpp"

using namespace nmbc;

namespace {

using Field = std::array<std::vector<double>, 2>;

/// A part of the whole, on a grid of its own.
struct Block {
    Plane plane;
    std::array<std::size_t, 2> first{};   ///< its node 0 in the interior of the whole
    std::array<std::size_t, 2> offset{};  ///< of its grid in that of the whole
    std::array<std::array<std::size_t, 2>, 2>
        own{};  ///< what is no halo: first and last of its grid

    bool owns(std::size_t x, std::size_t y) const {
        return x >= own[0][0] && x < own[0][1] && y >= own[1][0] && y < own[1][1];
    }
};

class Blocks {
  public:
    /// Cut before these interior nodes along x and y.
    Blocks(const Plane& whole, const std::array<std::vector<std::size_t>, 2>& cuts)
        : pitch_(whole.grid().nx), rows_(whole.grid().ny) {
        const auto ends = [&](std::size_t axis) {
            const PlaneParameters& p = whole.parameters();
            std::vector<std::size_t> all{0};
            all.insert(all.end(), cuts[axis].begin(), cuts[axis].end());
            all.push_back(axis == 0 ? p.nx : p.ny);
            return all;
        };
        const std::array ends_of{ends(0), ends(1)};
        for (std::size_t j = 0; j + 1 < ends_of[1].size(); ++j) {
            for (std::size_t i = 0; i + 1 < ends_of[0].size(); ++i) {
                blocks_.push_back(block_of(whole, ends_of, {i, j}));
            }
        }
    }

    std::vector<Block>& all() { return blocks_; }
    const std::vector<Block>& all() const { return blocks_; }

    void start(const Plane& whole) {
        for (Block& block : blocks_) {
            for_each(block, [&](std::size_t here, std::size_t there, bool /*is_own*/) {
                for (const std::size_t a : {0U, 1U}) {
                    block.plane.displacement(a)[here] = whole.displacement(a)[there];
                    block.plane.velocity(a)[here] = whole.velocity(a)[there];
                }
            });
            block.plane.start();
        }
        exchange();
    }

    void advance() {
        for (Block& block : blocks_) {
            block.plane.advance(1);
        }
        exchange();
    }

    /// On the grid of the whole.
    Field displacement() const {
        return gathered([](const Plane& plane, std::size_t a) { return plane.displacement(a); });
    }

    PlaneEnergies energies() const {
        PlaneEnergies sum;
        for (const Block& block : blocks_) {
            const PlaneEnergies own = block.plane.energies();
            sum.kinetic += own.kinetic;
            sum.strain += own.strain;
            sum.stabilisation += own.stabilisation;
            sum.staggered += own.staggered;
        }
        return sum;
    }

    /// Of this plane's quantity.
    template <class Of>
    double sum(const Of& of) const {
        double all = 0;
        for (const Block& block : blocks_) {
            all += of(block.plane);
        }
        return all;
    }

  private:
    using Ends = std::array<std::vector<std::size_t>, 2>;
    static Block block_of(const Plane& whole, const Ends& ends,
                          const std::array<std::size_t, 2>& place) {
        PlaneSides sides = whole.sides();
        PlaneParameters p = whole.parameters();
        std::array<std::array<bool, 2>, 2> has_halo{};
        for (const std::size_t axis : {0U, 1U}) {
            has_halo[axis] = {place[axis] > 0, place[axis] + 2 < ends[axis].size()};
        }
        const auto close = [](bool has, PlaneSide& side) {
            if (has) {
                side = HaloSide{};
            }
        };
        close(has_halo[0][0], sides.left);
        close(has_halo[0][1], sides.right);
        close(has_halo[1][0], sides.bottom);
        close(has_halo[1][1], sides.top);
        std::array<std::size_t, 2> first{};
        std::array<std::size_t, 2> count{};
        for (const std::size_t axis : {0U, 1U}) {
            first[axis] = ends[axis][place[axis]];
            count[axis] = ends[axis][place[axis] + 1] - first[axis];
        }
        p.nx = count[0];
        p.ny = count[1];
        Block block{Plane(whole.model(), sides, p), first};
        const std::array grid{block.plane.grid().nx, block.plane.grid().ny};
        const std::size_t halo = block.plane.ghosts();
        for (const std::size_t axis : {0U, 1U}) {
            block.offset[axis] =
                whole.layers()[2 * axis] + first[axis] - block.plane.layers()[2 * axis];
            block.own[axis] = {has_halo[axis][0] ? halo : 0,
                               grid[axis] - (has_halo[axis][1] ? halo : 0)};
        }
        return block;
    }

    template <class See>
    void for_each(const Block& block, const See& see) const {
        const Grid grid = block.plane.grid();
        for (std::size_t y = 0; y < grid.ny; ++y) {
            for (std::size_t x = 0; x < grid.nx; ++x) {
                see(y * grid.nx + x, (y + block.offset[1]) * pitch_ + x + block.offset[0],
                    block.owns(x, y));
            }
        }
    }

    template <class Of>
    Field gathered(const Of& of) const {
        Field all{std::vector<double>(pitch_ * rows_), std::vector<double>(pitch_ * rows_)};
        for (const Block& block : blocks_) {
            for_each(block, [&](std::size_t here, std::size_t there, bool is_own) {
                for (const std::size_t a : {0U, 1U}) {
                    if (is_own) {
                        all[a][there] = of(block.plane, a)[here];
                    }
                }
            });
        }
        return all;
    }

    void exchange() {
        const Field u = displacement();
        const Field v =
            gathered([](const Plane& plane, std::size_t a) { return plane.velocity(a); });
        for (Block& block : blocks_) {
            for_each(block, [&](std::size_t here, std::size_t there, bool is_own) {
                for (const std::size_t a : {0U, 1U}) {
                    if (!is_own) {
                        block.plane.displacement(a)[here] = u[a][there];
                        block.plane.velocity(a)[here] = v[a][there];
                    }
                }
            });
        }
    }

    std::size_t pitch_;
    std::size_t rows_;
    std::vector<Block> blocks_{};
};

/// Of the interiors, over max |u|.
double difference(const Plane& whole, const Blocks& blocks) {
    const Field u = blocks.displacement();
    double most = 0;
    double largest = 0;
    for (std::size_t y = 0; y < whole.parameters().ny; ++y) {
        for (std::size_t x = 0; x < whole.parameters().nx; ++x) {
            for (const std::size_t a : {0U, 1U}) {
                const double there = whole.displacement(a)[whole.entry(x, y)];
                most = std::max(most, std::abs(u[a][whole.entry(x, y)] - there));
                largest = std::max(largest, std::abs(there));
            }
        }
    }
    return most / largest;
}

PlaneParameters parameters(const PlaneModel& model, const PlaneSides& sides) {
    PlaneParameters p{.nx = 31, .ny = 29, .spacing = 0.5, .youngs_modulus = 7, .density = 3};
    p.time_step = 0.8 * 2 / std::sqrt(highest_eigenvalue(model, sides, p.nx, p.ny)) / p.rate();
    return p;
}

BondModel equal_bonds(unsigned radius_squared) {
    return bond2d(radius_squared,
                  std::vector<double>(plane_bond_classes(radius_squared).size(), 0.1));
}

double sum_left(const Plane& plane) {
    return sum_of(plane.left());
}

}  // namespace

TEST_CASE("blocks that exchange their edges are the whole") {
    const PassiveSide passive = some_passive_side(0);
    const PassiveSide coupled = some_passive_side(0.2);
    const HigdonSide higdon{{1.1, 0.6}, 0.002};
    const BoundaryCoefficients first{.c = {1, 1}, .b = {-2, 2}, .stride = 1};
    const MatchingSide matching{.coefficients = {first, first}, .speeds = {1, 0.6}};
    struct Body {
        PlaneSides sides;
        std::array<std::vector<std::size_t>, 2> cuts;
    };
    const std::vector<Body> bodies{
        {PlaneSides::all(passive), {std::vector<std::size_t>{14}, {13}}},
        {PlaneSides{FixedSide{}, FreeSide{}, passive, FreeSide{}},
         {std::vector<std::size_t>{9, 20}, {13}}},
        {PlaneSides{passive, SpongeSide{{0.3, 0.1}}, higdon, matching},
         {std::vector<std::size_t>{14}, {8, 18}}},
        {PlaneSides{FreeSide{}, passive, PeriodicSide{}, PeriodicSide{}},
         {std::vector<std::size_t>{8, 17}, {}}},
        {PlaneSides{PeriodicSide{}, PeriodicSide{}, higdon, FixedSide{}},
         {std::vector<std::size_t>{}, {11}}},
        {PlaneSides::all(coupled), {std::vector<std::size_t>{10, 20}, {10, 20}}},
    };
    for (const PlaneModel& model :
         {PlaneModel(nopd2d(1, 0.25, 0.5)), PlaneModel(nopd2d(4, 0.25, 0.5)),
          PlaneModel(nopd2d(9, 0.25, 0.5)), PlaneModel(equal_bonds(4)),
          PlaneModel(equal_bonds(9))}) {
        CAPTURE(model.horizon());
        const bool is_bond_based = std::holds_alternative<BondModel>(model.law());
        for (std::size_t number = 0; number + (is_bond_based ? 1 : 0) < bodies.size(); ++number) {
            CAPTURE(number);
            const auto& [sides, cuts] = bodies[number];
            Plane whole(model, sides, parameters(model, sides));
            fill_at_random(whole, 3);
            Blocks blocks(whole, cuts);
            blocks.start(whole);
            whole.start();
            // What an exchange gets wrong is there at once; waves cross a block in so many.
            for (int step = 0; step < 40; ++step) {
                whole.advance(1);
                blocks.advance();
            }
            // Roundings of 40 steps.
            CHECK(difference(whole, blocks) < 1e-13);
            const PlaneEnergies sum = blocks.energies();
            const PlaneEnergies all = whole.energies();
            const auto near = [&](double value) {
                return doctest::Approx(value).epsilon(1e-12).scale(all.total());
            };
            CHECK(sum.kinetic == near(all.kinetic));
            CHECK(sum.strain == near(all.strain));
            CHECK(sum.stabilisation == near(all.stabilisation));
            CHECK(sum.staggered == near(all.staggered));
            CHECK(blocks.sum(sum_left) == near(sum_left(whole)));
        }
    }
}

TEST_CASE("cracks go on from block to block, and each bond is counted once") {
    const PlaneModel model = equal_bonds(9);
    const PassiveSide passive = some_passive_side(0);
    for (const PlaneSides& sides :
         {PlaneSides{FreeSide{}, passive, passive, FixedSide{}},
          PlaneSides{FreeSide{}, passive, PeriodicSide{}, PeriodicSide{}}}) {
        const bool is_periodic = std::holds_alternative<PeriodicSide>(sides.top);
        Plane whole(model, sides, parameters(model, sides));
        fill_at_random(whole, 4);
        Blocks blocks(whole,
                      {std::vector<std::size_t>{15},
                       is_periodic ? std::vector<std::size_t>{} : std::vector<std::size_t>{12}});
        const auto keep = [](std::ptrdiff_t x, std::ptrdiff_t y) {
            return x > 12 && x < 18 && y < 4;
        };
        whole.cut({3, 11.5}, {20, 11.5});
        whole.break_above(1.5, keep);
        for (Block& block : blocks.all()) {
            const auto x0 = std::ptrdiff_t(block.first[0]);
            const auto y0 = std::ptrdiff_t(block.first[1]);
            block.plane.cut({3 - double(x0), 11.5 - double(y0)},
                            {20 - double(x0), 11.5 - double(y0)});
            block.plane.break_above(
                1.5, [&](std::ptrdiff_t x, std::ptrdiff_t y) { return keep(x + x0, y + y0); });
        }
        blocks.start(whole);
        whole.start();
        for (int step = 0; step < 60; ++step) {
            whole.advance(1);
            blocks.advance();
        }
        CHECK(whole.broken() > 100);
        CHECK(difference(whole, blocks) < 1e-13);
        for (const Block& block : blocks.all()) {
            for (std::size_t y = 0; y < block.plane.parameters().ny; ++y) {
                for (std::size_t x = 0; x < block.plane.parameters().nx; ++x) {
                    CHECK(block.plane.damage(x, y) ==
                          whole.damage(x + block.first[0], y + block.first[1]));
                }
            }
        }
        CHECK(blocks.sum([](const Plane& plane) { return plane.broken(); }) == whole.broken());
        CHECK(blocks.sum([](const Plane& plane) { return plane.released(); }) ==
              doctest::Approx(whole.released()).epsilon(1e-12));
    }
}

TEST_CASE("a block has as many nodes as its neighbours copy") {
    const PlaneSides sides{FreeSide{}, HaloSide{}, FreeSide{}, FreeSide{}};
    const PlaneParameters p{.nx = 3, .ny = 9, .time_step = 0.1};
    CHECK_THROWS_AS(Plane(nopd2d(4, 0.25, 0), sides, p), std::invalid_argument);
    CHECK_THROWS_AS(Plane(equal_bonds(16), sides, p), std::invalid_argument);
    CHECK_NOTHROW(Plane(equal_bonds(9), sides, p));
}
