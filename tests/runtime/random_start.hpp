// SPDX-License-Identifier: GPL-2.0-or-later
/// Random states for the tests of the runtime.
#pragma once

#include <algorithm>
#include <nmbc/chain.hpp>
#include <random>
#include <vector>

template <class Real>
void start_at_random(nmbc::BasicChain<Real>& chain) {
    std::mt19937_64 random(20180417);
    std::normal_distribution<Real> normal;
    std::vector<Real> u(chain.nodes());
    std::vector<Real> v(chain.nodes());
    for (auto* values : {&u, &v}) {
        std::ranges::generate(*values, [&] { return normal(random); });
    }
    chain.start(u, v);
}
