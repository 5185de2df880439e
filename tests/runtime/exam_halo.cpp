// SPDX-License-Identifier: MIT
// A plane in four blocks that exchange their edges is the plane in one.
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

constexpr auto none = [](auto, auto) { return false; };  // no node is kept whole

using Field = std::array<std::vector<double>, 2>;

/// A part of the whole, on a grid of its own.
struct Block {
    Plane plane;
    std::array<std::size_t, 2> first{};   ///< interior node of the whole that is its node 0
    std::array<std::size_t, 2> offset{};  ///< of its grid in that of the whole
    std::array<std::array<std::size_t, 2>, 2> own{};  ///< what it steps: first and last of its grid
};

class Blocks {
  public:
    /// Cut before interior node cut[0] along x, and before cut[1] along y.
    Blocks(const Plane& whole, const std::array<std::size_t, 2>& cut)
        : pitch_(whole.grid().nx), rows_(whole.grid().ny) {
        const PlaneParameters& p = whole.parameters();
        const std::array nodes{p.nx, p.ny};
        for (const std::size_t low_y : {0U, 1U}) {
            for (const std::size_t low_x : {0U, 1U}) {
                const std::array part{low_x, low_y};
                std::array<std::size_t, 2> first{};
                std::array<std::size_t, 2> count{};
                for (const std::size_t axis : {0U, 1U}) {
                    first[axis] = part[axis] == 0 ? 0 : cut[axis];
                    count[axis] = (part[axis] == 0 ? cut[axis] : nodes[axis]) - first[axis];
                }
                PlaneSides sides = whole.sides();
                (low_x == 0 ? sides.right : sides.left) = HaloSide{};
                (low_y == 0 ? sides.top : sides.bottom) = HaloSide{};
                PlaneParameters of_block = p;
                of_block.nx = count[0];
                of_block.ny = count[1];
                Block block{Plane(whole.model(), sides, of_block), first};
                const std::array grid{block.plane.grid().nx, block.plane.grid().ny};
                for (const std::size_t axis : {0U, 1U}) {
                    block.offset[axis] =
                        whole.layers()[2 * axis] + first[axis] - block.plane.layers()[2 * axis];
                    const std::size_t halo = block.plane.ghosts();
                    block.own[axis] = {part[axis] == 0 ? 0 : halo,
                                       grid[axis] - (part[axis] == 0 ? halo : 0)};
                }
                blocks_.push_back(std::move(block));
            }
        }
    }

    std::vector<Block>& all() { return blocks_; }

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

