// SPDX-License-Identifier: MIT
#include "generator/closures/plane_summation_by_parts.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <nmbc/correspondence_model.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "generator/dense/least_squares.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using nmbc::PlaneOffset;

/// A node, counted from the corner, and Q_x or Q_y by its axis.
struct Bond {
    std::size_t axis = 0;
    PlaneOffset from{};
    PlaneOffset to{};
};

/// A linear function of what is sought.
struct Linear {
    double constant = 0;
    std::map<Index, double> factors{};

    void add(double factor, const Linear& other) {
        constant += factor * other.constant;
        for (const auto& [index, own] : other.factors) {
            factors[index] += factor * own;
        }
    }
};

int along(const PlaneOffset& offset, std::size_t axis) {
    return axis == 0 ? offset.x : offset.y;
}

class Parts {
  public:
    explicit Parts(const nmbc::CorrespondenceModel& model)
        : family_(nmbc::detail::weighted_family(model)),
          beside_(std::max(int(model.horizon()), 2)),
          corner_(beside_ + 1),
          shape_(nmbc::detail::whole_shape(model)) {
        for (const auto& [x, y, influence] : family_) {
            influences_[{x, y}] = influence;
        }
        demand_sides();
        demand_corner();
        solve();
    }

    nmbc::PlaneClosure closure(const nmbc::CorrespondenceModel& model) {
        nmbc::PlaneClosure closure{.radius_squared = model.radius_squared,
                                   .influence = model.influence,
                                   .layers = std::size_t(corner_)};
        for (int j = 0; j <= corner_; ++j) {
            for (int i = 0; i <= corner_; ++i) {
                closure.nodes.push_back(node_at({i, j}));
            }
            closure.surface.push_back(value_of(surface(0, j)));
        }
        return closure;
    }

  private:
    using Key = std::array<int, 6>;

    /// A number that is sought, near this one.
    Linear sought(const Key& key, double near) {
        const auto [found, is_new] = places_.try_emplace(key, Index(near_.size()));
        if (is_new) {
            near_.push_back(near);
        }
        return {0, {{found->second, 1}}};
    }
    void demand(Linear zero) { demands_.push_back(std::move(zero)); }

    /// On a surface and further in.
    static double near_volume(int layer) {
        constexpr double on_surface = 0.7;
        return layer == 0 ? on_surface : 1;
    }

    /// What a side adds to an entry of Q, whatever the place along it is: between nodes at a and b
    /// layers from it, `step` apart along it. Across the side Q is odd in a, b and even in the
    /// step, along it the other way round.
    void add_side(Linear& entry, bool is_across, int a, int b, int step) {
        enum { across, along };
        if (a >= beside_ || b >= beside_ || (is_across ? a == b : step == 0)) {
            return;
        }
        const bool is_turned = is_across ? a > b : step < 0;
        entry.add(is_turned ? -1 : 1, sought({is_across ? across : along, std::min(a, b),
                                              std::max(a, b), std::abs(step), 0, 0},
                                             0));
    }

    /// The entry of Q; of a corner, too, where that is asked for.
    Linear entry(const Bond& bond, bool is_in_corner) {
        const PlaneOffset step{bond.to.x - bond.from.x, bond.to.y - bond.from.y};
        Linear entry{influences_.at({step.x, step.y}) * along(step, bond.axis) / shape_};
        add_side(entry, bond.axis == 0, bond.from.x, bond.to.x, step.y);
        if (!is_in_corner) {
            return entry;
        }
        add_side(entry, bond.axis == 1, bond.from.y, bond.to.y, step.x);
        const auto is_near = [this](const PlaneOffset& node) {
            return node.x < corner_ && node.y < corner_;
        };
        if (is_near(bond.from) && is_near(bond.to)) {
            const bool is_turned =
                std::pair(bond.from.y, bond.from.x) > std::pair(bond.to.y, bond.to.x);
            const PlaneOffset& first = is_turned ? bond.to : bond.from;
            const PlaneOffset& last = is_turned ? bond.from : bond.to;
            entry.add(is_turned ? -1 : 1,
                      sought({2 + int(bond.axis), first.x, first.y, last.x, last.y, 0}, 0));
        }
        return entry;
    }
    /// V of a side's layers, far from the corner.
    Linear volume(int layer) {
        return layer < beside_ ? sought({4, layer, 0, 0, 0, 0}, near_volume(layer)) : Linear{1};
    }
    Linear volume(const PlaneOffset& node) {
        if (node.x >= corner_ || node.y >= corner_) {
            return volume(std::min(node.x, node.y));
        }
        return sought({5, node.x, node.y, 0, 0, 0}, near_volume(node.x) * near_volume(node.y));
    }
    /// H of node j of the side across an axis.
    Linear surface(std::size_t axis, int j) {
        return j < corner_ ? sought({6, int(axis), j, 0, 0, 0}, near_volume(j)) : Linear{1};
    }

