// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/ledger.hpp"

#include <algorithm>
#include <set>

namespace nmbcrun {
namespace {

/// Over that of an interior node.
double mass_of(const nmbc::Chain& chain, std::size_t node) {
    const std::size_t from_left = node - chain.first_interior();
    const std::size_t from_right = chain.parameters().nodes - 1 - from_left;
    for (const auto& [end, depth] :
         {std::pair(nmbc::End::left, from_left), std::pair(nmbc::End::right, from_right)}) {
        const nmbc::EdgeEnergy* const edge = chain.edge_energy(end);
        if (edge != nullptr && depth < edge->mass.size()) {
            return edge->mass[depth];
        }
    }
    return 1;
}

}  // namespace

Ledger::Ledger(const nmbc::Chain& chain, std::span<const std::size_t> driven)
    : begin_(chain.first_interior()),
      end_(begin_ + chain.parameters().nodes),
      mass_(chain.parameters().density * chain.parameters().spacing),
      time_step_(chain.parameters().time_step) {
    const auto is_there = [](double entry) { return entry != 0; };
    for (const auto& [part, weight, stencil] : chain.lattice().energy) {
        const auto first = std::ranges::find_if(stencil, is_there);
        const auto last = std::find_if(stencil.rbegin(), stencil.rend(), is_there).base();
        const auto middle = stencil.begin() + std::ptrdiff_t(stencil.size() / 2);
        const double unit = chain.parameters().youngs_modulus / chain.parameters().spacing;
        squares_.push_back({weight * unit, {first, last}, std::size_t(middle - first)});
    }
    watch(chain, driven);
    // Beyond an edge with an energy of its own there is nothing.
    left_ = chain.edge_energy(nmbc::End::left) == nullptr ? edge_at(begin_, true) : Edge{};
    right_ = chain.edge_energy(nmbc::End::right) == nullptr ? edge_at(end_, false) : Edge{};
    keep_old(chain.velocity());
    totals_.start = energy(chain, nmbc::energies(chain));
}

void Ledger::watch(const nmbc::Chain& chain, std::span<const std::size_t> driven) {
    std::set<std::size_t> nodes;
    for (const std::size_t node : driven) {
        nodes.insert(begin_ + node);
    }
    for (std::size_t i = 0; i < chain.nodes_changed_by(nmbc::End::left); ++i) {
        nodes.insert(begin_ + i);
    }
    for (std::size_t i = 0; i < chain.nodes_changed_by(nmbc::End::right); ++i) {
        nodes.insert(end_ - 1 - i);
    }
    for (const std::size_t node : nodes) {
        watched_.push_back({.node = node, .mass = mass_of(chain, node), .old = 0});
    }
}

Ledger::Edge Ledger::edge_at(std::size_t edge, bool is_left) const {
    std::size_t reach = 0;
    for (const Square& square : squares_) {
        reach = std::max(reach, square.stencil.size() - 1);
    }
    Edge result{.outside = is_left ? edge - reach : edge,
                .first = edge - reach,
                .old = std::vector<double>(reach),
                .stiffness = std::vector<double>(reach * 2 * reach)};
    for (const auto& [weight, stencil, before] : squares_) {
        for (std::size_t from = edge + 1 - stencil.size(); from < edge; ++from) {
            for (std::size_t i = 0; i < stencil.size(); ++i) {
                if ((from + i < edge) != is_left) {
                    continue;
                }
                const std::size_t row = from + i - result.outside;
                for (std::size_t j = 0; j < stencil.size(); ++j) {
                    result.stiffness[row * 2 * reach + from + j - result.first] +=
                        weight * stencil[i] * stencil[j];
                }
            }
        }
    }
    return result;
}

void Ledger::resume(const nmbc::Chain& chain, const Totals& totals) {
    keep_old(chain.velocity());
    totals_ = totals;
}

void Ledger::keep_old(std::span<const double> v) {
    for (Watched& watched : watched_) {
        watched.old = v[watched.node];
    }
    for (Edge* const edge : {&left_, &right_}) {
        std::ranges::copy(v.subspan(edge->outside, edge->old.size()), edge->old.begin());
    }
}

Balance Ledger::balance(const nmbc::Chain& chain, const nmbc::Energies& energies) const {
    const auto [start, work, left, right] = totals_;
    const double now = energy(chain, energies);
    return {now, work, left, right, now - (start + work - left - right - energies.damped)};
}

void Ledger::keep_kicked(std::span<const double> v) {
    for (Watched& watched : watched_) {
        watched.kicked = v[watched.node];
    }
}

void Ledger::find_driven(std::span<const double> v) {
    for (Watched& watched : watched_) {
        watched.driven = v[watched.node] - watched.kicked;
        watched.kicked = v[watched.node];
    }
}

void Ledger::enter(std::span<const double> u, std::span<const double> v) {
    double work = 0;
    double left = time_step_ / 2 * power(left_, u, v);
    double right = time_step_ / 2 * power(right_, u, v);
    for (const auto& [node, mass, old, kicked, driven] : watched_) {
        const double path = mass_ * mass * (v[node] + old) / 2;
        work += path * driven;
        // What an end has corrected:
        (node - begin_ < end_ - 1 - node ? left : right) += path * (v[node] - kicked);
    }
    totals_.work += work;
    totals_.left -= left;
    totals_.right -= right;
    keep_old(v);
}

double Ledger::power(const Edge& edge, std::span<const double> u, std::span<const double> v) {
    const std::size_t reach = edge.old.size();
    const double* entry = edge.stiffness.data();
    double sum = 0;
    for (std::size_t row = 0; row < reach; ++row) {
        // Of differences, or the roundings would be those of how far the whole has moved: the
        // entries of a row add up to 0, as a lattice that is moved as a whole has no forces.
        const double own = u[edge.outside + row];
        double force = 0;
        for (std::size_t j = 0; j < 2 * reach; ++j) {
            force += *entry++ * (u[edge.first + j] - own);
        }
        sum += force * (v[edge.outside + row] + edge.old[row]);
    }
    return sum;
}

double Ledger::energy(const nmbc::Chain& chain, const nmbc::Energies& energies) const {
    double outside = 0;
    for (const Square& square : squares_) {
        const std::span<const double> stencil(square.stencil);
        const auto add = [&](std::size_t from, std::size_t to) {
            for (; from < to; ++from) {
                const double now = nmbc::detail::apply(stencil, &chain.displacement()[from]);
                const double rate = nmbc::detail::apply(stencil, &chain.velocity()[from]);
                outside += square.weight / 2 * now * (now - time_step_ * rate);
            }
        };
        if (chain.edge_energy(nmbc::End::left) == nullptr) {
            add(begin_ + 1 - stencil.size(), begin_ - square.before);
        }
        if (chain.edge_energy(nmbc::End::right) == nullptr) {
            add(end_ - square.before, end_);
        }
    }
    return energies.staggered + outside;
}

}  // namespace nmbcrun
