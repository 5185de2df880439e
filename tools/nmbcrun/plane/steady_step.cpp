// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/plane/steady_step.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>
#include <vector>

#include "generator/families/vector_family.hpp"
#include "generator/plane/sampled_growth.hpp"
#include "tools/nmbcrun/plane/designed_side.hpp"

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

class Strips {
  public:
    explicit Strips(const PlaneScene& scene)
        : task_(side_task_of(scene)),
          lattice_(nmbcgen::plane_lattice(
              nmbcgen::find_vector_family(task_.family).describe(task_.choice), task_.g,
              scene.tau)),
          is_damped_(scene.tau != 0),
          longest_(nmbcgen::longest_step(lattice_)) {}

    void add(const nmbc::PlaneSide& low, const nmbc::PlaneSide& high) {
        if (const auto condition = condition_of(low)) {
            pairs_.emplace_back(*condition, opposite_of(*condition, high));
        } else if (const auto other = condition_of(high)) {
            pairs_.emplace_back(*other, opposite_of(*other, low));
        }
    }

    bool grow(double share) const {
        constexpr std::array<std::size_t, 3> layers{5, 9, 20};
        return std::ranges::any_of(pairs_, [&](const auto& pair) {
            return nmbcgen::strips_grow(lattice_, pair.first, pair.second, layers,
                                        share * longest_);
        });
    }

    bool empty() const { return pairs_.empty(); }
    double longest_step() const { return longest_; }

  private:
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
    std::vector<std::pair<nmbcgen::SideCondition, nmbcgen::OppositeSide>> pairs_{};
};

}  // namespace

std::optional<SteadyStep> steady_step(const PlaneScene& scene, const nmbc::PlaneSides& sides) {
    if (!scene.influence.empty()) {
        return std::nullopt;
    }
    Strips strips(scene);
    strips.add(sides.left, sides.right);
    strips.add(sides.bottom, sides.top);
    if (strips.empty()) {
        return std::nullopt;
    }
    SteadyStep steady;
    for (const double share : nmbcgen::side_samples.steps) {
        if (strips.grow(share)) {
            break;
        }
        steady = {.share = share, .time_step = share * strips.longest_step()};
    }
    return steady;
}

}  // namespace nmbcrun
