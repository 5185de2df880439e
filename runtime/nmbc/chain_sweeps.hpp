// SPDX-License-Identifier: MIT
/// The sweeps of a time step over the nodes of a chain, made for compilers to vectorise.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <nmbc/sweep.hpp>
#include <span>
#include <utility>
#include <vector>

namespace nmbc::detail {

/// constants[0] w_I + sum_{m >= 1} constants[m] (w_{I-m} - 2 w_I + w_{I+m}), node: w_I.
///
/// With differences, rest stays rest whatever the constants are rounded to. In the form
/// sum_m k_m w_{I+m} the k_m of floats do not add up to 0, and a chain at rest away from u = 0
/// moves off within some thousand steps.
///
/// The sum begins with a 0 that compilers may not drop (the sum could be -0): so every product has
/// one addition that it can be contracted with, and all loops that this is inlined into round
/// alike, with -ffp-contract or without.
template <class Real, std::size_t Reach>
class FixedReachStencil {
  public:
    explicit FixedReachStencil(std::span<const Real> constants) {
        std::ranges::copy(constants, constants_.begin());
    }

    static constexpr std::size_t reach() { return Reach; }

    Real operator()(const Real* node) const { return sum(node, std::make_index_sequence<Reach>{}); }

  private:
    template <std::size_t... M>
    Real sum(const Real* node, std::index_sequence<M...> /*unrolled*/) const {
        Real result = 0;
        result += constants_[0] * node[0];
        const Real twice = node[0] + node[0];
        ((result +=
          constants_[M + 1] * ((node[M + 1] + node[-1 - static_cast<std::ptrdiff_t>(M)]) - twice)),
         ...);
        return result;
    }

    std::array<Real, Reach + 1> constants_;
};

/// The same for a reach that is not known to the compiler. The constants are the caller's.
template <class Real>
class AnyReachStencil {
  public:
    explicit AnyReachStencil(std::span<const Real> constants) : constants_(constants) {}

    std::size_t reach() const { return constants_.size() - 1; }

    Real operator()(const Real* node) const {
        Real result = 0;
        result += constants_[0] * node[0];
        const Real twice = node[0] + node[0];
        for (std::size_t m = 1; m < constants_.size(); ++m) {
            result += constants_[m] * ((node[m] + node[-static_cast<std::ptrdiff_t>(m)]) - twice);
        }
        return result;
    }

  private:
    std::span<const Real> constants_;
};

/// Where the second of two fields of so many nodes begins, in entries from the first: half a page
/// and whole pages on. Processors take a load for one of what was just stored whole pages away,
/// and wait.
template <class Real>
std::size_t second_field(std::size_t nodes) {
    constexpr std::size_t page = 4096 / sizeof(Real);
    return (nodes + page / 2 - 1) / page * page + page / 2;
}

/// Nodes of a block that is drifted and then kicked: in a cache of first level, and short enough
/// for a processor to fetch the next one from memory while it works on this one.
inline constexpr std::size_t block_nodes = 192;

/// v += S u on the nodes first .. last-1. The stencil comes by value, so that no v can be its.
template <class Real, class Stencil>
void kick_nodes(Stencil stencil, const Real* __restrict u, Real* __restrict v, std::size_t first,
                std::size_t last) {
    for (std::size_t node = first; node < last; ++node) {
        v[node] += stencil(u + node);
    }
}

/// u += dt v on all nodes.
template <class Real>
void drift(Real dt, std::span<Real> u, std::span<const Real> v) {
    for_each_piece(u.size(), pieces_of(u.size()), [&](std::size_t first, std::size_t last) {
        drift_nodes(dt, u.data(), v.data(), first, last);
    });
}

/// What a stencil S does in a time step. u and v have all nodes, at least one of them further than
/// the reach from both ends.
template <class Real>
class Kick {
  public:
    Kick() = default;
    Kick(const Kick&) = delete;
    Kick& operator=(const Kick&) = delete;
    Kick(Kick&&) = delete;
    Kick& operator=(Kick&&) = delete;
    virtual ~Kick() = default;

