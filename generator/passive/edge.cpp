// SPDX-License-Identifier: MIT
#include "generator/passive/edge.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "generator/dense/decompositions.hpp"
#include "generator/exact/rational.hpp"
#include "generator/exact/rational_function.hpp"

namespace nmbcgen {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// Adds weight |sum of terms|^2 at exp(i k y), components as in LateralChain. Off the diagonal
/// the imaginary parts of mirror images in y cancel.
void add(MatrixXd& stiffness, const VectorSquare& square, double weight, Index layer,
         Index components, double wave_number) {
    Eigen::VectorXcd row = Eigen::VectorXcd::Zero(stiffness.rows());
    for (const VectorTerm& term : square.terms) {
        const Complex phase = std::polar(1.0, wave_number * term.offset[1]);
        for (Index a = 0; a < components; ++a) {
            row(components * (layer + term.offset[0]) + a) +=
                nearest_double(term.factors[std::size_t(a)]) * phase *
                (a == 1 ? Complex(0, -1) : Complex(1));
        }
    }
    stiffness += weight * (row.conjugate() * row.transpose()).real();
}

}  // namespace

EdgeEnergies edge_energies(const NodeEnergy& node_energy, std::size_t dimensions,
                           const EdgeReach& reach, const Rational& g, const Rational& some_beta,
                           double wave_number) {
    const auto components = Index(dimensions);
    const Index nodes = reach.interior() + reach.node;
    const Index window = nodes + reach.node;
    const MatrixXd none = MatrixXd::Zero(components * window, components * window);
    EdgeEnergies energies{
        .outermost = {}, .further = {none, none, none}, .components = components, .reach = reach};
    energies.outermost.assign(std::size_t(reach.layers), energies.further);
    // Layers from reach.node on have whole families, and so the same squares.
    struct Squares {
        std::vector<VectorSquare> plain;
        std::vector<VectorSquare> with_beta;
    };
    std::vector<Squares> by_layer;
    for (unsigned layer = 0; layer <= unsigned(reach.node); ++layer) {
        by_layer.push_back({node_energy(layer, 0), some_beta == 0 ? std::vector<VectorSquare>{}
                                                                  : node_energy(layer, some_beta)});
    }
    for (Index layer = 0; layer < nodes; ++layer) {
        const auto& [plain, with_beta] = by_layer[std::size_t(std::min(layer, reach.node))];
        EdgeEnergies::Node& node =
            layer < reach.layers ? energies.outermost[std::size_t(layer)] : energies.further;
        for (const VectorSquare& square : plain) {
            const double weight = nearest_double(evaluate(square.weight, g));
            add(square.part == EnergyPart::strain ? node.strain : node.stabilisation, square,
                weight, layer, components, wave_number);
            if (some_beta != 0 && square.part == EnergyPart::strain) {
                add(node.null_lagrangian, square, -weight / nearest_double(some_beta), layer,
                    components, wave_number);
            }
        }
        for (const VectorSquare& square : with_beta) {
            if (square.part == EnergyPart::strain) {
                add(node.null_lagrangian, square,
                    nearest_double(evaluate(square.weight, g) / some_beta), layer, components,
                    wave_number);
            }
        }
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

MatrixXcd edge_amplitudes(const EdgeEnergies& energies, const PassiveEdge& edge,
                          const std::vector<PlaneMode>& outgoing, double omega, double time_step) {
    const double lag = std::sqrt(1 - std::pow(omega * time_step / 2, 2));
    const Index size = energies.components;
    const Index own_numbers = energies.reach.layers;
    const Index equations = size * energies.reach.interior();
    MatrixXcd motion = energies.stiffness(edge).topRows(equations).cast<Complex>();
    for (Index layer = 0; layer < energies.reach.interior(); ++layer) {
        for (Index a = 0; a < size; ++a) {
            const Index own = size * layer + a;
            motion(own, own) -= omega * omega * (layer < own_numbers ? edge.mass(layer, a) : 1);
            for (Index other = 0; layer < own_numbers && other < own_numbers; ++other) {
                motion(own, size * other + a) +=
                    Complex(0, omega * lag) * edge.dashpots[std::size_t(a)](layer, other);
            }
        }
    }
    const Index first = energies.reach.waves();  // layers below move freely
    const Index free = size * first;
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
    MatrixXcd system(equations, free + all);
    system.leftCols(free) = motion.leftCols(free);
    MatrixXcd incident(equations, travelling);
    for (Index o = 0; o < all; ++o) {
        const PlaneMode& mode = outgoing[std::size_t(o)];
        system.col(free + o) = motion * on_layers(mode);
        if (o < travelling) {
            incident.col(o) = -motion * on_layers(mirror_image(mode));
        }
    }
    return solution_of(system, incident).bottomRows(all);
}

MatrixXcd edge_reflection(const EdgeEnergies& energies, const PassiveEdge& edge,
                          const std::vector<PlaneMode>& outgoing, double omega, double time_step) {
    return in_flux_metric(edge_amplitudes(energies, edge, outgoing, omega, time_step)
                              .topRows(travelling_count(outgoing)),
                          outgoing);
}

}  // namespace nmbcgen
