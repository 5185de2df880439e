// SPDX-License-Identifier: MIT
/// The interior of a uniform chain: stencils, band edge and energy of a table's lattice model.
#pragma once

#include <algorithm>
#include <cmath>
#include <nmbc/certificate.hpp>
#include <nmbc/coefficients.hpp>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace nmbc {

/// A lattice at one G, in units dX = c = 1.
struct Lattice {
    /// One square of the energy, weight * (sum_i stencil[i] u_{I+i-r})^2 / 2, 2r+1 entries.
    struct Square {
        EnergyPart part;
        double weight;  ///< of strain it may be below 0, where bonds are
        std::vector<double> stencil;
    };
    std::vector<double> symbol;   ///< omega^2 = symbol[0] + 2 sum symbol[m] cos(m xi)
    std::vector<Square> energy;   ///< squares of zero weight left out
    std::vector<double> damping;  ///< tau sigma = damping[0] + 2 sum damping[m] cos(m xi); empty
                                  ///< where nothing is damped
    /// What it was made of, and at which G, for which boundaries are certified; nullptr: made by
    /// hand, and no boundary is certified for it. To change its numbers is to make it by hand, but
    /// for where its squares are counted.
    const LatticeTable* table = nullptr;
    double G = 0;

    /// Nodes the stencil reaches to each side; also the ghost layers an end needs.
    std::size_t reach() const { return symbol.size() - 1; }
};

/// The lattice at G >= 0. The table lasts as long as it. Throws std::invalid_argument for a bad G,
/// and where a square of stabilisation has a weight below 0 there.
inline Lattice make_lattice(const LatticeTable& table, double G) {
    Lattice lattice{evaluate(table.symbol, G), {}, evaluate(table.damping, 0), &table, G};
    for (const EnergySquare& square : table.energy) {
        const double weight = evaluate(square.weight, G);
        if (!std::isfinite(weight)) {
            throw std::invalid_argument("the squares of a lattice's energy need finite weights");
        }
        if (square.part == EnergyPart::stabilisation && weight < 0) {
            throw std::invalid_argument(
                "the squares of a lattice's stabilisation need weights >= 0");
        }
        if (weight == 0) {
            continue;
        }
        std::vector<double> stencil;
        detail::for_each_integer(square.stencil, [&](std::size_t, std::string_view entry) {
            stencil.push_back(evaluate(RationalFunction{entry, square.divisor}, 0));
        });
        lattice.energy.push_back({square.part, weight, std::move(stencil)});
    }
    return lattice;
}

/// The lattice of a condition. Throws as above, and for another G than the table was made for.
inline Lattice make_lattice(const MatchingTable& table, double G) {
    detail::require_own_G(table, G);
    return make_lattice(*table.lattice, G);
}

namespace detail {

/// stencil[0] + 2 sum_{m >= 1} stencil[m] cos(m xi).
inline double symbol_at(std::span<const double> stencil, double xi) {
    double sum = stencil[0];
    for (std::size_t m = 1; m < stencil.size(); ++m) {
        sum += 2 * stencil[m] * std::cos(static_cast<double>(m) * xi);
    }
    return sum;
}

/// The largest value on the band of a smooth function of xi made of a lattice's symbols, by
/// sampling and golden-section search around the best sample.
template <class Function>
double maximum_on_band(const Lattice& lattice, Function value) {
    // A trigonometric polynomial of degree r has at most r maxima in (0, pi); 64 samples to each
    // leave one between the neighbours of the best sample.
    const std::size_t samples = 64 * lattice.reach();
    const double step = std::numbers::pi / static_cast<double>(samples);
    std::size_t best = 0;
    for (std::size_t i = 1; i <= samples; ++i) {
        if (value(static_cast<double>(i) * step) > value(static_cast<double>(best) * step)) {
            best = i;
        }
    }
    double low = (static_cast<double>(best) - 1) * step;
    double high = (static_cast<double>(best) + 1) * step;
    // 48 steps shrink the bracket below the point where the value can tell its ends apart. They are
    // not Boost's brent_find_minima, since who includes this header needs no library.
    for (int i = 0; i < 48; ++i) {
        const double inset = (high - low) * (1 - 1 / std::numbers::phi);
        if (value(low + inset) > value(high - inset)) {
            high -= inset;
        } else {
            low += inset;
        }
    }
    return value((low + high) / 2);
}

}  // namespace detail

/// omega^2 [c^2/dX^2] at wave number xi [1/dX], without damping.
inline double omega_squared(const Lattice& lattice, double xi) {
    return detail::symbol_at(lattice.symbol, xi);
}

