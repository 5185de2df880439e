// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/prediction/layer_reflection.hpp"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <nmbc/loss_layer.hpp>
#include <utility>
#include <vector>

#include "generator/stability/modes.hpp"

namespace nmbcrun {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::SparseMatrix<Complex>;
using nmbcgen::Mode;

/// Nodes are counted from the innermost of the layer, -1, outwards to -layer, and from the
/// outermost of the interior, 0, inwards. Units dX = c = 1.
class LayerOfWaves {
  public:
    LayerOfWaves(const nmbc::Lattice& lattice, nmbcgen::HalfSpace half_space,
                 const Boundary& boundary)
        : symbol_(lattice.symbol),
          half_space_(std::move(half_space)),
          modes_(half_space_),
          is_matched_(boundary.kind == BoundaryKind::pml),
          layer_(std::ptrdiff_t(boundary.layer)),
          losses_(nmbc::half_step_losses({boundary.layer, boundary.profile, target_of(boundary)},
                                         is_matched_ ? 0.5 : 1,
                                         {.time_step = half_space_.time_step})) {
        if (is_matched_) {
            squares_ = squares_about_a_node(lattice);
        }
    }

    /// Not from two threads at a time.
    double energy_sent_back(double xi);

  private:
    /// How far a node's force comes from.
    std::ptrdiff_t reach() const {
        return std::max(std::ptrdiff_t(symbol_.size()) - 1, squares_.rows() - 1);
    }
    double loss_at(std::ptrdiff_t node) const {
        return node >= 0 ? 0 : losses_[std::size_t(std::min(-node - 1, layer_))];
    }
    static Eigen::MatrixXd squares_about_a_node(const nmbc::Lattice& lattice);
    /// slow: (z + 1)/(z - 1), z = exp(i theta).
    Complex stretched_force(std::ptrdiff_t node, std::ptrdiff_t other, Complex slow) const;
    Complex force(std::ptrdiff_t node, std::ptrdiff_t other, Complex slow) const;

