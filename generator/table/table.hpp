// SPDX-License-Identifier: MIT
/// What the generator hands from stage to stage and finally to an emitter: plain exact data.
/// Units throughout: dX = 1 and c = sqrt(E/rho) = 1; omega and b_j are in c/dX.
#pragma once

#include <algorithm>
#include <nmbc/table.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/table/certificate.hpp"

namespace nmbcgen {

using nmbc::EnergyPart;

/// A wave number xi > 0 at which s(xi) C(z) - B(z) and its derivatives below multiplicity vanish.
struct MatchingPoint {
    Rational wave_number;  ///< xi in 1/dX; of_pi: in pi/dX
    bool of_pi = false;
    unsigned multiplicity = 1;

    friend bool operator==(const MatchingPoint&, const MatchingPoint&) = default;
};

/// The highest order, horizon or stride that is asked for or read.
inline constexpr unsigned highest_count = 100;

/// Which table: the request as a person makes it.
struct Specification {
    std::string family = "nopd1d";
    unsigned horizon = 1;
    unsigned order = 1;
    unsigned stride = 1;
    std::optional<Rational> stabilisation;  ///< G; none: G stays symbolic.
    Rational damping = 0;                   ///< tau >= 0 [c/dX]
    Rational time_step = 0;  ///< dt [dX/c] of leapfrog it is matched in; 0: continuous time
    std::vector<MatchingPoint> points{};  ///< ascending, at a fixed G only
    std::vector<Rational> weights{};  ///< of the influence, w_1 = 1, w_2 .. w_n; empty: constant
};

/// The rows k = 0, 1, .. of (49) that hold at xi = 0: what the matching points leave of 2N + 1.
inline unsigned rows_at_zero(const Specification& specification) {
    unsigned rows = 2 * specification.order + 1;
    for (const MatchingPoint& point : specification.points) {
        rows -= 2 * point.multiplicity;
    }
    return rows;
}

/// One square of a lattice model's potential energy density,
///     (1/2) weight(G) * (sum_i stencil[i] u_{I + i - reach})^2   at node I,
/// where stencil has 2*reach + 1 entries.
struct ExactSquare {
    EnergyPart part;
    Polynomial weight;
    std::vector<Rational> stencil;
};

/// A lattice model at one horizon: its energy, and the symbol that follows from it,
///     omega^2 = symbol[0] + sum_{m >= 1} symbol[m] (z^m + z^-m),   z = exp(i xi).
/// Damping is viscous, of the velocities' own stabilisation energy at G = 1, so that long waves
/// hardly feel it: with tau sigma = damping[0] + sum damping[m] (z^m + z^-m), waves exp(s t) obey
///     s^2 + tau sigma s + omega^2 = 0.
struct Model {
    std::string description;
    std::string source;  ///< the equations the model is taken from
    std::vector<ExactSquare> energy;
    std::vector<Polynomial> symbol;
    std::vector<Rational> damping{};  ///< of tau sigma [c/dX], m = 0 .. reach; empty where tau = 0
};

/// Whether G changes the model at all.
inline bool has_stabilisation(const Model& model) {
    return std::ranges::any_of(model.energy, [](const ExactSquare& square) {
        return square.part == EnergyPart::stabilisation;
    });
}

/// What a condition is as a side of the plane, at the table's G.
struct PlaneGrade {
    std::string grade;    ///< "contractive" or "paired"
    std::string samples;  ///< on which: a clause
    /// In leapfrog steps up to this part of the longest one that the lattice is stable in.
    double steps = 0;
    /// Opposite which sides strips grow: "fixed", "free".
    std::vector<std::string> grows_opposite{};
};

/// A matching boundary condition with everything it was derived from.
struct Table {
    Specification specification;
    Model model;                     ///< at every G, also where the table's is fixed
    std::vector<Polynomial> taylor;  ///< a_1 .. a_{2N+1} of s = sum a_k (i xi)^k, (47); s = i omega
                                     ///< where nothing is damped, in continuous time
    std::vector<ExactFunction> c;    ///< c_0 .. c_N, c_0 = 1
    std::vector<ExactFunction> b;    ///< b_0 .. b_N
    unsigned digits = 0;  ///< that c and b are rounded to where there are points; 0: exact
    std::string source;   ///< the equations the table is taken from
    std::string proved;   ///< what prove() established about it
    std::optional<Certificate> certificate;  ///< where it is stable; none before certify()
    std::optional<PlaneGrade> in_plane{};    ///< of a wave of a plane, where it was looked for
};

}  // namespace nmbcgen
