// SPDX-License-Identifier: MIT
/// The convex kernel approximation at the end of a chain (Wu 2015).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nmbc/edge_closure.hpp>
#include <nmbc/lattice.hpp>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace nmbc {

namespace detail {

/// The cubic spline window, 0 from 1 on.
inline double cubic_spline(double z) {
    if (z >= 1) {
        return 0;
    }
    return z < 0.5 ? 2.0 / 3 - 4 * z * z * (1 - z) : 4 * (1 - z) * (1 - z) * (1 - z) / 3;
}

/// Psi_J(X_I) of the nodes J, I = 0 .. nodes-1, row by row, beside an end at X_0 = 0; dX = 1.
/// Psi_J = phi_J G_J / sum, phi_J the cubic spline of |X - X_J| / a_J, a_J = n + 1, but 3/2 of node
/// 0, and G_J = 1 + (2/pi) atan(lambda (X - X_J)), lambda(X) from sum_J Psi_J (X_J - X) = 0. At the
/// end itself they are 1 and 0, their limit.
inline std::vector<double> convex_kernels(std::size_t n, std::size_t nodes) {
    std::vector<double> kernels(nodes * nodes);
    kernels[0] = 1;
    for (std::size_t at = 1; at < nodes; ++at) {
        const std::size_t first = at > n ? at - n : 0;
        const std::size_t last = at + n;
        const auto value = [&](std::size_t node, double lambda) {
            const double distance = static_cast<double>(at) - static_cast<double>(node);
            const double radius = node == 0 ? 1.5 : static_cast<double>(n + 1);
            return cubic_spline(std::abs(distance) / radius) *
                   (1 + 2 / std::numbers::pi * std::atan(lambda * distance));
        };
        const auto moment = [&](double lambda) {  // falls with lambda
            double sum = 0;
            for (std::size_t node = first; node <= last; ++node) {
                sum += value(node, lambda) * (static_cast<double>(node) - static_cast<double>(at));
            }
            return sum;
        };
        double low = 0;
        double high = at > n ? 0 : 1;  // the neighbours there are lie on the right
        while (moment(high) > 0 && high > 0) {
            low = high;
            high *= 2;
        }
        for (double middle = (low + high) / 2; low < middle && middle < high;
             middle = (low + high) / 2) {
            (moment(middle) > 0 ? low : high) = middle;
        }
        double sum = 0;
        for (std::size_t node = first; node <= last; ++node) {
            sum += value(node, low);
        }
        for (std::size_t node = first; node <= std::min(last, nodes - 1); ++node) {
            kernels[node * nodes + at] = value(node, low) / sum;
        }
    }
    return kernels;
}

}  // namespace detail

/// Strains with the convex kernels in the place of the influence, (31) and (32): the bond from J to
/// I counts Psi_J(X_I), so that the outermost node is in no family but its own. Volumes are 1
/// throughout, by (25), which gives the outermost node the force of an even strain. The nodes next
/// to it have not: this is no method that passes the patch test.
/// Throws std::invalid_argument for a lattice that is not of correspondence with the influence of a
/// cubic spline of radius (n + 1) dX.
inline EdgeEnergy kernel_edge(const Lattice& lattice) {
    const detail::Correspondence own = detail::correspondence_of(lattice);
    const std::size_t n = own.strain.size();
    for (std::size_t k = 1; k <= n; ++k) {
        const auto spline = [&](std::size_t m) {
            return static_cast<double>(m) *
                   detail::cubic_spline(static_cast<double>(m) / static_cast<double>(n + 1));
        };
        constexpr double roundings = 1e-12;
        if (!(std::abs(own.strain[k - 1] * spline(1) - own.strain[0] * spline(k)) <= roundings)) {
            throw std::invalid_argument(
                "convex kernels continue the influence of a cubic spline of radius (n + 1) dX, "
                "such as 1 at n = 1, 15, 2 at n = 2 and 23, 8, 1 at n = 3");
        }
    }
    const std::size_t changed = 2 * n + 1;  // families of others are those of the interior
    const std::size_t reached = changed + n;
    const std::vector<double> kernels = detail::convex_kernels(n, reached);
    std::vector<detail::EdgeNode> nodes;
    for (std::size_t node = 0; node < changed; ++node) {
        std::vector<double> strain(node + n + 1);
        double shape = 0;
        for (std::size_t other = 0; other < strain.size(); ++other) {
            const double distance = static_cast<double>(other) - static_cast<double>(node);
            const double force = kernels[node * reached + other] * distance;
            strain[other] += force;
            strain[node] -= force;
            shape += force * distance;
        }
        for (double& entry : strain) {
            entry /= shape;
        }
        nodes.push_back({std::move(strain)});
    }
    return detail::edge_of(own, nodes);
}

}  // namespace nmbc