/// d(omega^2)/d(xi) [c^2/dX^2 per 1/dX], analytic, without damping; 2 omega times the group
/// velocity.
inline double omega_squared_slope(const Lattice& lattice, double xi) {
    double slope = 0;
    for (std::size_t m = 1; m < lattice.symbol.size(); ++m) {
        slope -=
            2 * static_cast<double>(m) * lattice.symbol[m] * std::sin(static_cast<double>(m) * xi);
    }
    return slope;
}

/// The largest omega of the band without damping, omega_max [c/dX], in which time steps are
/// counted: cfl = dt omega_max / 2.
inline double maximum_frequency(const Lattice& lattice) {
    return std::sqrt(
        detail::maximum_on_band(lattice, [&](double xi) { return omega_squared(lattice, xi); }));
}

/// The interior's own limit of cfl: 1 without damping, less with it.
///
/// One step multiplies a wave by zeta, zeta^2 - (2 - dt^2 omega^2 - dt tau sigma) zeta +
/// (1 - dt tau sigma) = 0: both roots are within the unit circle while dt^2 omega^2 +
/// 2 dt tau sigma <= 4, which is dt <= 2/p with p = tau sigma/2 + sqrt((tau sigma/2)^2 + omega^2).
inline double interior_cfl(const Lattice& lattice) {
    if (lattice.damping.empty()) {
        return 1;
    }
    const double p = detail::maximum_on_band(lattice, [&](double xi) {
        const double half = detail::symbol_at(lattice.damping, xi) / 2;
        // At xi = 0 both are 0 up to roundings, of either sign.
        return half + std::sqrt(std::max(half * half + omega_squared(lattice, xi), 0.0));
    });
    return maximum_frequency(lattice) / p;
}

/// The largest time step [spacing/wave_speed] with which a chain between an end of this table and
/// the opposite one is certified to be stable, midpoint ghosts (shorter ones are, too, unless
/// certified_steps() has a `from`), from table.least_nodes nodes on. Of a table that is matched in
/// time steps it is that step. Throws NotCertified where there is none, as at the very edge of some
/// windows, and std::invalid_argument for a bad G, and where wave_speed or spacing is not positive
/// and finite.
inline double stable_time_step(const MatchingTable& table, double G, double wave_speed,
                               double spacing, Opposite opposite = Opposite::like) {
    detail::require_possible(G);
    for (const double value : {wave_speed, spacing}) {
        if (!(value > 0) || !std::isfinite(value)) {
            throw std::invalid_argument("wave speed and spacing must be positive and finite");
        }
    }
    const double cfl = certified_cfl(table, G, opposite);
    if (cfl == 0) {
        const bool like = opposite == Opposite::like;
        throw NotCertified(std::string(table.name) + " is certified for no time step at G = " +
                           detail::to_text(G) + (like ? "; " : " opposite any end; ") +
                           certified_choices(table, G, {}, opposite));
    }
    const double largest = 2 * cfl / maximum_frequency(make_lattice(table, G));
    const double matched = detail::nearest_to_fraction(table.time_step);
    return (matched > 0 ? matched : largest) * spacing / wave_speed;
}

/// Accelerations of the interior nodes, a_I = -(c/dX)^2 sum_m symbol[|m|] u_{I+m}.
/// u: all nodes, `reach` ghosts first and last; a: the same length, ghost entries untouched.
/// stiffness: (c/dX)^2 = E/(rho dX^2) [1/time^2].
template <class Real = double>
void accelerations(const Lattice& lattice, double stiffness,
                   std::type_identity_t<std::span<const Real>> u,
                   std::type_identity_t<std::span<Real>> a) {
    const std::size_t reach = lattice.reach();
    for (std::size_t node = reach; node + reach < u.size(); ++node) {
        double sum = lattice.symbol[0] * u[node];
        for (std::size_t m = 1; m <= reach; ++m) {
            sum += lattice.symbol[m] * (u[node + m] + u[node - m]);
        }
        a[node] = static_cast<Real>(-stiffness * sum);
    }
}

/// Decelerations of the interior nodes by the damping, d_I = (c/dX) sum_m damping[|m|] v_{I+m}.
/// The lattice is damped. v: all nodes, `reach` ghosts first and last; d: the same length, ghost
/// entries untouched. rate: c/dX [1/time].
template <class Real = double>
void decelerations(const Lattice& lattice, double rate,
                   std::type_identity_t<std::span<const Real>> v,
                   std::type_identity_t<std::span<Real>> d) {
    const std::size_t reach = lattice.damping.size() - 1;
    for (std::size_t node = reach; node + reach < v.size(); ++node) {
        double sum = lattice.damping[0] * v[node];
        for (std::size_t m = 1; m <= reach; ++m) {
            sum += lattice.damping[m] * (v[node + m] + v[node - m]);
        }
        d[node] = static_cast<Real>(rate * sum);
    }
}

}  // namespace nmbc
