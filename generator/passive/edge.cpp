// SPDX-License-Identifier: MIT
#include "generator/passive/edge.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "generator/dense/decompositions.hpp"
#include "generator/dense/portable_math.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

}  // namespace

EdgeSquares::Square EdgeSquares::in_doubles(const VectorSquare& square, double weight) {
    Square rounded{.weight = weight, .terms = {}};
    for (const VectorTerm& term : square.terms) {
        rounded.terms.push_back(
            {.layer = term.offset[0],
             .along = term.offset[1],
             .factors = {nearest_double(term.factors[0]), nearest_double(term.factors[1])}});
    }
    return rounded;
}

EdgeSquares::EdgeSquares(const NodeEnergy& node_energy, Index node, const Rational& g,
                         const Rational& some_beta) {
    for (unsigned layer = 0; layer <= unsigned(node); ++layer) {
        OfLayer& own = by_layer_.emplace_back();
        const auto add_null_lagrangian = [&](const VectorSquare& square, const Rational& share) {
            own.null_lagrangian.push_back(
                in_doubles(square, nearest_double(evaluate(square.weight, g) * share)));
        };
        for (const VectorSquare& square : node_energy(layer, 0)) {
            const bool is_strain = square.part == EnergyPart::strain;
            (is_strain ? own.strain : own.stabilisation)
                .push_back(in_doubles(square, nearest_double(evaluate(square.weight, g))));
            if (is_strain && some_beta != 0) {
                add_null_lagrangian(square, -1 / some_beta);
            }
        }
        if (some_beta == 0) {
            continue;
        }
        for (const VectorSquare& square : node_energy(layer, some_beta)) {
            if (square.part == EnergyPart::strain) {
                add_null_lagrangian(square, 1 / some_beta);
            }
        }
    }
}

/// Adds weight |sum of terms|^2 at exp(i k y), components as in LateralChain. Off the diagonal
/// the imaginary parts of mirror images in y cancel.
void EdgeSquares::add(MatrixXd& stiffness, const std::vector<Square>& squares, Index layer,
                      Index components, double wave_number) {
    for (const Square& square : squares) {
        if (square.terms.empty()) {  // cut off
            continue;
        }
        const auto [first, last] = std::ranges::minmax(square.terms, {}, &Square::Term::layer);
        Eigen::VectorXcd row = Eigen::VectorXcd::Zero(components * (last.layer - first.layer + 1));
        for (const Square::Term& term : square.terms) {
            const Complex phase = portable::unit(wave_number * term.along);
            for (Index a = 0; a < components; ++a) {
                row(components * (term.layer - first.layer) + a) +=
                    term.factors[std::size_t(a)] * phase * (a == 1 ? Complex(0, -1) : Complex(1));
            }
        }
        const Index corner = components * (layer + first.layer);
        stiffness.block(corner, corner, row.size(), row.size()) +=
            square.weight * (row.conjugate() * row.transpose()).real();
    }
}

EdgeEnergies EdgeSquares::energies(std::size_t dimensions, const EdgeReach& reach,
                                   double wave_number) const {
    const auto components = Index(dimensions);
    const Index nodes = reach.interior() + reach.node;
    const Index window = nodes + reach.node;
    const MatrixXd none = MatrixXd::Zero(components * window, components * window);
    EdgeEnergies energies{
        .outermost = {}, .further = {none, none, none}, .components = components, .reach = reach};
    energies.outermost.assign(std::size_t(reach.layers), energies.further);
    for (Index layer = 0; layer < nodes; ++layer) {
        const OfLayer& own = by_layer_[std::min(std::size_t(layer), by_layer_.size() - 1)];
        EdgeEnergies::Node& node =
            layer < reach.layers ? energies.outermost[std::size_t(layer)] : energies.further;
        add(node.strain, own.strain, layer, components, wave_number);
        add(node.null_lagrangian, own.null_lagrangian, layer, components, wave_number);
        add(node.stabilisation, own.stabilisation, layer, components, wave_number);
    }
    return energies;
}

MatrixXd EdgeEnergies::stiffness(const PassiveEdge& edge) const {
    MatrixXd sum =
        further.strain + edge.null_lagrangian * further.null_lagrangian + further.stabilisation;
    for (Index layer = 0; layer < reach.layers; ++layer) {
        const Node& node = outermost[std::size_t(layer)];
        sum += edge.strain(layer) * (node.strain + edge.null_lagrangian * node.null_lagrangian) +
               edge.stabilisation(layer) * node.stabilisation;
    }
    return sum;
}

CutSide free_side(const EdgeSquares& squares, Index node, Index forces, double wave_number) {
    const EdgeEnergies energies =
        squares.energies(2, {.node = node, .forces = forces, .layers = forces - node}, wave_number);
    const Index layers = energies.reach.layers;
    const MatrixXd stiffness = energies.stiffness({.strain = Eigen::VectorXd::Ones(layers),
                                                   .stabilisation = Eigen::VectorXd::Ones(layers),
                                                   .mass = {},
                                                   .dashpots = {},
                                                   .null_lagrangian = 0});
    const Index moved_by = std::min(stiffness.cols(), 4 * forces);  // both components
    return {stiffness.topLeftCorner(2 * forces, moved_by)};
}

