// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/steady_step.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <variant>
#include <vector>

#include "generator/families/vector_family.hpp"
#include "generator/plane/sampled_growth.hpp"
#include "tools/nmbcrun/plane/designed_side.hpp"
#include "tools/nmbcrun/plane/plane_lattice.hpp"
#include "tools/nmbcrun/stepping/plane_stepping.hpp"

namespace nmbcrun {
namespace {

/// Nothing of a side whose ghosts do not move.
std::optional<nmbcgen::SideCondition> condition_of(const nmbc::PlaneSide& side) {
    if (const auto* const matching = std::get_if<nmbc::MatchingSide>(&side)) {
        nmbcgen::SideCondition condition;
        for (const std::size_t a : {0U, 1U}) {
            const nmbc::BoundaryCoefficients& own = matching->coefficients[a];
            condition.residual[a] =
                nmbcgen::matching_residual(own.c, own.b, own.stride, matching->speeds[a]);
        }
        return condition;
    }
    if (const auto* const higdon = std::get_if<nmbc::HigdonSide>(&side)) {
        nmbcgen::ShiftPolynomial product;
        for (const double speed : higdon->speeds) {
            const nmbcgen::ShiftPolynomial factor = nmbcgen::absorbs(speed, higdon->decay);
            product = product.empty() ? factor : nmbcgen::product(product, factor);
        }
        return nmbcgen::SideCondition{{product, product}};
    }
    return std::nullopt;
}

/// Whether there is something to look at; other scenes may not have a lattice to be looked at in.
bool has_conditions(const PlaneScene& scene, const nmbc::PlaneSides& sides) {
    const std::array all{&sides.left, &sides.right, &sides.bottom, &sides.top};
    return scene.influence.empty() && std::ranges::any_of(all, [](const auto* side) {
               return condition_of(*side).has_value();
           });
}

/// Interior nodes that the condition of a side, if it has one, reads.
std::size_t reach_of(const nmbc::PlaneSide& side) {
    std::size_t reach = 0;
    if (const auto* const matching = std::get_if<nmbc::MatchingSide>(&side)) {
        for (const nmbc::BoundaryCoefficients& own : matching->coefficients) {
            reach = std::max(reach, (own.c.size() - 1) * std::size_t(own.stride));
        }
    }
    return reach;
}

/// Of a sponge, the layers that a small body can do with: the innermost, behind which nodes rest.
nmbc::PlaneSide thin(nmbc::PlaneSide side) {
    if (auto* const sponge = std::get_if<nmbc::SpongeSide>(&side)) {
        const std::size_t kept = std::min(sponge->friction.size(), nmbcgen::side_samples.nodes);
        sponge->friction.erase(sponge->friction.begin(), sponge->friction.end() - long(kept));
    }
    return side;
}

/// A small body between the scene's sides, its corners included. It is run, not solved for its
/// eigenvalues, so that sides of all kinds can meet in it.
class Box {
  public:
    Box(const PlaneScene& scene, nmbc::PlaneSides sides, const std::array<std::size_t, 2>& nodes)
        : model_(model_of(scene)), sides_(std::move(sides)) {
        std::size_t edge = std::max(nmbcgen::side_samples.nodes, 2 * model_.horizon());
        for (auto* const side : {&sides_.left, &sides_.right, &sides_.bottom, &sides_.top}) {
            edge = std::max(edge, reach_of(*side));
            *side = thin(*side);
        }
        nx_ = std::min(nodes[0], edge);
        ny_ = std::min(nodes[1], edge);
    }

    /// Whether random velocities have more than twice the squares towards t = 1000 that they had
    /// before t = 500: what grows more slowly than exp(0.0007 t) is missed [dX sqrt(rho/E)].
    bool grows(double time_step) const {
        const InOneThread small;
        nmbc::Plane plane(model_, sides_, {.nx = nx_, .ny = ny_, .time_step = time_step});
        std::mt19937 random;  // NOLINT(bugprone-random-generator-seed): alike in all runs
        for (const std::size_t a : {0U, 1U}) {
            for (std::size_t i = 0; i < nx_ * ny_; ++i) {
                plane.velocity(a)[plane.entry(i % nx_, i / nx_)] = double(random()) / 0x1p32 - 0.5;
            }
        }
        plane.start();
        constexpr double duration = 1000;
        constexpr std::size_t parts = 400;
        const auto steps = std::size_t(duration / double(parts) / time_step) + 1;
        double before = 0;
        double after = 0;
        for (std::size_t part = 1; part <= parts; ++part) {
            plane.advance(steps);
            const double now = squares_of(plane);
            constexpr double far_more = 1e6;
            if (!(now < far_more * double(nx_ * ny_))) {
                return true;
            }
            if (part > parts / 4 && part <= parts / 2) {
                before = std::max(before, now);
            } else if (part > 3 * parts / 4) {
                after = std::max(after, now);
            }
        }
        return after > 2 * before;
    }

