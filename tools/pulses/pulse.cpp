// SPDX-License-Identifier: MIT
#include "tools/pulses/pulse.hpp"

#include <cmath>
#include <nmbc/coefficients.hpp>
#include <nmbc/ends.hpp>
#include <nmbc/energy.hpp>
#include <numbers>
#include <vector>

namespace pulses {
namespace {

std::size_t steps_in(double duration, double time_step) {
    return static_cast<std::size_t>(std::ceil(duration / time_step));
}

}  // namespace

double energy_left(nmbc::Chain& chain, double half_width, double duration) {
    std::vector<double> u(chain.nodes());
    const double middle = (static_cast<double>(chain.nodes()) - 1) / 2;
    for (std::size_t node = 0; node < u.size(); ++node) {
        const double x = (static_cast<double>(node) - middle) / half_width;
        u[node] = std::exp(-x * x);
    }
    chain.start(u, std::vector<double>(chain.nodes()));

    const std::size_t first = (chain.parameters().nodes - counted_nodes) / 2;
    const auto energy = [&] { return nmbc::energies(chain, first, first + counted_nodes).total(); };
    const double start = energy();
    chain.advance(steps_in(duration, chain.parameters().time_step));
    return energy() / start;
}

double left_between_ends(const nmbc::MatchingTable& table, double G, double time_step,
                         double half_width) {
    nmbc::Chain chain(nmbc::make_lattice(table, G),
                      nmbc::MatchingEnd{nmbc::boundary_coefficients(table, G)},
                      {.nodes = counted_nodes, .time_step = time_step});
    return energy_left(chain, half_width);
}

double left_in_long_chain(const nmbc::Lattice& lattice, double time_step, double half_width) {
    // In a step, what a node does is felt `reach` nodes away and no further. From the middle to an
    // end and back to the counted nodes it takes longer than the run; twelve half-widths out, the
    // pulse is less than roundings, exp(-144).
    const auto tail = static_cast<std::size_t>(std::ceil(12 * half_width));
    const std::size_t nodes =
        counted_nodes + lattice.reach() * steps_in(end_time, time_step) + 2 * tail;
    nmbc::Chain chain(lattice, nmbc::FixedEnd{}, nmbc::FixedEnd{},
                      {.nodes = nodes + nodes % 2, .time_step = time_step});
    return energy_left(chain, half_width);
}

double loss(const nmbc::Lattice& lattice, double wavelength, double wavelengths) {
    if (lattice.damping.empty()) {
        return 0;
    }
    const double xi = 2 * std::numbers::pi / wavelength;
    double slope = 0;  // of omega^2
    for (std::size_t m = 1; m < lattice.symbol.size(); ++m) {
        const auto distance = static_cast<double>(m);
        slope -= 2 * distance * lattice.symbol[m] * std::sin(distance * xi);
    }
    const double group_velocity = slope / (2 * std::sqrt(nmbc::omega_squared(lattice, xi)));
    // The energy falls at the rate tau sigma. The generator knows the same as
    // loss_per_wavelength(), under a licence that the runtime's tools do not share.
    const double rate = nmbc::detail::symbol_at(lattice.damping, xi);
    return -std::expm1(-rate * wavelengths * wavelength / group_velocity);
}

}  // namespace pulses
