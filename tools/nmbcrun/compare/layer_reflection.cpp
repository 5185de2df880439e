// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/compare/layer_reflection.hpp"

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
    LayerOfWaves(nmbc::Lattice lattice, nmbcgen::HalfSpace half_space, const Boundary& boundary)
        : lattice_(std::move(lattice)),
          half_space_(std::move(half_space)),
          is_matched_(boundary.kind == BoundaryKind::pml),
          layer_(std::ptrdiff_t(boundary.layer)),
          losses_(nmbc::half_step_losses({boundary.layer, boundary.profile, target_of(boundary)},
                                         is_matched_ ? 0.5 : 1,
                                         {.time_step = half_space_.time_step})) {}

    double energy_sent_back(double xi) const;

  private:
    std::ptrdiff_t reach() const { return std::ptrdiff_t(lattice_.reach()); }
    double loss_at(std::ptrdiff_t node) const {
        return node >= 0 ? 0 : losses_[std::size_t(std::min(-node - 1, layer_))];
    }
    /// Both call with pairs of nodes, all of which the first is in the layer or reaches into it
    /// among them, and with the second's part in the force on it. inner: the first node that does
    /// not. half_angle: theta/2.
    template <class Visit>
    void for_each_force(std::ptrdiff_t inner, Visit visit) const;
    template <class Visit>
    void for_each_stretched_force(std::ptrdiff_t inner, double half_angle, Visit visit) const;

    nmbc::Lattice lattice_;
    nmbcgen::HalfSpace half_space_;
    bool is_matched_;
    std::ptrdiff_t layer_;
    std::vector<double> losses_;
};

template <class Visit>
void LayerOfWaves::for_each_force(std::ptrdiff_t inner, Visit visit) const {
    for (std::ptrdiff_t node = -layer_; node < inner; ++node) {
        for (std::ptrdiff_t m = -reach(); m <= reach(); ++m) {
            visit(node, node + m, Complex(lattice_.symbol[std::size_t(std::abs(m))]));
        }
    }
}

template <class Visit>
void LayerOfWaves::for_each_stretched_force(std::ptrdiff_t inner, double half_angle,
                                            Visit visit) const {
    const Complex slow(0, -1 / std::tan(half_angle));  // (z + 1)/(z - 1)
    for (const nmbc::Lattice::Square& square : lattice_.energy) {
        const std::vector<double>& stencil = square.stencil;
        const auto size = std::ptrdiff_t(stencil.size());
        for (std::ptrdiff_t first = -layer_ - size; first < inner; ++first) {
            const Complex weight = square.weight / (1.0 + loss_at(first + size / 2) * slow);
            for (std::ptrdiff_t i = 0; i < size; ++i) {
                for (std::ptrdiff_t k = 0; k < size; ++k) {
                    visit(first + i, first + k,
                          weight * stencil[std::size_t(i)] * stencil[std::size_t(k)]);
                }
            }
        }
    }
}

double LayerOfWaves::energy_sent_back(double xi) const {
    const double omega = std::sqrt(std::max(nmbcgen::omega_squared(half_space_, xi), 0.0));
    const double step = half_space_.time_step;
    const double half_angle = std::asin(std::min(omega * step / 2, 1.0));
    const std::vector<Mode> outgoing = nmbcgen::outgoing_modes(half_space_, omega);
    // What comes in is the mirror image of the one whose wave number is next to xi.
    const Mode& image = *std::ranges::min_element(outgoing, {}, [xi](const Mode& mode) {
        return mode.travels() ? std::abs(std::abs(std::arg(mode.k)) - xi) : 10;
    });
    if (!image.travels()) {
        return 1;  // it stands still: as much as can come back
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
    }
    if (is_matched_) {
        for_each_stretched_force(waves, half_angle, add);
    } else {
        for_each_force(waves, add);
    }
    Matrix matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseLU<Matrix> solver(matrix);
    if (solver.info() != Eigen::Success) {
        return 1;  // waves that cannot be told apart
    }
    const Eigen::VectorXcd found = solver.solve(sources);
    double energy = 0;
    for (std::size_t o = 0; o < outgoing.size(); ++o) {
        energy += std::norm(found[layer_ + Eigen::Index(o)]) *
                  std::abs(outgoing[o].group_velocity / image.group_velocity);
    }
    return energy;
}

}  // namespace

std::function<double(double xi)> energy_sent_back_by_layer(const nmbc::Lattice& lattice,
                                                           nmbcgen::HalfSpace half_space,
                                                           const Boundary& boundary) {
    const auto layer =
        std::make_shared<const LayerOfWaves>(lattice, std::move(half_space), boundary);
    return [layer](double xi) { return layer->energy_sent_back(xi); };
}

}  // namespace nmbcrun
