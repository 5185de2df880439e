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

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd vector_of(const std::vector<double>& values) {
    return Eigen::Map<const VectorXd>(values.data(), Index(values.size()));
}

PassiveEdge edge_in_doubles(const EdgeNumbers<double>& numbers, const std::vector<double>& speeds) {
    PassiveEdge edge{.strain = vector_of(numbers.strain),
                     .stabilisation = vector_of(numbers.stabilisation),
                     .mass = MatrixXd(Index(numbers.strain.size()), Index(numbers.mass.size())),
                     .dashpots = {},
                     .null_lagrangian = numbers.null_lagrangian};
    for (std::size_t a = 0; a < numbers.mass.size(); ++a) {
        edge.mass.col(Index(a)) = vector_of(numbers.mass[a]);
        MatrixXd lower = MatrixXd::Zero(edge.mass.rows(), edge.mass.rows());
        for (std::size_t row = 0; row < numbers.factor[a].size(); ++row) {
            lower.row(Index(row)).head(Index(row) + 1) = vector_of(numbers.factor[a][row]);
        }
        edge.dashpots.emplace_back(speeds[a] / numbers.scale[a] * lower * lower.transpose());
    }
    return edge;
}

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

/// |L^T 1|^2: the sum of all entries of L L^T.
template <class Number>
Number sum_of_square(const std::vector<std::vector<Number>>& factor) {
    Number total = 0;
    for (std::size_t column = 0; column < factor.size(); ++column) {
        Number sum = 0;
        for (std::size_t row = column; row < factor.size(); ++row) {
            sum += factor[row][column];
        }
        total += sum * sum;
    }
    return total;
}

template <class Number>
void set_scales(EdgeNumbers<Number>& numbers, bool is_exact_head_on) {
    numbers.scale.clear();
    for (const auto& factor : numbers.factor) {
        numbers.scale.push_back(is_exact_head_on ? sum_of_square(factor) : Number(1));
    }
}

/// Of M^-1 K of the layers whose forces are whole, the others held.
double largest_eigenvalue(const EdgeEnergies& energies, const PassiveEdge& edge) {
    const Index size = energies.components;
    const Index free = size * energies.reach.interior();
    VectorXd scale = VectorXd::Ones(free);
    for (Index layer = 0; layer < energies.reach.layers; ++layer) {
        for (Index a = 0; a < size; ++a) {
            scale(size * layer + a) = 1 / std::sqrt(edge.mass(layer, a));
        }
    }
    const MatrixXd stiffness = energies.stiffness(edge).topLeftCorner(free, free);
    const MatrixXd scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
    return symmetric_eigenvalues(scaled).maxCoeff();
}

/// The edge as a function of free parameters, and what it reflects.
class Residuals {
  public:
    Residuals(const EdgeTask& task, const std::vector<WeightedWave>& waves,
              const std::vector<double>& speeds)
        : task_(task),
          waves_(waves),
          speeds_(speeds),
          layers_(task.reach.layers),
          has_stabilisation_(task.has_stabilisation),
          start_(start()) {
        for (const double wave_number : {0.0, std::numbers::pi / 2, std::numbers::pi}) {
            stiff_.push_back(task.at(wave_number));
        }
        for (const auto& [wave, weight] : waves) {
            energies_.push_back(task.at(wave.wave_number));
            entries_ += 2 * std::ranges::count_if(wave.outgoing, &PlaneMode::travels);
        }
    }

    /// The lattice as it is, half a cell on its outermost layer, dashpots there alone; next to none
    /// on the others, since at none the derivatives vanish.
    VectorXd start() const {
        constexpr double next_to_none = 0.05;
        std::vector<double> values;
        const auto add_logarithms = [&](double outermost) {
            for (Index layer = 0; layer < layers_; ++layer) {
                values.push_back(layer == 0 ? std::log(outermost) : 0);
            }
        };
        add_logarithms(0.5);
        if (has_stabilisation_) {
            add_logarithms(1);
        }
        for (std::size_t a = 0; a < task_.dimensions; ++a) {
            add_logarithms(0.5);
        }
        for (std::size_t a = 0; a < task_.dimensions; ++a) {
            for (Index entry = 0; entry < layers_ * (layers_ + 1) / 2; ++entry) {
                values.push_back(entry == 0 ? 1 : next_to_none);
            }
        }
        if (task_.largest_beta != 0) {
            constexpr double third = -0.3;  // of largest_beta, as sin
            values.push_back(third);
        }
        return Eigen::Map<VectorXd>(values.data(), Index(values.size()));
    }

