// SPDX-License-Identifier: MIT
#include "tools/nmbcrun/ends/higdon.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <nmbc/higdon.hpp>
#include <stdexcept>
#include <vector>

namespace nmbcrun {

std::unique_ptr<nmbc::BoundaryCondition<double>> HigdonEnd::make(
    const nmbc::Lattice& lattice, const nmbc::ChainParameters& p,
    std::type_identity<double> /*precision*/) const {
    if (order < 1 || order > highest_order) {
        throw std::invalid_argument(
            fmt::format("the order of a higdon end is 1 to {}, not {}", highest_order, order));
    }
    const std::vector<double> courants(std::size_t(order),
                                       p.time_step * p.wave_speed() / p.spacing);
    return std::make_unique<nmbc::HigdonCondition<double>>(lattice.reach(), courants, 0.0,
                                                           p.time_step);
}

}  // namespace nmbcrun