  private:
    static double squares_of(const nmbc::Plane& plane) {
        double sum = 0;
        for (const std::size_t a : {0U, 1U}) {
            for (const double velocity : plane.velocity(a)) {
                sum += velocity * velocity;
            }
        }
        return sum;
    }

    nmbc::PlaneModel model_;
    nmbc::PlaneSides sides_;
    std::size_t nx_ = 0;
    std::size_t ny_ = 0;
};

class Strips {
  public:
    Strips(const PlaneScene& scene, const nmbc::PlaneSides& sides,
           const std::array<std::size_t, 2>& nodes)
        : task_(side_task_of(scene)),
          lattice_(nmbcgen::plane_lattice(
              nmbcgen::find_vector_family(task_.family).describe(task_.choice), task_.g,
              scene.tau)),
          is_damped_(scene.tau != 0),
          longest_(nmbcgen::longest_step(lattice_)) {
        add(sides.left, sides.right, nodes[0]);
        add(sides.bottom, sides.top, nodes[1]);
    }

    bool grow(double time_step) const {
        return std::ranges::any_of(pairs_, [&](const Pair& pair) {
            return nmbcgen::strips_grow(lattice_, pair.own, pair.opposite, pair.layers, time_step);
        });
    }

    double longest_step() const { return longest_; }

  private:
    struct Pair {
        nmbcgen::SideCondition own;
        nmbcgen::OppositeSide opposite;
        std::vector<std::size_t> layers;
    };

    void add(const nmbc::PlaneSide& low, const nmbc::PlaneSide& high, std::size_t across) {
        std::vector<std::size_t> layers{5, 9, 20};
        if (across < layers.front()) {
            layers.insert(layers.begin(), across);
        }
        if (const auto condition = condition_of(low)) {
            pairs_.push_back({*condition, opposite_of(*condition, high), std::move(layers)});
        } else if (const auto other = condition_of(high)) {
            pairs_.push_back({*other, opposite_of(*other, low), std::move(layers)});
        }
    }

    nmbcgen::OppositeSide opposite_of(const nmbcgen::SideCondition& own,
                                      const nmbc::PlaneSide& side) const {
        if (const auto other = condition_of(side)) {
            return nmbcgen::always(*other);
        }
        if (std::holds_alternative<nmbc::FixedSide>(side)) {
            return nmbcgen::always(nmbcgen::fixed_condition());
        }
        if (std::holds_alternative<nmbc::FreeSide>(side) && !is_damped_) {
            return nmbcgen::free_opposite(task_).value();
        }
        return nmbcgen::always(own);
    }

    nmbcgen::SideTask task_;
    nmbcgen::PlaneLattice lattice_;
    bool is_damped_;
    double longest_;
    std::vector<Pair> pairs_{};
};

/// A box would take long in steps below a tenth of the lattice's longest, which feed less in.
bool grow_in(const Strips& strips, const Box& box, double time_step) {
    return strips.grow(time_step) ||
           (time_step >= nmbcgen::side_samples.steps.front() * strips.longest_step() &&
            box.grows(time_step));
}

}  // namespace

std::optional<SteadyStep> steady_step(const PlaneScene& scene, const nmbc::PlaneSides& sides,
                                      const std::array<std::size_t, 2>& nodes, double stable) {
    if (!has_conditions(scene, sides)) {
        return std::nullopt;
    }
    const Strips strips(scene, sides, nodes);
    const Box box(scene, sides, nodes);
    constexpr double well_below = 0.95;
    SteadyStep steady;
    for (const double share : nmbcgen::side_samples.steps) {
        // Beyond what the sides allow, a box grows by its steps alone.
        const double time_step = std::min(share * strips.longest_step(), well_below * stable);
        if (grow_in(strips, box, time_step)) {
            break;
        }
        steady = {.share = share, .time_step = time_step};
        if (time_step < share * strips.longest_step()) {
            break;
        }
    }
    return steady;
}

bool bodies_grow_in(const PlaneScene& scene, const nmbc::PlaneSides& sides,
                    const std::array<std::size_t, 2>& nodes, double time_step) {
    return has_conditions(scene, sides) &&
           grow_in(Strips(scene, sides, nodes), Box(scene, sides, nodes), time_step);
}

}  // namespace nmbcrun