    /// Sum of Q over a node's bonds, and its moments along x and y.
    std::array<Linear, 3> moments(std::size_t axis, const PlaneOffset& node, bool is_in_corner) {
        std::array<Linear, 3> moments;
        for (const auto& bond : family_) {
            const PlaneOffset to{node.x + bond.x, node.y + bond.y};
            if (to.x < 0 || (is_in_corner && to.y < 0)) {
                continue;
            }
            const Linear own = entry({axis, node, to}, is_in_corner);
            moments[0].add(1, own);
            moments[1].add(bond.x, own);
            moments[2].add(bond.y, own);
        }
        return moments;
    }

    /// The others hold, as Q is even or odd along the side.
    void demand_sides() {
        for (int layer = 0; layer < beside_; ++layer) {
            auto [sum, along_x, skew] = moments(0, {layer, 0}, false);
            sum.constant -= layer == 0 ? 0.5 : 0;
            along_x.add(-1, volume(layer));
            auto [odd, odder, along_y] = moments(1, {layer, 0}, false);
            along_y.add(-1, volume(layer));
            demand(std::move(sum));
            demand(std::move(along_x));
            demand(std::move(along_y));
        }
    }

    void demand_corner() {
        for (int j = 0; j < corner_; ++j) {
            for (int i = 0; i < corner_; ++i) {
                for (const std::size_t axis : {0U, 1U}) {
                    const PlaneOffset node{i, j};
                    std::array<Linear, 3> all = moments(axis, node, true);
                    if (along(node, axis) == 0) {
                        all[0].add(-0.5, surface(axis, along(node, 1 - axis)));
                    }
                    all[1 + axis].add(-1, volume(node));
                    std::ranges::for_each(all, [this](Linear& one) { demand(std::move(one)); });
                }
            }
        }
    }

    void solve() {
        const VectorXd near = Eigen::Map<const VectorXd>(near_.data(), Index(near_.size()));
        MatrixXd factors = MatrixXd::Zero(Index(demands_.size()), near.size());
        VectorXd missing(factors.rows());
        for (Index row = 0; row < factors.rows(); ++row) {
            const Linear& zero = demands_[std::size_t(row)];
            missing[row] = -zero.constant;
            for (const auto& [column, factor] : zero.factors) {
                factors(row, column) = factor;
            }
        }
        missing -= factors * near;
        constexpr double dependent = 1e-10;  // some demands follow from the others
        const VectorXd change = least_norm_solution(factors, missing, dependent);
        constexpr double roundings = 1e-12;
        if (!((factors * change - missing).cwiseAbs().maxCoeff() < roundings)) {
            throw std::domain_error("the corners of this family cannot be closed");
        }
        values_ = near + change;
    }

    double value_of(const Linear& number) const {
        double value = number.constant;
        for (const auto& [index, factor] : number.factors) {
            value += factor * values_[index];
        }
        return value;
    }

    nmbc::PlaneClosure::Node node_at(const PlaneOffset& near) {
        // Far from a side: so far that all its neighbours are.
        const int far = 3 * corner_;
        const PlaneOffset node{near.x == corner_ ? far : near.x, near.y == corner_ ? far : near.y};
        const double V = value_of(volume(node));
        if (!(V > 0)) {
            throw std::domain_error("a node near the side would have the volume " +
                                    std::to_string(V));
        }
        nmbc::PlaneClosure::Node result{.volume = V};
        for (const auto& bond : family_) {
            const PlaneOffset to{node.x + bond.x, node.y + bond.y};
            if (to.x >= 0 && to.y >= 0) {
                result.gradient.push_back({bond.x, bond.y, value_of(entry({0, node, to}, true)) / V,
                                           value_of(entry({1, node, to}, true)) / V});
            }
        }
        return result;
    }

    std::vector<nmbc::detail::WeightedBond> family_;
    std::map<std::array<int, 2>, double> influences_{};  // of bonds
    int beside_;
    int corner_;
    double shape_;  ///< sum of the influence times x^2 over a family
    std::map<Key, Index> places_{};
    std::vector<double> near_{};
    std::vector<Linear> demands_{};
    VectorXd values_{};
};

}  // namespace

nmbc::PlaneClosure plane_summation_by_parts(const nmbc::CorrespondenceModel& model) {
    return Parts(model).closure(model);
}

}  // namespace nmbcgen