  private:
    template <class See>
    void for_each(const Block& block, const See& see) const {
        const Grid grid = block.plane.grid();
        for (std::size_t y = 0; y < grid.ny; ++y) {
            for (std::size_t x = 0; x < grid.nx; ++x) {
                const bool is_own = x >= block.own[0][0] && x < block.own[0][1] &&
                                    y >= block.own[1][0] && y < block.own[1][1];
                see(y * grid.nx + x, (y + block.offset[1]) * pitch_ + x + block.offset[0], is_own);
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

double largest(const std::vector<double>& values) {
    double most = 0;
    for (const double value : values) {
        most = std::max(most, std::abs(value));
    }
    return most;
}

/// Over max |u|.
double difference(const Plane& whole, const Blocks& blocks) {
    const Field u = blocks.displacement();
    double most = 0;
    for (const std::size_t a : {0U, 1U}) {
        for (std::size_t i = 0; i < u[a].size(); ++i) {
            most = std::max(most, std::abs(u[a][i] - whole.displacement(a)[i]));
        }
    }
    return most / largest(u[1]);
}

PlaneParameters parameters(const PlaneModel& model, const PlaneSides& sides) {
    PlaneParameters p{.nx = 31, .ny = 29, .spacing = 0.5, .youngs_modulus = 7, .density = 3};
    p.time_step = 0.8 * 2 / std::sqrt(highest_eigenvalue(model, sides, p.nx, p.ny)) / p.rate();
    return p;
}

BondModel some_bonds(unsigned radius_squared) {
    return bond2d(radius_squared,
                  std::vector<double>(plane_bond_classes(radius_squared).size(), 0.1));
}

}  // namespace

TEST_CASE("four blocks that exchange their edges are the whole") {
    const PassiveSide passive = some_passive_side(0);
    const HigdonSide higdon{{1.1, 0.6}, 0.002};
    for (const PlaneModel& model :
         {PlaneModel(nopd2d(1, 0.25, 0.5)), PlaneModel(nopd2d(4, 0.25, 0.5)),
          PlaneModel(nopd2d(9, 0.25, 0.5)), PlaneModel(some_bonds(4)), PlaneModel(some_bonds(9))}) {
        CAPTURE(model.horizon());
        for (const PlaneSides& sides :
             {PlaneSides::all(passive), PlaneSides{FixedSide{}, FreeSide{}, passive, FreeSide{}},
              PlaneSides{passive, SpongeSide{{0.3, 0.1}}, higdon, higdon}}) {
            CAPTURE(sides.right.index());
            Plane whole(model, sides, parameters(model, sides));
            fill_at_random(whole, 3);
            Blocks blocks(whole, {14, 13});
            blocks.start(whole);
            whole.start();
            for (int step = 0; step < 100; ++step) {
                whole.advance(1);
                blocks.advance();
            }
            // Meep asks for 1e-13 of such blocks; roundings of 100 steps here.
            CHECK(difference(whole, blocks) < 1e-13);
            PlaneEnergies sum;
            for (const Block& block : blocks.all()) {
                const PlaneEnergies own = block.plane.energies();
                sum.kinetic += own.kinetic;
                sum.strain += own.strain;
                sum.staggered += own.staggered;
            }
            const PlaneEnergies all = whole.energies();
            CHECK(sum.kinetic == doctest::Approx(all.kinetic).epsilon(1e-12));
            CHECK(sum.strain == doctest::Approx(all.strain).epsilon(1e-12));
            CHECK(sum.staggered == doctest::Approx(all.staggered).epsilon(1e-12));
        }
    }
}

TEST_CASE("cracks go on from block to block, and each bond is counted once") {
    const PlaneModel model = some_bonds(9);
    const PassiveSide passive = some_passive_side(0);
    const PlaneSides sides{FreeSide{}, passive, passive, FixedSide{}};
    Plane whole(model, sides, parameters(model, sides));
    fill_at_random(whole, 4);
    Blocks blocks(whole, {15, 12});
    whole.cut({3, 11.5}, {20, 11.5});
    whole.break_above(1.5, none);
    for (Block& block : blocks.all()) {
        const auto local = [&](double x, double y) {
            return PlanePoint{x - double(block.first[0]), y - double(block.first[1])};
        };
        block.plane.cut(local(3, 11.5), local(20, 11.5));
        block.plane.break_above(1.5, none);
    }
    blocks.start(whole);
    whole.start();
    for (int step = 0; step < 60; ++step) {
        whole.advance(1);
        blocks.advance();
    }
    CHECK(whole.broken() > 100);
    CHECK(difference(whole, blocks) < 1e-13);
    double broken = 0;
    double released = 0;
    for (const Block& block : blocks.all()) {
        broken += block.plane.broken();
        released += block.plane.released();
        for (std::size_t y = 0; y < block.plane.parameters().ny; ++y) {
            for (std::size_t x = 0; x < block.plane.parameters().nx; ++x) {
                CHECK(block.plane.damage(x, y) ==
                      whole.damage(x + block.first[0], y + block.first[1]));
            }
        }
    }
    CHECK(broken == whole.broken());
    CHECK(released == doctest::Approx(whole.released()).epsilon(1e-12));
}

TEST_CASE("blocks go on beside periodic sides") {
    const PlaneModel model = nopd2d(4, 0.25, 0.5);
    const PlaneSides sides{FreeSide{}, some_passive_side(0), PeriodicSide{}, PeriodicSide{}};
    PlaneSides left = sides;
    left.right = HaloSide{};
    PlaneSides right = sides;
    right.left = HaloSide{};
    const PlaneParameters p = parameters(model, sides);
    PlaneParameters half = p;
    Plane whole(model, sides, p);
    half.nx = 12;
    Plane first(model, left, half);
    half.nx = p.nx - 12;
    Plane second(model, right, half);
    fill_at_random(whole, 5);
    const auto copy = [&](Plane& to, const Plane& from, std::ptrdiff_t first_x,
                          std::ptrdiff_t last_x, std::ptrdiff_t shift) {
        for (std::size_t y = 0; y < p.ny; ++y) {
            for (std::ptrdiff_t x = first_x; x < last_x; ++x) {
                for (const std::size_t a : {0U, 1U}) {
                    to.displacement(a)[to.entry(std::size_t(x), y)] =
                        from.displacement(a)[from.entry(std::size_t(x + shift), y)];
                    to.velocity(a)[to.entry(std::size_t(x), y)] =
                        from.velocity(a)[from.entry(std::size_t(x + shift), y)];
                }
            }
        }
    };
    const auto halo = std::ptrdiff_t(whole.ghosts());
    const auto layers = std::ptrdiff_t(whole.layers()[1]);
    copy(first, whole, 0, 12 + halo, 0);
    copy(second, whole, -halo, std::ptrdiff_t(p.nx) - 12 + layers, 12);
    whole.start();
    first.start();
    second.start();
    for (int step = 0; step < 100; ++step) {
        copy(first, second, 12, 12 + halo, -12);
        copy(second, first, -halo, 0, 12);
        whole.advance(1);
        first.advance(1);
        second.advance(1);
    }
    double most = 0;
    for (std::size_t y = 0; y < p.ny; ++y) {
        for (std::size_t x = 0; x < p.nx; ++x) {
            const Plane& block = x < 12 ? first : second;
            most = std::max(most,
                            std::abs(whole.displacement(1)[whole.entry(x, y)] -
                                     block.displacement(1)[block.entry(x < 12 ? x : x - 12, y)]));
        }
    }
    CHECK(most < 1e-13 * largest({whole.displacement(1).begin(), whole.displacement(1).end()}));
}
