// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/sides/truncated.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace nmbcrun {
namespace {

using Field = nmbc::NodeLine<double>;
using Fixed = nmbc::NodeLine<const double>;
using Square = nmbc::Lattice::Square;

/// A square's entries on offsets -n .. n from its node.
using Stencil = std::vector<double>;

/// The strain of a node whose family is the offsets first .. n.
Stencil strain_of(int first, int n) {
    double shape = 0;
    for (int j = first; j <= n; ++j) {
        shape += j * j;
    }
    Stencil strain(std::size_t(2 * n + 1));
    for (int j = first; j <= n; ++j) {
        strain[std::size_t(n + j)] += j / shape;
        strain[std::size_t(n)] -= j / shape;
    }
    return strain;
}

/// All squares of such a node.
std::vector<Square> squares_of(int first, int n, double G) {
    const Stencil strain = strain_of(first, n);
    std::vector<Square> squares{{nmbc::EnergyPart::strain, 1, strain}};
    for (int bond = first; bond <= n && G > 0; ++bond) {
        if (bond == 0) {
            continue;
        }
        Stencil state(strain.size());
        std::ranges::transform(strain, state.begin(), [&](double entry) { return -bond * entry; });
        state[std::size_t(n + bond)] += 1;
        state[std::size_t(n)] -= 1;
        squares.push_back({nmbc::EnergyPart::stabilisation, 2 * G / (n * n * n * double(n - first)),
                           std::move(state)});
    }
    return squares;
}

/// G of nopd1d of constant influence with this n. Throws std::invalid_argument for another lattice.
double stabilisation_of(const nmbc::Lattice& lattice, int n) {
    double G = 0;
    for (const Square& square : lattice.energy) {
        if (square.part == nmbc::EnergyPart::stabilisation) {
            G = square.weight * std::pow(n, 4);
        }
    }
    const auto alike = [](double a, double b) {
        return std::abs(a - b) <= 1e-14 * std::abs(a) + 1e-15;
    };
    const auto squares = squares_of(-n, n, G);
    const bool known = lattice.reach() == std::size_t(2 * n) &&
                       std::ranges::is_permutation(
                           squares, lattice.energy, [&](const Square& one, const Square& other) {
                               return one.part == other.part && alike(one.weight, other.weight) &&
                                      std::ranges::equal(one.stencil, other.stencil, alike);
                           });
    if (!known || !lattice.damping.empty()) {
        throw std::invalid_argument(
            "a truncated end knows nopd1d of constant influence without damping, no other lattice");
    }
    return G;
}

class MbcCondition final : public nmbc::BoundaryCondition<double> {
  public:
    MbcCondition(const nmbc::BoundaryCoefficients& coefficients, nmbc::GhostRule rule,
                 const nmbc::Lattice& lattice, const nmbc::ChainParameters& p)
        : n_(lattice.reach() / 2),
          boundary_(coefficients, {lattice.reach(), p.wave_speed(), p.spacing, p.time_step}, rule),
          corrections_(n_, std::vector<double>(3 * n_)) {
        const double rate = p.wave_speed() / p.spacing;
        const int n = int(n_);
        const double G = stabilisation_of(lattice, n);
        for (int ghost = 0; ghost < n; ++ghost) {
            add(ghost, squares_of(-ghost, n, G), -p.time_step * rate * rate);
            add(ghost, squares_of(-n, n, G), p.time_step * rate * rate);
        }
    }

    std::size_t least_interior_nodes() const override {
        return std::max(boundary_.reach() - boundary_.ghost_layers(), n_);
    }

    void start(Field u, Field v) override {
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