    EdgeNumbers<double> numbers(const VectorXd& parameters) const {
        Index at = 0;
        const auto weights = [&] {
            std::vector<double> result;
            for (Index layer = 0; layer < layers_; ++layer) {
                result.push_back(std::exp(parameters(at++)));
            }
            return result;
        };
        EdgeNumbers<double> numbers;
        numbers.strain = weights();
        numbers.stabilisation =
            has_stabilisation_ ? weights() : std::vector<double>(std::size_t(layers_), 1);
        for (std::size_t a = 0; a < task_.dimensions; ++a) {
            numbers.mass.push_back(weights());
        }
        for (std::size_t a = 0; a < task_.dimensions; ++a) {
            auto& factor = numbers.factor.emplace_back();
            for (Index row = 0; row < layers_; ++row) {
                auto& entries = factor.emplace_back();
                for (Index column = 0; column <= row; ++column) {
                    entries.push_back(parameters(at++));
                }
            }
        }
        set_scales(numbers, task_.is_exact_head_on);
        if (task_.largest_beta != 0) {
            numbers.null_lagrangian =
                nearest_double(task_.largest_beta) * (1 + std::sin(parameters(at++))) / 2;
        }
        return numbers;
    }

    VectorXd operator()(const VectorXd& parameters) const {
        VectorXd residuals(entries_ + Index(stiff_.size()) + start_.size());
        const PassiveEdge now = edge_in_doubles(numbers(parameters), speeds_);
        Index at = 0;
        for (std::size_t i = 0; i < waves_.size(); ++i) {
            const auto& [wave, weight] = waves_[i];
            const Eigen::MatrixXcd matrix =
                edge_reflection(energies_[i], now, wave.outgoing, wave.omega, task_.time_step);
            for (const std::complex<double>& amplitude : matrix.col(wave.column)) {
                residuals(at++) = weight * amplitude.real();
                residuals(at++) = weight * amplitude.imag();
            }
        }
        for (const EdgeEnergies& energies : stiff_) {
            const double ratio = largest_eigenvalue(energies, now) / task_.highest_eigenvalue;
            residuals(at++) = task_.long_steps * std::max(0.0, ratio - task_.most_stiff());
        }
        residuals.tail(start_.size()) = task_.near_the_lattice * (parameters - start_);
        return residuals;
    }

  private:
    const EdgeTask& task_;
    const std::vector<WeightedWave>& waves_;
    const std::vector<double>& speeds_;
    Index layers_;
    bool has_stabilisation_;
    VectorXd start_;
    std::vector<EdgeEnergies> energies_{};  // at the wave numbers of the waves
    std::vector<EdgeEnergies> stiff_{};     // at those whose eigenvalues are kept low
    Index entries_ = 0;
};

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
                          const std::vector<double>& speeds) {
    const Residuals residuals(task, waves, speeds);
    const VectorXd parameters = least_squares(std::cref(residuals), residuals.start());
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
        highest = std::max(highest, largest_eigenvalue(task.at(wave_number), deep));
    }
    return highest;
}

PassiveSide designed_side(EdgeTask task, const std::vector<WeightedWave>& waves,
                          const std::vector<double>& speeds, std::size_t wave_numbers) {
    constexpr double nearly = 0.99;  // two sides next to each other are stiffer than one
    const double stable = nearly * 4 / (task.time_step * task.time_step);
    if (!(task.highest_eigenvalue < stable)) {
        throw std::domain_error("the lattice itself is stable in steps below " +
                                std::to_string(2 / std::sqrt(task.highest_eigenvalue)) + ", not " +
                                std::to_string(task.time_step));
    }
    PassiveSide side{.task = std::move(task), .design = {}, .edge = {}, .highest_eigenvalue = 0};
    side.design = design_edge(side.task, waves, speeds);
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