    /// v += S u on all nodes but the outermost `reach` at each end.
    virtual void kick(std::span<const Real> u, std::span<Real> v) const = 0;

    /// u += dt v on all nodes and then v += S u, with the same result bit for bit as drift() and
    /// kick(), in one sweep over memory.
    virtual void drift_and_kick(Real dt, std::span<Real> u, std::span<Real> v) const = 0;
};

template <class Real, class Stencil>
class KickBy final : public Kick<Real> {
  public:
    explicit KickBy(std::vector<Real> constants)
        : constants_(std::move(constants)), stencil_(constants_) {}

    void kick(std::span<const Real> u, std::span<Real> v) const override {
        const std::size_t inner = u.size() - 2 * reach();
        for_each_piece(inner, pieces_of(inner), [&](std::size_t first, std::size_t last) {
            kick_nodes(stencil_, u.data(), v.data(), reach() + first, reach() + last);
        });
    }

    void drift_and_kick(Real dt, std::span<Real> u, std::span<Real> v) const override {
        const std::size_t nodes = u.size();
        // Every piece is to hold the stencil of one node at least.
        const std::size_t pieces =
            std::clamp<std::size_t>(nodes / (2 * reach() + 1), 1, pieces_of(nodes));
        for_each_piece(nodes, pieces, [&](std::size_t first, std::size_t last) {
            drift_and_kick_piece(dt, u.data(), v.data(), first, last);
        });
        // The nodes next to a seam need both pieces drifted.
        for_each_piece(nodes, pieces, [&](std::size_t first, std::size_t /*last*/) {
            if (first > 0) {
                kick_nodes(stencil_, u.data(), v.data(), first - reach(), first + reach());
            }
        });
    }

  private:
    std::size_t reach() const { return stencil_.reach(); }

    /// Drifts the nodes first .. last-1 and kicks those of them that need no other u, block by
    /// block: the drift goes ahead by the reach.
    void drift_and_kick_piece(Real dt, Real* u, Real* v, std::size_t first,
                              std::size_t last) const {
        const std::size_t block = std::max(block_nodes, 2 * reach());
        std::size_t kicked = first + reach();
        for (std::size_t drifted = first; drifted < last;) {
            const std::size_t next = std::min(drifted + block, last);
            drift_nodes(dt, u, v, drifted, next);
            kick_nodes(stencil_, u, v, kicked, next - reach());
            drifted = next;
            kicked = next - reach();
        }
    }

    std::vector<Real> constants_;
    Stencil stencil_;
};

/// The reaches that have a loop of their own: horizons to 6.
inline constexpr std::size_t widest_fixed_reach = 12;

template <class Real, std::size_t Reach = 1>
std::unique_ptr<const Kick<Real>> make_kick_of(std::vector<Real> constants) {
    if constexpr (Reach > widest_fixed_reach) {
        return std::make_unique<KickBy<Real, AnyReachStencil<Real>>>(std::move(constants));
    } else if (constants.size() == Reach + 1) {
        return std::make_unique<KickBy<Real, FixedReachStencil<Real, Reach>>>(std::move(constants));
    } else {
        return make_kick_of<Real, Reach + 1>(std::move(constants));
    }
}

/// v_I += factor * sum_m symbol[|m|] u_{I+m}, of a symbol as Lattice has them. The factor is
/// multiplied in here, once.
template <class Real>
std::unique_ptr<const Kick<Real>> make_kick(std::span<const double> symbol, double factor) {
    std::vector<Real> constants;
    constants.reserve(symbol.size());
    double own = symbol[0];  // what is left of u_I beside the differences: omega^2 at xi = 0
    for (const double neighbour : symbol.subspan(1)) {
        own += 2 * neighbour;
    }
    constants.push_back(static_cast<Real>(factor * own));
    for (const double neighbour : symbol.subspan(1)) {
        constants.push_back(static_cast<Real>(factor * neighbour));
    }
    return make_kick_of<Real>(std::move(constants));
}

}  // namespace nmbc::detail
