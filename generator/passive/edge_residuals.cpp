// SPDX-License-Identifier: MIT
#include "generator/passive/edge_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "generator/dense/decompositions.hpp"
#include "generator/dense/portable_math.hpp"
#include "generator/exact/rational.hpp"

namespace nmbcgen {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd vector_of(const std::vector<double>& values) {
    return Eigen::Map<const VectorXd>(values.data(), Index(values.size()));
}

}  // namespace

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

EdgeEigenvalue highest_eigenvalue_beside(const EdgeEnergies& energies, const PassiveEdge& edge) {
    const Index size = energies.components;
    const Index free = size * energies.reach.interior();
    VectorXd scale = VectorXd::Ones(free);
    for (Index layer = 0; layer < energies.reach.layers; ++layer) {
        for (Index a = 0; a < size; ++a) {
            scale(size * layer + a) = 1 / std::sqrt(edge.mass(layer, a));
        }
    }
    const MatrixXd stiffness = energies.stiffness(edge).topLeftCorner(free, free);
    const SymmetricEigenpairs pairs =
        symmetric_eigenpairs(scale.asDiagonal() * stiffness * scale.asDiagonal());
    return {pairs.values(free - 1), scale.asDiagonal() * pairs.vectors.col(free - 1)};
}

EdgeResiduals::EdgeResiduals(const EdgeTask& task, const std::vector<WeightedWave>& waves,
                             const std::vector<double>& speeds)
    : task_(task), waves_(waves), speeds_(speeds), layers_(task.reach.layers), lattice_(start()) {
    for (std::size_t i = 0; i <= task.stiff_steps; ++i) {
        stiff_.push_back(task.at(std::numbers::pi * double(i) / double(task.stiff_steps)));
    }
    for (const auto& [wave, weight] : waves) {
        energies_.push_back(task.at(wave.wave_number));
        entries_ += 2 * std::ranges::count_if(wave.outgoing, &PlaneMode::travels);
    }
}

