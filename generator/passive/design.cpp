// SPDX-License-Identifier: MIT
#include "generator/passive/design.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "generator/dense/decompositions.hpp"
#include "generator/dense/least_squares.hpp"
#include "generator/exact/rational.hpp"
#include "generator/passive/edge_residuals.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The same numbers of another kind.
template <class To, class From, class Convert>
EdgeNumbers<To> converted(const EdgeNumbers<From>& from, Convert convert) {
    const auto each = [&](const std::vector<From>& values) {
        std::vector<To> result;
        std::ranges::transform(values, std::back_inserter(result), convert);
        return result;
    };
    EdgeNumbers<To> to{.strain = each(from.strain),
                       .stabilisation = each(from.stabilisation),
                       .mass = {},
                       .factor = {},
                       .scale = each(from.scale),
                       .null_lagrangian = convert(from.null_lagrangian)};
    std::ranges::transform(from.mass, std::back_inserter(to.mass), each);
    for (const auto& factor : from.factor) {
        std::ranges::transform(factor, std::back_inserter(to.factor.emplace_back()), each);
    }
    return to;
}

/// What is positive remains so.
Rational rounded(double value, long denominator) {
    constexpr double too_large = 1e15;
    if (!(std::abs(value) * double(denominator) < too_large)) {
        throw std::domain_error("the search ends far from the lattice");
    }
    const long nearest = std::lround(value * double(denominator));
    return {nearest == 0 && value > 0 ? 1 : nearest, denominator};
}

VectorXd searched(const EdgeResiduals& residuals, const EdgeTask& task,
                  const DesignProgress& progress) {
    std::size_t done = 0;
    return least_squares(
        residuals.start(),
        [&](const VectorXd& at) {
            if (progress) {
                const auto most = std::size_t(task.evaluations);
                done = std::min(done + 1, most);  // a search looks at its end once more
                progress(done, most);
            }
            return residuals.at(at);
        },
        task.evaluations);
}

}  // namespace

double EdgeTask::most_stiff() const {
    constexpr double at_most = 1.3;
    constexpr double below_the_limit = 0.94;
    const double stable = 4 / (time_step * time_step * highest_eigenvalue);
    return std::min(at_most, below_the_limit * stable);
}

PassiveEdge edge_of(const PassiveDesign& design, const std::vector<double>& speeds) {
    return edge_in_doubles(
        converted<double>(design, [](const Rational& value) { return nearest_double(value); }),
        speeds);
}

void require_passive(const PassiveDesign& design, const Rational& largest_beta) {
    const auto all_positive = [](const std::vector<Rational>& values) {
        return std::ranges::all_of(values, [](const Rational& value) { return value > 0; });
    };
    if (!all_positive(design.strain) || !all_positive(design.stabilisation) ||
        !std::ranges::all_of(design.mass, all_positive) || !all_positive(design.scale) ||
        design.null_lagrangian < 0 || design.null_lagrangian > largest_beta) {
        throw std::logic_error("an edge was designed that is not passive");
    }
}

PassiveDesign design_edge(const EdgeTask& task, const std::vector<WeightedWave>& waves,
                          const std::vector<double>& speeds, const DesignProgress& progress) {
    const EdgeResiduals residuals(task, waves, speeds);
    const VectorXd parameters = searched(residuals, task, progress);
    PassiveDesign design = converted<Rational>(residuals.numbers(parameters), [&](double value) {
        return rounded(value, task.denominator);
    });
    set_scales(design, task.is_exact_head_on);
    design.null_lagrangian = std::min(design.null_lagrangian, task.largest_beta);
    require_passive(design, task.largest_beta);
    return design;
}

double reflected_by_edge(const EdgeTask& task, const PassiveEdge& edge, const ArrivingWave& wave) {
    return edge_reflection(task.at(wave.wave_number), edge, wave.outgoing, wave.omega,
                           task.time_step)
        .col(wave.column)
        .squaredNorm();
}

double highest_eigenvalue_of_edge(EdgeTask task, const PassiveEdge& edge,
                                  std::size_t wave_numbers) {
    // Held layers make the eigenvalue lower: so far behind the edge they no longer matter.
    const Index own = task.reach.layers;
    const Index all = own + 4 * task.reach.forces;
    task.reach.layers = all;
    PassiveEdge deep{.strain = VectorXd::Ones(all),
                     .stabilisation = VectorXd::Ones(all),
                     .mass = MatrixXd::Ones(all, edge.mass.cols()),
                     .dashpots = {},
                     .null_lagrangian = edge.null_lagrangian};
    deep.strain.head(own) = edge.strain;
    deep.stabilisation.head(own) = edge.stabilisation;
    deep.mass.topRows(own) = edge.mass;
    double highest = 0;
    for (std::size_t i = 0; i <= wave_numbers; ++i) {
        const double wave_number = std::numbers::pi * double(i) / double(wave_numbers);
        highest = std::max(highest, highest_eigenvalue_beside(task.at(wave_number), deep).value);
    }
    return highest;
}

DesignedSide designed_side(EdgeTask task, const std::vector<WeightedWave>& waves,
                           const std::vector<double>& speeds, std::size_t wave_numbers,
                           const DesignProgress& progress) {
    const double stable = stable_margin * 4 / (task.time_step * task.time_step);
    if (!(task.highest_eigenvalue < stable)) {
        throw std::domain_error("the lattice itself is stable in steps below " +
                                std::to_string(2 / std::sqrt(task.highest_eigenvalue)) + ", not " +
                                std::to_string(task.time_step));
    }
    DesignedSide side{.task = std::move(task), .design = {}, .edge = {}, .highest_eigenvalue = 0};
    side.design = design_edge(side.task, waves, speeds, progress);
    side.edge = edge_of(side.design, speeds);
    side.highest_eigenvalue =
        std::max(side.task.highest_eigenvalue,
                 highest_eigenvalue_of_edge(side.task, side.edge, wave_numbers));
    if (!(side.highest_eigenvalue < stable)) {
        throw std::domain_error("the search ends at springs too stiff for steps of " +
                                std::to_string(side.task.time_step));
    }
    return side;
}

}  // namespace nmbcgen
