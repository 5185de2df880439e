// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/simulation/ledger.hpp"

#include <algorithm>
#include <nmbc/energy.hpp>

namespace nmbcrun {
namespace {

/// Without the zeros at both ends, of which squares that are not their own mirror image have some:
/// so none reaches beyond the ghosts.
void trim(std::vector<double>& stencil) {
    const auto is_there = [](double entry) { return entry != 0; };
    stencil.erase(std::find_if(stencil.rbegin(), stencil.rend(), is_there).base(), stencil.end());
    stencil.erase(stencil.begin(), std::ranges::find_if(stencil, is_there));
}

}  // namespace

Ledger::Ledger(const nmbc::Chain& chain)
    : squares_(chain.lattice().energy),
      begin_(chain.first_interior()),
      end_(begin_ + chain.parameters().nodes),
      mass_(chain.parameters().density * chain.parameters().spacing),
      time_step_(chain.parameters().time_step),
      old_(chain.velocity().begin(), chain.velocity().end()),
      kicked_(old_) {
    for (nmbc::Lattice::Square& square : squares_) {
        square.weight *= chain.parameters().youngs_modulus / chain.parameters().spacing;
        trim(square.stencil);
    }
    totals_.start = energy(chain.displacement(), chain.velocity());
}

void Ledger::resume(const nmbc::Chain& chain, const Totals& totals) {
    std::ranges::copy(chain.velocity(), old_.begin());
    totals_ = totals;
}

Balance Ledger::balance(const nmbc::Chain& chain) const {
    const auto [start, work, left, right] = totals_;
    double damped = 0;
    if (!chain.damped().empty()) {
        for (const double at_node : chain.damped().subspan(begin_, end_ - begin_)) {
            damped += at_node;
        }
    }
    const double now = energy(chain.displacement(), chain.velocity());
    return {now, work, left, right, now - (start + work - left - right - damped)};
}

void Ledger::keep_kicked(std::span<const double> v) {
    std::copy(&v[begin_], &v[begin_] + (end_ - begin_), &kicked_[begin_]);
}

void Ledger::find_driven(std::span<const double> v) {
    driven_.clear();
    for (std::size_t node = begin_; node < end_; ++node) {
        if (v[node] != kicked_[node]) {
            driven_.push_back({node, v[node] - kicked_[node]});
            kicked_[node] = v[node];
        }
    }
}

void Ledger::enter(std::span<const double> u, std::span<const double> v) {
    const auto gained = [&](std::size_t node, double change) {
        return mass_ * (v[node] + old_[node]) / 2 * change;
    };
    double work = 0;
    for (const auto& [node, change] : driven_) {
        work += gained(node, change);
    }
    totals_.work += work;

    const double half = time_step_ / 2;
    double left = half * power(u, v, begin_, 0, begin_);
    double right = half * power(u, v, end_, end_, v.size());
    for (std::size_t node = begin_; node < end_; ++node) {
        if (v[node] != kicked_[node]) {  // an end has corrected it
            (node - begin_ < end_ - 1 - node ? left : right) +=
                gained(node, v[node] - kicked_[node]);
        }
    }
    totals_.left -= left;
    totals_.right -= right;
    std::ranges::copy(v, old_.begin());
}

double Ledger::power(std::span<const double> u, std::span<const double> v, std::size_t edge,
                     std::size_t first, std::size_t last) const {
    double sum = 0;
    for (const auto& [part, weight, stencil] : squares_) {
        for (std::size_t from = edge + 1 - stencil.size(); from < edge; ++from) {
            const std::size_t to = from + stencil.size();
            double outside = 0;
            for (std::size_t i = std::max(from, first); i < std::min(to, last); ++i) {
                outside += stencil[i - from] * (v[i] + old_[i]);
            }
            sum +=
                weight * outside * nmbc::detail::apply(std::span<const double>(stencil), &u[from]);
        }
    }
    return sum;
}

double Ledger::energy(std::span<const double> u, std::span<const double> v) const {
    double kinetic = 0;
    for (std::size_t node = begin_; node < end_; ++node) {
        kinetic += mass_ * v[node] * v[node] / 2;
    }
    double potential = 0;
    for (const auto& [part, weight, stencil] : squares_) {
        for (std::size_t from = begin_ + 1 - stencil.size(); from < end_; ++from) {
            const double now = nmbc::detail::apply(std::span<const double>(stencil), &u[from]);
            const double rate = nmbc::detail::apply(std::span<const double>(stencil), &v[from]);
            potential += weight / 2 * now * (now - time_step_ * rate);
        }
    }
    return kinetic + potential;
}

}  // namespace nmbcrun