VectorXd EdgeResiduals::start() const {
    constexpr double next_to_none = 0.05;
    std::vector<double> values;
    const auto add_logarithms = [&](double outermost) {
        for (Index layer = 0; layer < layers_; ++layer) {
            values.push_back(layer == 0 ? portable::log(outermost) : 0);
        }
    };
    add_logarithms(0.5);
    if (task_.has_stabilisation) {
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

Index EdgeResiduals::logarithms() const {
    return layers_ * Index((task_.has_stabilisation ? 2 : 1) + task_.dimensions);
}

EdgeNumbers<double> EdgeResiduals::numbers(const VectorXd& parameters) const {
    Index at = 0;
    const auto weights = [&] {
        std::vector<double> result;
        for (Index layer = 0; layer < layers_; ++layer) {
            result.push_back(portable::exp(parameters(at++)));
        }
        return result;
    };
    EdgeNumbers<double> numbers;
    numbers.strain = weights();
    numbers.stabilisation =
        task_.has_stabilisation ? weights() : std::vector<double>(std::size_t(layers_), 1);
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
            nearest_double(task_.largest_beta) * (1 + portable::sin(parameters(at++))) / 2;
    }
    return numbers;
}

template <class Vector>
Vector EdgeResiduals::slopes(const Edge& at, const EdgeEnergies& energies, const Vector& left,
                             const Vector& right, double omega_squared,
                             typename Vector::Scalar damping) const {
    const Index size = energies.components;
    const Index rows = left.size();
    const auto form = [&](const MatrixXd& matrix, Index first, Index end) {
        const Index height = std::min(rows, end) - first;
        const Index width = std::min(Index(right.size()), end) - first;
        return (left.segment(first, height).transpose() *
                matrix.block(first, first, height, width) * right.segment(first, width))
            .value();
    };
    const auto form_of_node = [&](const MatrixXd& matrix, Index layer) {  // whole families at most
        const Index reach = energies.reach.node;
        return form(matrix, size * std::max<Index>(0, layer - reach), size * (layer + reach + 1));
    };
    const double beta = at.edge.null_lagrangian;
    Vector result = Vector::Zero(lattice_.size());
    Index entry = 0;
    typename Vector::Scalar by_beta = 0;
    if (task_.largest_beta != 0) {
        by_beta = form(energies.further.null_lagrangian, 0, right.size());
    }
    for (Index layer = 0; layer < layers_; ++layer) {
        const EdgeEnergies::Node& node = energies.outermost[std::size_t(layer)];
        const typename Vector::Scalar of_beta = form_of_node(node.null_lagrangian, layer);
        by_beta += at.edge.strain(layer) * of_beta;
        result(entry++) =
            at.edge.strain(layer) * (form_of_node(node.strain, layer) + beta * of_beta);
    }
    for (Index layer = 0; task_.has_stabilisation && layer < layers_; ++layer) {
        result(entry++) = at.edge.stabilisation(layer) *
                          form_of_node(energies.outermost[std::size_t(layer)].stabilisation, layer);
    }
    for (Index a = 0; a < size; ++a) {
        for (Index layer = 0; layer < layers_; ++layer) {
            const Index own = size * layer + a;
            result(entry++) = -omega_squared * at.edge.mass(layer, a) * left(own) * right(own);
        }
    }
    for (Index a = 0; a < size; ++a) {  // C = (c/s) L L^T
        const auto& factor = at.numbers.factor[std::size_t(a)];
        const double scale = at.numbers.scale[std::size_t(a)];
        const double share = speeds_[std::size_t(a)] / scale;
        Vector left_columns = Vector::Zero(layers_);  // L^T of both
        Vector right_columns = Vector::Zero(layers_);
        VectorXd column_sums = VectorXd::Zero(layers_);
        for (Index row = 0; row < layers_; ++row) {
            for (Index column = 0; column <= row; ++column) {
                const double one = factor[std::size_t(row)][std::size_t(column)];
                left_columns(column) += one * left(size * row + a);
                right_columns(column) += one * right(size * row + a);
                column_sums(column) += one;
            }
        }
        const typename Vector::Scalar whole = left_columns.cwiseProduct(right_columns).sum();
        for (Index row = 0; row < layers_; ++row) {
            for (Index column = 0; column <= row; ++column) {
                typename Vector::Scalar slope = left(size * row + a) * right_columns(column) +
                                                left_columns(column) * right(size * row + a);
                if (task_.is_exact_head_on) {  // s = sum of the squares of the column sums
                    slope -= whole * (2 * column_sums(column) / scale);
                }
                result(entry++) = damping * share * slope;
            }
        }
    }
    if (task_.largest_beta != 0) {
        result(entry++) = at.beta_slope * by_beta;
    }
    return result;
}

Linearised EdgeResiduals::at(const VectorXd& parameters) const {
    const Index own = lattice_.size();
    const Index light = task_.light > 0 ? logarithms() : 0;
    Linearised result{VectorXd::Zero(entries_ + Index(stiff_.size()) + own + light), {}};
    result.slopes = MatrixXd::Zero(result.values.size(), own);
    Edge now{.numbers = numbers(parameters), .edge = {}, .beta_slope = 0};
    now.edge = edge_in_doubles(now.numbers, speeds_);
    if (task_.largest_beta != 0) {
        now.beta_slope = nearest_double(task_.largest_beta) *
                         portable::cos(parameters(parameters.size() - 1)) / 2;
    }
    Index at = 0;
    for (std::size_t i = 0; i < waves_.size(); ++i) {
        const auto& [wave, weight] = waves_[i];
        const EdgeResponse response = edge_response(energies_[i], now.edge, wave, task_.time_step);
        for (Index o = 0; o < response.amplitudes.size(); ++o) {
            const Eigen::VectorXcd adjoint = response.adjoint.row(o);
            const Eigen::VectorXcd slope =
                -weight * slopes<Eigen::VectorXcd>(now, energies_[i], adjoint, response.field,
                                                   wave.omega * wave.omega, {0, response.damping});
            result.values(at) = weight * response.amplitudes(o).real();
            result.slopes.row(at++) = slope.real();
            result.values(at) = weight * response.amplitudes(o).imag();
            result.slopes.row(at++) = slope.imag();
        }
    }
    for (const EdgeEnergies& energies : stiff_) {
        const EdgeEigenvalue highest = highest_eigenvalue_beside(energies, now.edge);
        const double above = highest.value / task_.highest_eigenvalue - task_.most_stiff();
        result.values(at) = task_.long_steps * std::max(0.0, above);
        if (above > 0) {
            result.slopes.row(at) =
                task_.long_steps / task_.highest_eigenvalue *
                slopes<VectorXd>(now, energies, highest.mode, highest.mode, highest.value, 0.0);
        }
        ++at;
    }
    const VectorXd away = parameters - lattice_;
    result.values.segment(at, own) = task_.near_the_lattice * away;
    result.slopes.middleRows(at, own).diagonal().setConstant(task_.near_the_lattice);
    at += own;
    const double free = portable::log(3);
    for (Index i = 0; i < light; ++i) {
        if (std::abs(away(i)) > free) {
            result.values(at + i) = task_.light * (away(i) - std::copysign(free, away(i)));
            result.slopes(at + i, i) = task_.light;
        }
    }
    return result;
}

}  // namespace nmbcgen
