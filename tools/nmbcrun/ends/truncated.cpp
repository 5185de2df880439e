// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/truncated.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tools/nmbcrun/ends/cut_families.hpp"

namespace nmbcrun {
namespace {

using Field = nmbc::NodeLine<double>;
using Fixed = nmbc::NodeLine<const double>;
using Square = nmbc::Lattice::Square;

class MbcCondition final : public nmbc::BoundaryCondition<double> {
  public:
    MbcCondition(const nmbc::BoundaryCoefficients& coefficients, nmbc::GhostRule rule,
                 const nmbc::Lattice& lattice, const nmbc::ChainParameters& p)
        : n_(lattice.reach() / 2),
          boundary_(coefficients,
                    {.ghost_layers = lattice.reach(),
                     .wave_speed = p.wave_speed(),
                     .spacing = p.spacing,
                     .time_step = p.time_step},
                    rule),
          corrections_(n_, std::vector<double>(3 * n_)) {
        const double rate = p.wave_speed() / p.spacing;
        const int n = int(n_);
        const double G = stabilisation_of(lattice);
        for (int ghost = 0; ghost < n; ++ghost) {
            add(ghost, squares_of(-ghost, n, G), -p.time_step * rate * rate);
            add(ghost, squares_of(-n, n, G), p.time_step * rate * rate);
        }
    }

    std::size_t least_interior_nodes() const override {
        return std::max(boundary_.reach() - boundary_.ghost_layers(), n_);
    }

    void start(Field u, Field v, std::size_t /*step*/) override {
        for (std::size_t unused = 0; unused < n_; ++unused) {
            u[unused] = 0;
            v[unused] = 0;
        }
    }

    void after_kick(Fixed u, Field v, std::size_t /*step*/) override {
        for (std::size_t row = 0; row < n_; ++row) {
            for (std::size_t node = 0; node < 3 * n_; ++node) {
                v[2 * n_ + row] += corrections_[row][node] * u[node];
            }
        }
        boundary_.update(u, v);
        for (std::size_t unused = 0; unused < n_; ++unused) {
            v[unused] = 0;
        }
    }

  private:
    /// Adds factor sum w L^T L of the squares at one ghost node, counted from the outermost that
    /// exists, to the velocities of the interior nodes that it reaches.
    void add(int ghost, const std::vector<Square>& squares, double factor) {
        for (const Square& square : squares) {
            for (std::size_t i = 2 * n_ - std::size_t(ghost); i < square.stencil.size(); ++i) {
                const std::size_t row = std::size_t(ghost) + i - 2 * n_;
                for (std::size_t j = 0; j < square.stencil.size(); ++j) {
                    corrections_[row][std::size_t(ghost) + j] +=
                        factor * square.weight * square.stencil[i] * square.stencil[j];
                }
            }
        }
    }

    std::size_t n_;
    nmbc::MatchingBoundary boundary_;
    std::vector<std::vector<double>> corrections_;  // by interior node, of u from the outermost in
};

}  // namespace

std::unique_ptr<nmbc::BoundaryCondition<double>> TruncatedEnd::make(
    const nmbc::Lattice& lattice, const nmbc::ChainParameters& parameters,
    std::type_identity<double> /*precision*/) const {
    return std::make_unique<MbcCondition>(coefficients, ghost_rule, lattice, parameters);
}

}  // namespace nmbcrun