    std::vector<double> symbol_;
    nmbcgen::HalfSpace half_space_;
    nmbcgen::OutgoingModes modes_;
    bool is_matched_;
    std::ptrdiff_t layer_;
    std::vector<double> losses_;
    Eigen::MatrixXd squares_{};
};

/// The second derivatives of the energy of all squares about one node by u of it and of its
/// neighbours, in order.
Eigen::MatrixXd LayerOfWaves::squares_about_a_node(const nmbc::Lattice& lattice) {
    Eigen::Index largest = 0;
    for (const nmbc::Lattice::Square& square : lattice.energy) {
        largest = std::max(largest, Eigen::Index(square.stencil.size()));
    }
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(largest, largest);
    for (const nmbc::Lattice::Square& square : lattice.energy) {
        const auto size = Eigen::Index(square.stencil.size());
        const Eigen::Map<const Eigen::VectorXd> stencil(square.stencil.data(), size);
        const Eigen::Index first = largest / 2 - size / 2;
        sum.block(first, first, size, size) += square.weight * stencil * stencil.transpose();
    }
    return sum;
}

Complex LayerOfWaves::stretched_force(std::ptrdiff_t node, std::ptrdiff_t other,
                                      Complex slow) const {
    const std::ptrdiff_t half = squares_.rows() / 2;
    Complex sum = 0;
    for (std::ptrdiff_t about = std::max(node, other) - half; about <= std::min(node, other) + half;
         ++about) {
        sum += squares_(node - about + half, other - about + half) / (1.0 + loss_at(about) * slow);
    }
    return sum;
}

/// The part of u of the other node in the force on this one, times -1.
Complex LayerOfWaves::force(std::ptrdiff_t node, std::ptrdiff_t other, Complex slow) const {
    if (is_matched_) {
        return stretched_force(node, other, slow);
    }
    const auto distance = std::size_t(std::abs(node - other));
    return distance < symbol_.size() ? symbol_[distance] : 0;
}

double LayerOfWaves::energy_sent_back(double xi) {
    const double square = nmbcgen::omega_squared(half_space_, xi);
    if (!(square > 0)) {
        return 1;  // it stands still: as much as can come back
    }
    const double omega = std::sqrt(square);
    const double step = half_space_.time_step;
    const double half_angle = std::asin(std::min(omega * step / 2, 1.0));
    const Complex slow(0, -1 / std::tan(half_angle));
    const std::vector<Mode> outgoing = modes_.at(omega);
    // What comes in is the mirror image of the one whose wave number is next to xi.
    const Mode& image = *std::ranges::min_element(outgoing, {}, [xi](const Mode& mode) {
        return mode.travels() ? std::abs(std::abs(std::arg(mode.k)) - xi) : 10;
    });
    if (!image.travels()) {
        return 1;  // it stands still, too
    }
    // As many as the lattice reaches, or fewer where it happens to reach less far at its G.
    const auto waves = std::ptrdiff_t(outgoing.size());
    const Eigen::Index unknowns = layer_ + waves;
    std::vector<Eigen::Triplet<Complex>> entries;
    Eigen::VectorXcd sources = Eigen::VectorXcd::Zero(unknowns);
    // The unknowns are u of the layer's nodes and the amplitudes of the outgoing waves.
    const auto add = [&](std::ptrdiff_t node, std::ptrdiff_t other, Complex factor) {
        if (node < -layer_ || node >= waves || other < -layer_) {
            return;  // ghosts, which are fixed, and nodes whose equations the waves solve
        }
        const Eigen::Index row = node + layer_;
        if (other < 0) {
            entries.emplace_back(row, other + layer_, factor);
            return;
        }
        sources[row] -= factor * std::pow(image.k, -double(other));
        for (std::size_t o = 0; o < outgoing.size(); ++o) {
            entries.emplace_back(row, layer_ + Eigen::Index(o),
                                 factor * std::pow(outgoing[o].k, double(other)));
        }
    };
    for (std::ptrdiff_t node = -layer_; node < waves; ++node) {
        const Complex friction(0, 2 * loss_at(node) * std::sin(2 * half_angle) / (step * step));
        add(node, node, friction - omega * omega);
        for (std::ptrdiff_t other = node - reach(); other <= node + reach(); ++other) {
            add(node, other, force(node, other, slow));
        }
    }
    Matrix matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    // In their own order the equations are a band.
    const Eigen::SparseLU<Matrix, Eigen::NaturalOrdering<int>> solver(matrix);
    if (solver.info() != Eigen::Success) {
        return 1;  // waves that cannot be told apart
    }
    const Eigen::VectorXcd found = solver.solve(sources);
    double energy = 0;
    for (std::size_t o = 0; o < outgoing.size(); ++o) {
        energy += std::norm(found[layer_ + Eigen::Index(o)]) *
                  std::abs(outgoing[o].group_velocity / image.group_velocity);
    }
    // A layer adds no energy. Where modes merge, roundings of a matrix that is nearly singular may,
    // or what comes is not a number.
    return energy < 1 ? energy : 1;
}

}  // namespace

std::size_t widest_told_layer(const nmbc::Lattice& lattice) {
    constexpr double most_work = 1e5;  // some milliseconds a wave
    const auto reach = double(lattice.reach());
    return std::size_t(std::min(400.0, most_work / (reach * reach)));
}

std::function<double(double xi)> energy_sent_back_by_layer(const nmbc::Lattice& lattice,
                                                           nmbcgen::HalfSpace half_space,
                                                           const Boundary& boundary) {
    const auto layer = std::make_shared<LayerOfWaves>(lattice, std::move(half_space), boundary);
    return [layer](double xi) { return layer->energy_sent_back(xi); };
}

}  // namespace nmbcrun