namespace {

/// Equations of motion of an edge at one frequency: system times the free layers' displacements and
/// the outgoing amplitudes is `incident`, for each incident wave.
struct EdgeSystem {
    double damping = 0;
    MatrixXcd outgoing;  ///< columns: displacements of a mode, on all layers
    MatrixXcd arriving;
    MatrixXcd system;
    MatrixXcd incident;
    Index free = 0;  ///< unknowns that are displacements
};

EdgeSystem edge_system(const EdgeEnergies& energies, const PassiveEdge& edge,
                       const std::vector<PlaneMode>& outgoing, double omega, double time_step) {
    const Index size = energies.components;
    const Index own_numbers = energies.reach.layers;
    const Index equations = size * energies.reach.interior();
    EdgeSystem result;
    result.damping = omega * std::sqrt(1 - std::pow(omega * time_step / 2, 2));
    MatrixXcd motion = energies.stiffness(edge).topRows(equations).cast<Complex>();
    for (Index layer = 0; layer < energies.reach.interior(); ++layer) {
        for (Index a = 0; a < size; ++a) {
            const Index own = size * layer + a;
            motion(own, own) -= omega * omega * (layer < own_numbers ? edge.mass(layer, a) : 1);
            for (Index other = 0; layer < own_numbers && other < own_numbers; ++other) {
                motion(own, size * other + a) +=
                    Complex(0, result.damping) * edge.dashpots[std::size_t(a)](layer, other);
            }
        }
    }
    const Index first = energies.reach.waves();  // layers below move freely
    const Index layers = motion.cols() / size;
    const auto on_layers = [&](const PlaneMode& mode) {
        Eigen::VectorXcd column = Eigen::VectorXcd::Zero(motion.cols());
        Complex power = 1;
        for (Index layer = first; layer < layers; ++layer) {
            column.segment(size * layer, size) = power * mode.shape;
            power *= mode.z;
        }
        return column;
    };
    const auto all = Index(outgoing.size());
    const Index travelling = travelling_count(outgoing);
    result.free = size * first;
    result.outgoing.resize(motion.cols(), all);
    result.arriving.resize(motion.cols(), travelling);
    for (Index o = 0; o < all; ++o) {
        const PlaneMode& mode = outgoing[std::size_t(o)];
        result.outgoing.col(o) = on_layers(mode);
        if (o < travelling) {
            result.arriving.col(o) = on_layers(mirror_image(mode));
        }
    }
    result.system.resize(equations, result.free + all);
    result.system.leftCols(result.free) = motion.leftCols(result.free);
    result.system.rightCols(all) = motion * result.outgoing;
    result.incident = -motion * result.arriving;
    return result;
}

}  // namespace

MatrixXcd edge_amplitudes(const EdgeEnergies& energies, const PassiveEdge& edge,
                          const std::vector<PlaneMode>& outgoing, double omega, double time_step) {
    const EdgeSystem at = edge_system(energies, edge, outgoing, omega, time_step);
    return solution_of(at.system, at.incident).bottomRows(Index(outgoing.size()));
}

EdgeResponse edge_response(const EdgeEnergies& energies, const PassiveEdge& edge,
                           const ArrivingWave& wave, double time_step) {
    const EdgeSystem at = edge_system(energies, edge, wave.outgoing, wave.omega, time_step);
    const Index all = at.outgoing.cols();
    const Index travelling = at.arriving.cols();
    const Eigen::VectorXcd unknowns = solution_of(at.system, at.incident.col(wave.column));
    MatrixXcd rows = MatrixXcd::Zero(at.system.rows(), travelling);
    rows.middleRows(at.free, travelling).setIdentity();
    const Eigen::VectorXcd in_metric =
        in_flux_metric(MatrixXcd::Ones(travelling, travelling), wave.outgoing).col(wave.column);
    EdgeResponse response{.amplitudes = {}, .adjoint = {}, .field = {}, .damping = at.damping};
    response.amplitudes = in_metric.cwiseProduct(unknowns.segment(at.free, travelling));
    response.adjoint =
        in_metric.asDiagonal() * solution_of(at.system.transpose(), rows).transpose();
    response.field = at.outgoing * unknowns.tail(all) + at.arriving.col(wave.column);
    response.field.head(at.free) = unknowns.head(at.free);
    return response;
}

MatrixXcd edge_reflection(const EdgeEnergies& energies, const PassiveEdge& edge,
                          const std::vector<PlaneMode>& outgoing, double omega, double time_step) {
    return in_flux_metric(edge_amplitudes(energies, edge, outgoing, omega, time_step)
                              .topRows(travelling_count(outgoing)),
                          outgoing);
}

std::vector<double> entries_of(const Eigen::MatrixXd& matrix) {
    std::vector<double> entries;
    for (const auto& row : matrix.rowwise()) {
        entries.insert(entries.end(), row.begin(), row.end());
    }
    return entries;
}

}  // namespace nmbcgen
